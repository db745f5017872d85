// SPDX-License-Identifier: Apache-2.0
#include "reference/trajectory.h"

#include <fmt/format.h>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "core/number.h"
#include "process/interrupt.h"

namespace poinsot::reference {

namespace {

constexpr std::size_t kPiece = 1 << 16;     // the capacity of a pipe
constexpr std::size_t kLongestNumber = 32;  // bytes of a number with its comma, rounded up

constexpr const char* kJsonFormat = "poinsot trajectory 1";
constexpr const char* kAxes =
    "q takes components along the body's axes B, as the scene gives them, to the inertial axes W";

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

std::string jsonHead(const std::string& sceneName, const ChosenColumns& chosen) {
  std::string columns, units;
  for (const TrajectoryColumn& column : chosen.columns()) {
    columns += fmt::format("{}\"{}\"", columns.empty() ? "" : ",", column.name);
    units += fmt::format("{}\"{}\":\"{}\"", units.empty() ? "" : ",", column.name, column.unit);
  }
  return fmt::format("{},\n\"scene\":{},\n\"axes\":\"{}\",\n\"units\":{{{}}},\n\"columns\":[{}],\n\"rows\":[",
                     trajectoryMark(TrajectoryFormat::kJson), quoted(sceneName), kAxes, units, columns);
}

void appendNumbers(std::string& text, std::span<const double> row, std::string_view missing) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (i > 0) text += ',';
    if (std::isnan(row[i]))
      text += missing;
    else
      core::appendNumber(text, row[i]);
  }
}

}  // namespace

std::string trajectoryMark(TrajectoryFormat format) {
  return format == TrajectoryFormat::kCsv ? ChosenColumns(0).header()
                                          : fmt::format("{{\"format\":\"{}\"", kJsonFormat);
}

void writeTrajectory(const physics::Motion& motion, const ChosenColumns& columns, const TrajectoryTimes& times,
                     TrajectoryFormat format, const std::string& sceneName, const TextSink& sink) {
  const bool json = format == TrajectoryFormat::kJson;
  std::string piece = json ? jsonHead(sceneName, columns) : columns.header() + '\n';
  piece.reserve(kPiece + kLongestNumber * columns.columns().size());
  std::vector<double> row;
  for (std::int64_t k = 0; k < times.count(); ++k) {
    if (json) piece += k == 0 ? "\n[" : ",\n[";
    columns.evaluate(motion, motion.at(times[k]), row);
    appendNumbers(piece, row, json ? "null" : "nan");
    piece += json ? ']' : '\n';
    if (piece.size() < kPiece) continue;
    process::throwIfInterrupted();
    sink(piece);
    piece.clear();
  }
  if (json) piece += "\n]}\n";
  sink(piece);
}

}  // namespace poinsot::reference
