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
  kCsv,   ///< header with the column names, then one line per time
  kJson,  ///< object with format, scene, units, axes, columns and rows
};

/// Returns the first line of a CSV trajectory, without newline. @param alpha  dissipation, s/(kg·m²)
std::string trajectoryHeader(double alpha = 0);

/// Returns the first bytes of every trajectory in this format, which identify an earlier output.
std::string trajectoryMark(TrajectoryFormat format);

using TextSink = std::function<void(std::string_view)>;

/// Writes the motion at the given times, in pieces of about 64 kB, so that little memory is needed. Numbers are
/// the shortest decimals that read back as the same doubles.
/// @throws core::Error(kLimit) if the phase of the motion at a time exceeds the range of a double;
/// process::Interrupted
void writeTrajectory(const physics::Motion& motion, const TrajectoryTimes& times, TrajectoryFormat format,
                     const std::string& sceneName, const TextSink& sink);

struct TrajectoryColumn {
  std::string_view name, unit;
};

/// Columns of a trajectory, in order: time; q, which maps components along the scene's body axes B to components
/// along the inertial axes W; angular velocity I^-1 m in B and in W; angular momentum; rotational energy. With
/// dissipation, the angular velocity of the attitude follows, in B and in W, because it then differs from omega.
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

/// Index in kTrajectoryColumns of the first column of each quantity.
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

/// Returns the columns of a trajectory. Without dissipation (alpha = 0), omits the angular velocity of the
/// attitude, because it equals omega.
/// @param alpha  dissipation, s/(kg·m²)
constexpr std::span<const TrajectoryColumn> trajectoryColumns(double alpha) {
  return std::span(kTrajectoryColumns).first(alpha > 0 ? kTrajectoryColumns.size() : std::size_t{kRateBAt});
}

}  // namespace poinsot::reference
