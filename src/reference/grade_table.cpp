// SPDX-License-Identifier: Apache-2.0
#include "reference/grade_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "core/expect.h"
#include "core/file_error.h"
#include "core/number.h"
#include "core/regular_file.h"
#include "core/text.h"
#include "reference/grade_columns.h"

namespace poinsot::reference {
namespace {

constexpr std::ptrdiff_t kFewestNames = 2;  // known column names that make a comment a header

struct Field {
  std::string_view text;
  int column = 1;  ///< position of the first byte in the line, from 1
};

constexpr std::string_view kBlanks = " \t\r";

/// Returns the end of the field that starts at `from`: the next separator outside quotes, or the end of the line.
std::size_t endOfField(std::string_view line, std::size_t from, std::string_view separators) {
  bool quoted = false;
  for (std::size_t i = from; i < line.size(); ++i) {
    if (line[i] == '"') quoted = !quoted;
    if (!quoted && separators.find(line[i]) != std::string_view::npos) return i;
  }
  return line.size();
}

/// Splits a line at commas, or at spaces and tabs if there are no commas. numpy.savetxt writes spaces between
/// numbers, but users may write commas in its header.
void splitFields(std::string_view line, std::vector<Field>& fields, std::size_t start = 0) {
  fields.clear();
  const bool commas = endOfField(line, start, ",") < line.size();
  for (std::size_t from = start; from <= line.size();) {
    if (!commas) from = std::min(line.find_first_not_of(kBlanks, from), line.size());
    const std::size_t end = endOfField(line, from, commas ? "," : kBlanks);
    std::string_view text = core::trimmed(line.substr(from, end - from));
    const auto column = text.empty() ? from : static_cast<std::size_t>(text.data() - line.data());
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
    if (commas || from < line.size()) fields.push_back({text, static_cast<int>(column) + 1});
    from = end + 1;
  }
}

struct Cursor {
  std::string_view rest;  ///< lines that have not been read yet
  std::string_view line;
  int number = 0;
};

class Reader {
 public:
  Reader(std::string_view csv, const std::string& fileName) : cursor_{csv, {}, 0}, fileName_(fileName) {}

  TrajectoryTable table() {
    readHeader();
    TrajectoryTable table(columns_.known(), core::printable(fileName_));
    while (nextLine()) {
      if (table.rows() == kMostTableRows) refuse(fmt::format("more than {} rows", kMostTableRows));
      readRow();
      table.append(row_, {cursor_.number, timeColumn()});
    }
    if (table.rows() == 0) fail("has a header and no rows");
    return table;
  }

 private:
  [[noreturn]] void fail(const std::string& what, int line = 0, int column = 0) const {
    throw core::Error(core::ErrorKind::kIo, what, core::SourceLocation{core::printable(fileName_), line, column});
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw core::Error(core::ErrorKind::kLimit, what,
                      core::SourceLocation{core::printable(fileName_), cursor_.number, 0});
  }

  /// Moves to the next line that is neither blank nor a comment. Before the header is found, also searches
  /// comments for column names.
  bool nextLine() {
    while (!cursor_.rest.empty()) {
      std::string_view& line = cursor_.line;
      line = cursor_.rest.substr(0, cursor_.rest.find('\n'));
      cursor_.rest.remove_prefix(std::min(line.size() + 1, cursor_.rest.size()));
      if (++cursor_.number == 1 && line.starts_with("\xef\xbb\xbf")) line.remove_prefix(3);
      if (line.size() > kLongestTableLine) refuse(fmt::format("a line of more than {} bytes", kLongestTableLine));
      const std::string_view text = core::trimmed(line);
      if (text.empty()) continue;
      if (text.front() != '#') return true;
      if (columns_.empty()) readComment();
    }
    return false;
  }

  /// Stores the position of the first comment with at least two known column names.
  void readComment() {
    hasComments_ = true;
    if (names_) return;
    splitFields(cursor_.line, fields_, cursor_.line.find('#') + 1);
    const auto known = [](const Field& field) {
      return GradeColumns::columnNamed(field.text) != GradeColumns::kForeign;
    };
    if (std::ranges::count_if(fields_, known) >= kFewestNames) names_ = cursor_;
  }

  /// Finds the header. This is the first line, unless it contains numbers. Then the header is a comment above, as
  /// written by numpy.savetxt.
  void findHeader() {
    const bool found = nextLine();
    if (found) splitFields(cursor_.line, fields_);
    if (found && !core::parseNumber(fields_[0].text)) return;
    if (!found && !names_) fail("is empty; expected a first line with the names of the columns");
    if (!names_) return;
    cursor_ = *names_;
    splitFields(cursor_.line, fields_, cursor_.line.find('#') + 1);
  }

  void readHeader() {
    findHeader();
    std::vector<std::string> names;
    for (const Field& field : fields_) names.emplace_back(field.text);
    columns_ = GradeColumns(names);
    if (const auto twice = columns_.repeated())
      fail(fmt::format("column {} occurs twice", names[*twice]), cursor_.number, fields_[*twice].column);
    if (!columns_.hasTime()) fail(withoutTime(), cursor_.number);
    if (const std::string lack = columns_.lack(); !lack.empty()) fail(lack, cursor_.number);
    row_.resize(columns_.known().size());
  }

