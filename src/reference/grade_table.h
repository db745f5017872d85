// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "reference/trajectory.h"

namespace poinsot::reference {

/// Somebody's trajectory: which of kTrajectoryColumns it has, and the rows.
class TrajectoryTable {
 public:
  TrajectoryTable(const std::vector<std::size_t>& columns, std::string fileName);

  /// Whether it has `length` columns of kTrajectoryColumns from `place` on.
  bool has(TrajectoryPlace place) const { return stored_[place] != kAbsent; }
  std::size_t rows() const { return values_.size() / width_; }
  double at(std::size_t row, std::size_t column) const { return values_[row * width_ + stored_[column]]; }
  double t_s(std::size_t row) const { return at(row, kTimeAt); }
  /// Where the time of a row was read.
  core::SourceLocation placeOfTime(std::size_t row) const {
    if (fileName_.empty()) return {"t[" + std::to_string(row) + "]"};  // in memory
    return {fileName_, timePlaces_[row].line, timePlaces_[row].column};
  }

  struct Place {
    int line = 0, column = 0;
  };
  /// `values` of the columns it has, in the order they were named. @pre as many
  void append(const std::vector<double>& values, const Place& ofTime);

 private:
  static constexpr std::size_t kAbsent = static_cast<std::size_t>(-1);

  std::size_t width_;
  std::array<std::size_t, kTrajectoryColumns.size()> stored_;  // where in a row of values_
  std::vector<double> values_;
  std::string fileName_;
  std::vector<Place> timePlaces_;
};

/// Limits on one file: a run of two hours at 500 rows a second, with all columns and 17 digits each.
inline constexpr std::size_t kMostTableBytes = std::size_t{1} << 30;
inline constexpr std::size_t kMostTableRows = 4'000'000;
inline constexpr std::size_t kLongestTableLine = std::size_t{64} << 10;

/// Reads a table with a header: names of kTrajectoryColumns in any order, other columns ignored. At least t and
/// one of q, omega_B, omega_W; of a vector all components or none. The header is the first line or, where that
/// holds numbers, the first comment above it with names of two columns or more (numpy.savetxt). A line is split at
/// its commas or, where it has none, at blanks and tabs. Blank lines, blanks round a field, "quoted" fields, a
/// byte order mark, CRLF and lines that start with # are all right; values may be inf or nan, times may not.
/// @throws core::Error(kIo) with file, line and column; core::Error(kLimit) beyond the limits above.
TrajectoryTable parseTrajectoryTable(std::string_view csv, const std::string& fileName);

/// Reads a regular file as parseTrajectoryTable() does. @throws core::Error(kIo) also if it cannot be read.
TrajectoryTable readTrajectoryTable(const std::string& fileName);

/// A column in memory.
struct NamedColumn {
  std::string name;
  std::span<const double> values;
};

/// Makes a table of columns in memory, in any order; foreign names are ignored.
/// @throws core::Error(kUsage) for columns that cannot be graded, of other lengths, or a time that is not finite;
/// core::Error(kLimit) for more than kMostTableRows.
TrajectoryTable trajectoryTableOf(const std::vector<NamedColumn>& columns);

}  // namespace poinsot::reference
