// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scene/keys/leaves.h"

namespace poinsot::scene {

/// Values that the user gave, valid or not, and reports on them. A problem is reported at its value. If the value
/// is missing, it is reported at the table, or at the start of the file.
class Findings {
 public:
  /// @param refused  paths of values that failed their own checks
  Findings(const Leaves& given, const std::set<std::string, std::less<>>& refused, const Place& file,
           Problems& problems)
      : given_(given), refused_(refused), file_(file), problems_(problems) {}

  /// Returns whether no problem is reported so far.
  bool none() const { return problems_.empty(); }
  const Limits& limits() const { return given_.limits; }
  bool has(std::string_view path) const { return given_.values.contains(path); }
  /// Returns whether the value is given and failed its own check. The failure is already reported.
  bool failed(std::string_view path) const { return refused_.contains(path); }
  bool hasBelow(std::string_view table) const;
  /// Returns whether the file contains the table, even without keys.
  bool hasTable(std::string_view table) const;
  /// Returns whether an unknown name of the scene stands for a key of the table, such as "m" for body.mass.
  bool isMeantBelow(std::string_view table) const;
  /// Returns whether an unknown name stands for this path: a name of a textbook, or a misspelling in the path's
  /// table. Unknown names are already reported.
  bool misspelt(std::string_view path) const;
  /// Returns whether a value is unreliable, because the value was rejected or because its key or its table is
  /// probably misspelt. The mistake is already reported.
  bool isUnsure(std::string_view path) const;
  /// Returns a given value as TOML; empty if the scene does not give it.
  std::string textOf(std::string_view path) const;
  const Leaves& leaves() const { return given_; }
  std::size_t count(std::string_view array) const { return given_.count(array); }

  /// Reports the problem "path: message" at the position of the path. Reports nothing if a syntax error left out
  /// lines on which the problem may depend.
  void refuse(std::string_view path, std::string_view message);
  /// Reports the problem "path: message" because the key `missing` is not given. Reports nothing if the file
  /// contains a probable misspelling of `missing`.
  void refuseMissing(std::string_view missing, std::string_view path, std::string_view message);
  /// Reports that the file lacks a required table. Reports nothing if the file contains unknown names, because one
  /// of them may be a misspelling of the table.
  void refuseEmpty(std::string message);
  void refuseFile(std::string message);
  /// Adds the note "path: message" about a valid value that is probably a mistake.
  void doubt(std::string_view path, std::string_view message);
  std::vector<Doubt> doubts() const;

 private:
  Place placeOf(std::string_view path) const;
  /// Returns whether a check of several keys at a path may depend on lines with a syntax error. The body depends
  /// on [body], its motion also on [motion] and on what is shown, everything else on the whole scene.
  bool isBroken(std::string_view path) const;

  const Leaves& given_;
  const std::set<std::string, std::less<>>& refused_;
  Place file_;
  Problems& problems_;
  std::vector<Doubt> doubts_;
};

}  // namespace poinsot::scene
