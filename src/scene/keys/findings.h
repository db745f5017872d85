// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scene/keys/leaves.h"

namespace poinsot::scene {

/// What the user gave, valid or not, and where to say what is wrong with it: at the value; at its table where the
/// value is missing; else at the file's start.
class Findings {
 public:
  /// `refused`: the paths whose values did not pass their own checks.
  Findings(const Leaves& given, const std::set<std::string, std::less<>>& refused, const Place& file,
           Problems& problems)
      : given_(given), refused_(refused), file_(file), problems_(problems) {}

  const Limits& limits() const { return given_.limits; }
  bool has(std::string_view path) const { return given_.values.contains(path); }
  /// Whether it is given and did not pass its own check, which was reported then.
  bool failed(std::string_view path) const { return refused_.contains(path); }
  /// Whether some key of the table is given.
  bool hasBelow(std::string_view table) const;
  /// Whether the table stands in the file, with keys or without.
  bool hasTable(std::string_view table) const;
  /// Whether a name was given in its place that is spelled like it and is no key, which is reported anyway.
  bool misspelt(std::string_view path) const;
  /// Whether what stands in its place is reported anyway, and is not what was meant: refused, misspelt, or in a
  /// table whose name is.
  bool isUnsure(std::string_view path) const;
  std::size_t count(std::string_view array) const { return given_.count(array); }

  /// "path: message", at the path.
  void refuse(std::string_view path, std::string_view message);
  /// What `refuse` does, of a path that is missing; nothing where it is there but misspelt.
  void refuseMissing(std::string_view missing, std::string_view path, std::string_view message);
  /// The same about a file that gives nothing it must; nothing where it has names that are no keys.
  void refuseEmpty(std::string message);
  /// The same about the whole file.
  void refuseFile(std::string message);
  /// "path: message" about a value that is allowed and may still be a slip.
  void doubt(std::string_view path, std::string_view message);
  /// All of them, in the order of the file.
  std::vector<Doubt> doubts() const;

 private:
  Place placeOf(std::string_view path) const;

  const Leaves& given_;
  const std::set<std::string, std::less<>>& refused_;
  Place file_;
  Problems& problems_;
  std::vector<Doubt> doubts_;
};

}  // namespace poinsot::scene
