// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace poinsot::reference {

/// Columns of somebody's trajectory: which of kTrajectoryColumns they are, by their names. Names that are none of
/// these are foreign, and ignored.
class GradeColumns {
 public:
  static constexpr std::size_t kForeign = static_cast<std::size_t>(-1);

  GradeColumns() = default;
  explicit GradeColumns(const std::vector<std::string>& names);

  bool empty() const { return all_.empty(); }
  std::size_t size() const { return all_.size(); }
  /// Column of kTrajectoryColumns that the i-th name means, or kForeign.
  std::size_t operator[](std::size_t i) const { return all_[i]; }
  /// Columns that are not foreign, in the order of their names.
  const std::vector<std::size_t>& known() const { return known_; }

  /// Number of the first name that is there for the second time.
  std::optional<std::size_t> repeated() const;
  bool hasTime() const { return timeAt().has_value(); }
  /// Number of the name of the time.
  std::optional<std::size_t> timeAt() const;
  /// "; is it 'Time [s]'?": a name that looks like one of the time; empty where none does.
  std::string timeHint() const;
  /// Returns why nothing can be graded besides a missing time: a vector without a component, or neither attitude
  /// nor angular velocity. Empty where all is there.
  std::string lack() const;

  /// Column of kTrajectoryColumns with this name, or kForeign.
  static std::size_t columnNamed(std::string_view name);

 private:
  bool has(std::size_t column) const;
  std::string foreignText() const;

  std::vector<std::string> names_;
  std::vector<std::size_t> all_, known_;
};

}  // namespace poinsot::reference
