// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace poinsot::reference {

/// Columns of a log, recognised by their names in kTrajectoryColumns. Columns with other names are ignored.
class GradeColumns {
 public:
  static constexpr std::size_t kForeign = static_cast<std::size_t>(-1);

  GradeColumns() = default;
  explicit GradeColumns(const std::vector<std::string>& names);

  bool empty() const { return all_.empty(); }
  std::size_t size() const { return all_.size(); }
  /// Returns the index in kTrajectoryColumns of the log's column number i, or kForeign.
  std::size_t operator[](std::size_t i) const { return all_[i]; }
  const std::vector<std::size_t>& known() const { return known_; }

  /// Returns the position of the first name that occurs a second time. Returns nullopt if no name is repeated.
  std::optional<std::size_t> repeated() const;
  bool hasTime() const { return timeAt().has_value(); }
  std::optional<std::size_t> timeAt() const;
  /// Returns "; if 'Time [s]' is the time, name it t" if a name probably means the time. Otherwise, the text is
  /// empty.
  std::string timeHint() const;
  /// Returns why the log cannot be graded: a vector lacks a component, or both attitude and angular velocity are
  /// missing. Does not check for the time. Returns an empty text if nothing is missing.
  std::string lack() const;

  /// Returns the index in kTrajectoryColumns of a column name, or kForeign.
  static std::size_t columnNamed(std::string_view name);

 private:
  bool has(std::size_t column) const;
  std::string foreignText() const;

  std::vector<std::string> names_;
  std::vector<std::size_t> all_, known_;
};

}  // namespace poinsot::reference
