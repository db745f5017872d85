// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "physics/motion.h"
#include "reference/trajectory_times.h"

namespace poinsot::reference {

enum class TrajectoryFormat {
  kCsv,   ///< a header with the names of the columns, then a line per time; nothing else
  kJson,  ///< an object: format, scene, units, axes, columns, rows
};

/// First line of a trajectory in CSV, without its newline. @param alpha  energy loss of the motion, s/(kg·m²).
std::string trajectoryHeader(double alpha = 0);

/// First bytes of every trajectory in this format: what tells an earlier output from somebody's file.
std::string trajectoryMark(TrajectoryFormat format);

/// Takes the text, a piece after the other.
using TextSink = std::function<void(std::string_view)>;

/// Writes the motion at these times; in memory there is never more than one piece (64 kB). Numbers are the
/// shortest decimals that read back as the same doubles.
/// @throws core::Error(kLimit) for a time so far that the phase of the motion has no double; process::Interrupted
void writeTrajectory(const physics::Motion& motion, const TrajectoryTimes& times, TrajectoryFormat format,
                     const std::string& sceneName, const TextSink& sink);

struct TrajectoryColumn {
  std::string_view name, unit;
};

/// Columns of a trajectory, in this order: t; q takes components along the body's axes B, as the scene gives them,
/// to components along the inertial axes W; angular velocity I^-1 m in both; angular momentum; energy of rotation;
/// last, only where dissipation makes it another vector than omega, the rate at which the attitude turns, in both.
inline constexpr std::array<TrajectoryColumn, 21> kTrajectoryColumns{{{"t", "s"},
                                                                      {"q_w", "1"},
                                                                      {"q_x", "1"},
                                                                      {"q_y", "1"},
                                                                      {"q_z", "1"},
                                                                      {"omega_B_x", "rad/s"},
                                                                      {"omega_B_y", "rad/s"},
                                                                      {"omega_B_z", "rad/s"},
                                                                      {"omega_W_x", "rad/s"},
                                                                      {"omega_W_y", "rad/s"},
                                                                      {"omega_W_z", "rad/s"},
                                                                      {"L_W_x", "kg m^2/s"},
                                                                      {"L_W_y", "kg m^2/s"},
                                                                      {"L_W_z", "kg m^2/s"},
                                                                      {"T", "J"},
                                                                      {"rate_B_x", "rad/s"},
                                                                      {"rate_B_y", "rad/s"},
                                                                      {"rate_B_z", "rad/s"},
                                                                      {"rate_W_x", "rad/s"},
                                                                      {"rate_W_y", "rad/s"},
                                                                      {"rate_W_z", "rad/s"}}};

/// Where in a row each quantity begins.
enum TrajectoryPlace : std::size_t {
  kTimeAt = 0,
  kQAt = 1,
  kOmegaBAt = 5,
  kOmegaWAt = 8,
  kLWAt = 11,
  kEnergyAt = 14,
  kRateBAt = 15,
  kRateWAt = 18
};

using TrajectoryRow = std::array<double, kTrajectoryColumns.size()>;

TrajectoryRow trajectoryRow(const physics::Motion& motion, const physics::RigidBodyState& state);

/// Columns that a trajectory has: without the rate of turning where alpha, the energy loss, is 0 and the rate is
/// omega itself.
constexpr std::span<const TrajectoryColumn> trajectoryColumns(double alpha) {
  return std::span(kTrajectoryColumns).first(alpha > 0 ? kTrajectoryColumns.size() : std::size_t{kRateBAt});
}

}  // namespace poinsot::reference
