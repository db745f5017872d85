// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "reference/trajectory.h"

namespace poinsot::reference {

/// Logged trajectory, with a subset of the columns kTrajectoryColumns.
class TrajectoryTable {
 public:
  TrajectoryTable(const std::vector<std::size_t>& columns, std::string fileName);

  /// Returns whether the table has the column with the index `place` in kTrajectoryColumns.
  bool has(TrajectoryPlace place) const { return stored_[place] != kAbsent; }
  std::size_t rows() const { return values_.size() / width_; }
  double at(std::size_t row, std::size_t column) const { return values_[row * width_ + stored_[column]]; }
  double t_s(std::size_t row) const { return at(row, kTimeAt); }
  /// Returns the position in the file from which the time of a row was read, for messages.
  core::SourceLocation placeOfTime(std::size_t row) const {
    if (fileName_.empty()) return {"t[" + std::to_string(row) + "]"};  // table from memory, without a file
    return {fileName_, timePlaces_[row].line, timePlaces_[row].column};
  }

  struct Place {
    int line = 0, column = 0;
  };
  /// Adds a row of values, in the order of the columns given to the constructor. @pre as many values as columns
  void append(const std::vector<double>& values, const Place& ofTime);

 private:
  static constexpr std::size_t kAbsent = static_cast<std::size_t>(-1);

  std::size_t width_;
  std::array<std::size_t, kTrajectoryColumns.size()> stored_;  // index of each column within a row of values_
  std::vector<double> values_;
  std::string fileName_;
  std::vector<Place> timePlaces_;
};

/// Size limits of a table file, enough for two hours at 500 rows per second, with all columns and 17 digits.
inline constexpr std::size_t kMostTableBytes = std::size_t{1} << 30;
inline constexpr std::size_t kMostTableRows = 4'000'000;
inline constexpr std::size_t kLongestTableLine = std::size_t{64} << 10;

/// Parses a table whose header contains columns of kTrajectoryColumns, in any order. Other columns are ignored.
/// The table must have t, and at least one of q, omega_B and omega_W. Each vector must have all its components.
///
/// The header is the first line. If that line contains numbers, the header is the first comment above with at
/// least two known names (numpy.savetxt). Fields are separated by commas, or by spaces and tabs if a line has no
/// comma. Blank lines, spaces around a field, "quoted" fields, a byte order mark, CRLF and lines that start with #
/// are allowed. Values may be inf or nan, but times must be finite.
/// @throws core::Error(kIo) with file, line and column; core::Error(kLimit) beyond the limits above.
TrajectoryTable parseTrajectoryTable(std::string_view csv, const std::string& fileName);

/// Reads a file and parses it with parseTrajectoryTable(). @throws core::Error(kIo), also if the file cannot be
/// read.
TrajectoryTable readTrajectoryTable(const std::string& fileName);

struct NamedColumn {
  std::string name;
  std::span<const double> values;
};

/// Creates a table from columns in memory, in any order. Ignores columns with unknown names.
/// @throws core::Error(kUsage) if the columns cannot be graded or differ in length, or if a time is not finite;
/// core::Error(kLimit) for more than kMostTableRows.
TrajectoryTable trajectoryTableOf(const std::vector<NamedColumn>& columns);

}  // namespace poinsot::reference
