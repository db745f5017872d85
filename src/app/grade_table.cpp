// SPDX-License-Identifier: Apache-2.0
#include "app/grade_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <system_error>

#include "app/trajectory_number.h"
#include "core/error.h"
#include "core/text.h"

namespace poinsot::app {
namespace {

constexpr std::size_t kForeign = static_cast<std::size_t>(-1);

struct Vector {
  TrajectoryPlace place;
  std::size_t length;
};

constexpr Vector kVectors[] = {{kQAt, 4}, {kOmegaBAt, 3}, {kOmegaWAt, 3}, {kLWAt, 3}};

struct Field {
  std::string_view text;
  int column = 1;  ///< of its first byte, from 1
};

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  const auto first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// Where the field that starts at `from` ends: at a comma outside quotes, or the end of the line.
std::size_t endOfField(std::string_view line, std::size_t from) {
  bool quoted = false;
  for (std::size_t i = from; i < line.size(); ++i) {
    if (line[i] == '"') quoted = !quoted;
    if (line[i] == ',' && !quoted) return i;
  }
  return line.size();
}

void splitFields(std::string_view line, std::vector<Field>& fields) {
  fields.clear();
  for (std::size_t from = 0; from <= line.size();) {
    const std::size_t end = endOfField(line, from);
    std::string_view text = trimmed(line.substr(from, end - from));
    const auto column = text.empty() ? from : static_cast<std::size_t>(text.data() - line.data());
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
    fields.push_back({text, static_cast<int>(column) + 1});
    from = end + 1;
  }
}

std::size_t columnNamed(std::string_view name) {
  const auto* found = std::ranges::find(kTrajectoryColumns, name, &TrajectoryColumn::name);
  return found == kTrajectoryColumns.end() ? kForeign
                                           : static_cast<std::size_t>(found - kTrajectoryColumns.begin());
}

/// Goes through the lines of one file.
class Reader {
 public:
  Reader(std::istream& csv, const std::string& fileName) : csv_(csv), fileName_(fileName) {}

  TrajectoryTable table() {
    readHeader();
    TrajectoryTable table(known_);
    while (nextLine()) {
      readRow();
      table.append(row_);
    }
    if (csv_.bad()) fail("cannot be read to its end");
    if (table.rows() == 0) fail("has a header and no rows");
    return table;
  }

 private:
  [[noreturn]] void fail(const std::string& what, int line = 0, int column = 0) const {
    throw core::Error(core::ErrorKind::kIo, what, core::SourceLocation{core::printable(fileName_), line, column});
  }

  /// The next line that says something.
  bool nextLine() {
    while (std::getline(csv_, line_)) {
      if (++number_ == 1 && line_.starts_with("\xef\xbb\xbf")) line_.erase(0, 3);
      const std::string_view text = trimmed(line_);
      if (!text.empty() && text.front() != '#') return true;
    }
    return false;
  }

  void readHeader() {
    if (!nextLine()) fail("is empty; its first line names the columns");
    splitFields(line_, fields_);
    for (const Field& field : fields_) {
      columns_.push_back(columnNamed(field.text));
      if (columns_.back() == kForeign) continue;
      if (has(columns_.back())) fail(fmt::format("column {} is there twice", field.text), number_, field.column);
      known_.push_back(columns_.back());
    }
    checkColumns();
    row_.resize(known_.size());
  }

  bool has(std::size_t column) const { return std::ranges::find(known_, column) != known_.end(); }

  void checkColumns() const {
    if (!has(kTimeAt)) fail("no column t; the first line names the columns, separated by commas", number_);
    for (const Vector& vector : kVectors) checkVector(vector);
    if (!has(kQAt) && !has(kOmegaBAt) && !has(kOmegaWAt))
      fail("no motion to grade: it takes q_w, q_x, q_y, q_z or omega_B_x, omega_B_y, omega_B_z", number_);
  }

  void checkVector(const Vector& vector) const {
    std::size_t count = 0, missing = 0;
    for (std::size_t i = vector.place; i < vector.place + vector.length; ++i) {
      count += has(i);
      if (!has(i)) missing = i;
    }
    if (count > 0 && count < vector.length)
      fail(fmt::format("column {} is missing beside its fellows", kTrajectoryColumns[missing].name), number_);
  }

  void readRow() {
    splitFields(line_, fields_);
    if (fields_.size() != columns_.size())
      fail(fmt::format("{} values in a row, where the header has {} columns", fields_.size(), columns_.size()),
           number_);
    std::size_t next = 0;
    for (std::size_t i = 0; i < fields_.size(); ++i)
      if (columns_[i] != kForeign) row_[next++] = number(fields_[i], columns_[i]);
  }

  double number(const Field& field, std::size_t column) const {
    const auto value = parseNumber(field.text);
    const std::string_view name = kTrajectoryColumns[column].name;
    if (!value) fail(fmt::format("{}: no number: '{}'", name, core::printable(field.text)), number_, field.column);
    if (column == kTimeAt && !std::isfinite(*value))
      fail(fmt::format("t: no time: {}", *value), number_, field.column);
    return *value;
  }

  std::istream& csv_;
  std::string fileName_;
  std::string line_;
  int number_ = 0;
  std::vector<Field> fields_;
  std::vector<std::size_t> columns_;  // of the file: which of ours, or foreign
  std::vector<std::size_t> known_;    // ours that are there, in the file's order
  std::vector<double> row_;
};

}  // namespace

TrajectoryTable::TrajectoryTable(const std::vector<std::size_t>& columns) : width_(columns.size()) {
  stored_.fill(kAbsent);
  for (std::size_t i = 0; i < columns.size(); ++i) stored_[columns[i]] = i;
}

TrajectoryTable readTrajectoryTable(std::istream& csv, const std::string& fileName) {
  return Reader(csv, fileName).table();
}

TrajectoryTable readTrajectoryTable(const std::string& fileName) {
  errno = 0;
  std::ifstream file(fileName, std::ios::binary);
  if (!file || file.peek() == std::ifstream::traits_type::eof())
    if (const int code = errno; code != 0)
      throw core::Error(core::ErrorKind::kIo,
                        fmt::format("cannot be read: {}", std::generic_category().message(code)),
                        core::SourceLocation{core::printable(fileName), 0, 0});
  file.clear();
  return readTrajectoryTable(file, fileName);
}

}  // namespace poinsot::app
