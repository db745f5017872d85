// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "reference/trajectory.h"

namespace poinsot::reference {

/// Logged trajectory: its columns among kTrajectoryColumns, and its rows.
class TrajectoryTable {
 public:
  TrajectoryTable(const std::vector<std::size_t>& columns, std::string fileName);

  /// Returns whether the table has the column of kTrajectoryColumns at `place`.
  bool has(TrajectoryPlace place) const { return stored_[place] != kAbsent; }
  std::size_t rows() const { return values_.size() / width_; }
  double at(std::size_t row, std::size_t column) const { return values_[row * width_ + stored_[column]]; }
  double t_s(std::size_t row) const { return at(row, kTimeAt); }
  /// Returns where the time of a row was read, for messages.
  core::SourceLocation placeOfTime(std::size_t row) const {
    if (fileName_.empty()) return {"t[" + std::to_string(row) + "]"};  // a table made in memory
    return {fileName_, timePlaces_[row].line, timePlaces_[row].column};
  }

  struct Place {
    int line = 0, column = 0;
  };
  /// Adds a row of values, in the order of the constructor's columns. @pre as many values as columns
  void append(const std::vector<double>& values, const Place& ofTime);

 private:
  static constexpr std::size_t kAbsent = static_cast<std::size_t>(-1);

  std::size_t width_;
  std::array<std::size_t, kTrajectoryColumns.size()> stored_;  // position of a column within a row of values_
  std::vector<double> values_;
  std::string fileName_;
  std::vector<Place> timePlaces_;
};

/// Limits on one file: enough for two hours at 500 rows a second, with all columns and 17 digits each.
inline constexpr std::size_t kMostTableBytes = std::size_t{1} << 30;
inline constexpr std::size_t kMostTableRows = 4'000'000;
inline constexpr std::size_t kLongestTableLine = std::size_t{64} << 10;

/// Parses a table with a header, which names columns of kTrajectoryColumns in any order. Foreign columns are
/// ignored. The table must have t, one of q, omega_B and omega_W, and all components of each vector. The header is
/// the first line or, if that holds numbers, the first comment above it that names two columns or more
/// (numpy.savetxt). Lines are split at commas or, without commas, at blanks and tabs. Blank lines, blanks around a
/// field, "quoted" fields, a byte order mark, CRLF and lines that start with # are allowed. Values may be inf or
/// nan; times must be finite.
/// @throws core::Error(kIo) with file, line and column; core::Error(kLimit) beyond the limits above.
TrajectoryTable parseTrajectoryTable(std::string_view csv, const std::string& fileName);

/// Reads and parses a regular file, like parseTrajectoryTable(). @throws core::Error(kIo) also if it cannot be
/// read.
TrajectoryTable readTrajectoryTable(const std::string& fileName);

struct NamedColumn {
  std::string name;
  std::span<const double> values;
};

/// Makes a table of columns in memory, in any order; ignores columns with foreign names.
/// @throws core::Error(kUsage) for columns that cannot be graded or differ in length, or a time that is not
/// finite; core::Error(kLimit) for more than kMostTableRows.
TrajectoryTable trajectoryTableOf(const std::vector<NamedColumn>& columns);

}  // namespace poinsot::reference