  std::string withoutTime() const {
    if (std::ranges::any_of(fields_, [](const Field& f) { return f.text.find(';') != std::string_view::npos; }))
      return "columns are separated by semicolons; expected commas or blanks, and numbers with a decimal point";
    if (core::parseNumber(fields_[0].text))
      return hasComments_
                 ? "no line names the columns: this line holds numbers, and no comment above it has known names; "
                   "name them as in t,q_w,q_x,q_y,q_z,..., with or without a leading #"
                 : "the first line holds numbers; expected the names of the columns: t,q_w,q_x,q_y,q_z,...";
    const std::string meant = columns_.timeHint();
    return "no column t" +
           (meant.empty() ? "; the first line must name the columns, separated by commas or blanks" : meant);
  }

  void readRow() {
    splitFields(cursor_.line, fields_);
    if (fields_.size() != columns_.size())
      fail(fmt::format("the row has {} values, but the header has {} columns", fields_.size(), columns_.size()),
           cursor_.number);
    std::size_t next = 0;
    for (std::size_t i = 0; i < fields_.size(); ++i)
      if (columns_[i] != GradeColumns::kForeign) row_[next++] = number(fields_[i], columns_[i]);
  }

  int timeColumn() const { return fields_[columns_.timeAt().value()].column; }

  double number(const Field& field, std::size_t column) const {
    const auto value = core::parseNumber(field.text);
    const std::string_view name = kTrajectoryColumns[column].name;
    if (!value)
      fail(fmt::format("{}: '{}' is not a number", name, core::printable(field.text)), cursor_.number,
           field.column);
    if (column == kTimeAt && !std::isfinite(*value))
      fail(fmt::format("t: {} is not a finite number", *value), cursor_.number, field.column);
    return *value;
  }

  Cursor cursor_;
  std::optional<Cursor> names_;  // position of the comment with the column names
  bool hasComments_ = false;
  std::string fileName_;
  std::vector<Field> fields_;
  GradeColumns columns_;
  std::vector<double> row_;
};

}  // namespace

TrajectoryTable::TrajectoryTable(const std::vector<std::size_t>& columns, std::string fileName)
    : width_(columns.size()), fileName_(std::move(fileName)) {
  stored_.fill(kAbsent);
  for (std::size_t i = 0; i < columns.size(); ++i) stored_[columns[i]] = i;
}

void TrajectoryTable::append(const std::vector<double>& values, const Place& ofTime) {
  POINSOT_EXPECT(values.size() == width_);
  values_.insert(values_.end(), values.begin(), values.end());
  timePlaces_.push_back(ofTime);
}

TrajectoryTable parseTrajectoryTable(std::string_view csv, const std::string& fileName) {
  return Reader(csv, fileName).table();
}

TrajectoryTable trajectoryTableOf(const std::vector<NamedColumn>& named) {
  const auto refuse = [](core::ErrorKind kind, const std::string& what) { throw core::Error(kind, what); };
  std::vector<std::string> names;
  for (const NamedColumn& one : named) names.push_back(one.name);
  const GradeColumns columns(names);
  if (const auto twice = columns.repeated())
    refuse(core::ErrorKind::kUsage, fmt::format("column {} occurs twice", names[*twice]));
  if (!columns.hasTime()) refuse(core::ErrorKind::kUsage, "no column t" + columns.timeHint());
  if (const std::string lack = columns.lack(); !lack.empty()) refuse(core::ErrorKind::kUsage, lack);

  const std::span<const double> times_s = named[*columns.timeAt()].values;
  if (times_s.empty()) refuse(core::ErrorKind::kUsage, "no rows");
  if (times_s.size() > kMostTableRows)
    refuse(core::ErrorKind::kLimit, fmt::format("{} rows; at most {} are graded", times_s.size(), kMostTableRows));
  std::vector<std::span<const double>> known;
  for (std::size_t i = 0; i < named.size(); ++i) {
    if (columns[i] == GradeColumns::kForeign) continue;
    known.push_back(named[i].values);
    if (known.back().size() != times_s.size())
      refuse(core::ErrorKind::kUsage,
             fmt::format("{} has {} rows, t has {}", names[i], known.back().size(), times_s.size()));
  }

  TrajectoryTable table(columns.known(), "");
  std::vector<double> row(known.size());
  for (std::size_t k = 0; k < times_s.size(); ++k) {
    if (!std::isfinite(times_s[k]))
      refuse(core::ErrorKind::kUsage, fmt::format("t[{}]: {} is not a finite number", k, times_s[k]));
    for (std::size_t i = 0; i < known.size(); ++i) row[i] = known[i][k];
    table.append(row, {});
  }
  return table;
}

TrajectoryTable readTrajectoryTable(const std::string& fileName) {
  const core::SourceLocation place{core::printable(fileName), 0, 0};
  std::string csv;
  try {
    csv = core::bytesOf(core::openForReading(fileName), kMostTableBytes, core::ErrorKind::kIo);
  } catch (const core::Error& error) {
    throw core::FileError(core::ErrorKind::kIo, "cannot be read: " + error.message(), fileName,
                          core::codeOf(error), place);
  }
  if (csv.size() > kMostTableBytes)
    throw core::Error(core::ErrorKind::kLimit,
                      fmt::format("is larger than {} MiB, the largest size that is read", kMostTableBytes >> 20),
                      place);
  return parseTrajectoryTable(csv, fileName);
}

}  // namespace poinsot::reference
