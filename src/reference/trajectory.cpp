// SPDX-License-Identifier: Apache-2.0
#include "reference/trajectory.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <span>

#include "core/number.h"
#include "process/interrupt.h"

namespace poinsot::reference {

namespace {

constexpr std::size_t kPiece = 1 << 16;   // the capacity of a pipe
constexpr std::size_t kLongestRow = 660;  // bytes of the longest row, 21 numbers

constexpr const char* kJsonFormat = "poinsot trajectory 1";
constexpr const char* kAxes =
    "q takes components along the body's axes B, as the scene gives them, to the inertial axes W";

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

std::string jsonHead(const std::string& sceneName, double alpha) {
  std::string columns, units;
  for (const TrajectoryColumn& column : trajectoryColumns(alpha)) {
    columns += fmt::format("{}\"{}\"", columns.empty() ? "" : ",", column.name);
    units += fmt::format("{}\"{}\":\"{}\"", units.empty() ? "" : ",", column.name, column.unit);
  }
  return fmt::format("{},\n\"scene\":{},\n\"axes\":\"{}\",\n\"units\":{{{}}},\n\"columns\":[{}],\n\"rows\":[",
                     trajectoryMark(TrajectoryFormat::kJson), quoted(sceneName), kAxes, units, columns);
}

void appendNumbers(std::string& text, std::span<const double> row) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (i > 0) text += ',';
    core::appendNumber(text, row[i]);
  }
}

}  // namespace

std::string trajectoryHeader(double alpha) {
  std::string header;
  for (const TrajectoryColumn& column : trajectoryColumns(alpha)) {
    if (!header.empty()) header += ',';
    header += column.name;
  }
  return header;
}

std::string trajectoryMark(TrajectoryFormat format) {
  return format == TrajectoryFormat::kCsv ? trajectoryHeader() : fmt::format("{{\"format\":\"{}\"", kJsonFormat);
}

void writeTrajectory(const physics::Motion& motion, const TrajectoryTimes& times, TrajectoryFormat format,
                     const std::string& sceneName, const TextSink& sink) {
  const bool json = format == TrajectoryFormat::kJson;
  const double alpha = motion.dissipation();
  const std::size_t width = trajectoryColumns(alpha).size();
  std::string piece = json ? jsonHead(sceneName, alpha) : trajectoryHeader(alpha) + '\n';
  piece.reserve(kPiece + kLongestRow);
  for (std::int64_t k = 0; k < times.count(); ++k) {
    if (json) piece += k == 0 ? "\n[" : ",\n[";
    const TrajectoryRow row = trajectoryRow(motion, motion.at(times[k]));
    appendNumbers(piece, std::span(row).first(width));
    piece += json ? ']' : '\n';
    if (piece.size() < kPiece) continue;
    process::throwIfInterrupted();
    sink(piece);
    piece.clear();
  }
  if (json) piece += "\n]}\n";
  sink(piece);
}

TrajectoryRow trajectoryRow(const physics::Motion& motion, const physics::RigidBodyState& s) {
  const Eigen::Vector3d rate_B = physics::turningRate_B(motion, s);
  const Eigen::Vector3d rate_W = physics::turningRate_W(motion, s);
  return {s.t_s,           s.q_WB.w(),    s.q_WB.x(),    s.q_WB.y(),    s.q_WB.z(), s.omega_B.x(), s.omega_B.y(),
          s.omega_B.z(),   s.omega_W.x(), s.omega_W.y(), s.omega_W.z(), s.L_W.x(),  s.L_W.y(),     s.L_W.z(),
          s.kineticEnergy, rate_B.x(),    rate_B.y(),    rate_B.z(),    rate_W.x(), rate_W.y(),    rate_W.z()};
}

}  // namespace poinsot::reference
