// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scene/keys/leaves.h"

namespace poinsot::scene {

/// Values that the user gave, valid or not, and the places at which to report errors: at the value; for a missing
/// value at its table; else at the start of the file.
class Findings {
 public:
  /// @param refused  paths of values that did not pass their own checks
  Findings(const Leaves& given, const std::set<std::string, std::less<>>& refused, const Place& file,
           Problems& problems)
      : given_(given), refused_(refused), file_(file), problems_(problems) {}

  const Limits& limits() const { return given_.limits; }
  bool has(std::string_view path) const { return given_.values.contains(path); }
  /// Returns whether a value is given and failed its own check, which is already reported.
  bool failed(std::string_view path) const { return refused_.contains(path); }
  bool hasBelow(std::string_view table) const;
  /// Returns whether the table is in the file, with or without keys.
  bool hasTable(std::string_view table) const;
  /// Returns whether an unknown name in the same table is spelled like the path's. That name is already reported.
  bool misspelt(std::string_view path) const;
  /// Returns whether the value given for the path is unreliable, as already reported: rejected, misspelt, or in a
  /// misspelt table.
  bool isUnsure(std::string_view path) const;
  std::size_t count(std::string_view array) const { return given_.count(array); }

  /// Reports "path: message" at the path.
  void refuse(std::string_view path, std::string_view message);
  /// Reports "path: message" at `path` because the key `missing` is not given. Reports nothing if `missing` is
  /// misspelt.
  void refuseMissing(std::string_view missing, std::string_view path, std::string_view message);
  /// Reports that the file lacks a required table. Reports nothing if the file has unknown names.
  void refuseEmpty(std::string message);
  void refuseFile(std::string message);
  /// Adds a note "path: message" about a valid value that is probably a slip.
  void doubt(std::string_view path, std::string_view message);
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
