// SPDX-License-Identifier: Apache-2.0
#include "scene/assembly/torque_table.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "core/number.h"
#include "core/text.h"
#include "scene/limits.h"

namespace poinsot::scene {
namespace {

constexpr std::string_view kHeader = "t,Nx,Ny,Nz";
// Enough for more than a second at the sampling rate of audio. Each interval between lines is integrated
// separately.
constexpr std::size_t kMostRows = 100'000;

std::optional<double> number(std::string_view text) {
  const auto value = core::parseNumber(core::trimmed(text));
  return value && std::isfinite(*value) ? value : std::nullopt;
}

/// Returns the text up to the next separator. Removes this text and the separator from the start of `text`.
std::string_view take(std::string_view& text, char separator) {
  const std::size_t end = text.find(separator);
  const std::string_view taken = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return taken;
}

class TableReader {
 public:
  explicit TableReader(bool linear) { history_.linear = linear; }

  physics::TorqueHistory operator()(std::string_view csv) {
    if (csv.starts_with("\xef\xbb\xbf")) csv.remove_prefix(3);
    while (!csv.empty()) {
      ++line_;
      read(core::trimmed(take(csv, '\n')));
    }
    if (history_.empty()) throw core::sceneError("the table has no rows of numbers t,Nx,Ny,Nz");
    return std::move(history_);
  }

 private:
  void read(std::string_view line) {
    if (line_ == 1 && line == kHeader) return;
    std::array<double, 4> row{};
    std::string_view rest = line;
    for (double& value : row) value = cell(rest, line);
    if (!rest.empty() || line.ends_with(',')) expected(line);
    add(row);
  }

  double cell(std::string_view& rest, std::string_view line) const {
    const auto value = number(take(rest, ','));
    if (!value) expected(line);
    return *value;
  }

  [[noreturn]] void expected(std::string_view line) const {
    throw core::sceneError(
        fmt::format("line {}: expected four numbers {}, got \"{}\"", line_, kHeader, core::printable(line)));
  }

  void add(const std::array<double, 4>& row) {
    if (!history_.empty() && !(row[0] > history_.t_s.back()))
      throw core::sceneError(
          fmt::format("line {}: times must ascend, got {} after {}", line_, row[0], history_.t_s.back()));
    for (std::size_t i = 0; i < row.size(); ++i)
      if (const double most = i == 0 ? kMostInstant_s : kMostTorque; std::abs(row[i]) > most)
        throw core::sceneError(
            fmt::format("line {}: absolute values must be at most {:g}, got {}", line_, most, row[i]));
    if (history_.t_s.size() == kMostRows)
      throw core::sceneError(fmt::format("line {}: a table may have at most {} lines", line_, kMostRows));
    history_.t_s.push_back(row[0]);
    history_.torque.emplace_back(row[1], row[2], row[3]);
  }

  physics::TorqueHistory history_;
  int line_ = 0;
};

}  // namespace

physics::TorqueHistory parseTorqueTable(std::string_view csv, bool linear) { return TableReader(linear)(csv); }

}  // namespace poinsot::scene
