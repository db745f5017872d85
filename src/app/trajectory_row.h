// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "physics/rigid_body_state.h"

namespace poinsot::app {

struct TrajectoryColumn {
  std::string_view name, unit;
};

/// What a trajectory says of one time, in this order: t; q takes components along the body's axes B, as the scene
/// gives them, to components along the inertial axes W; angular velocity in both; angular momentum; energy of
/// rotation.
inline constexpr std::array<TrajectoryColumn, 15> kTrajectoryColumns{{{"t", "s"},
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
                                                                      {"T", "J"}}};

/// Where in a row each quantity begins.
enum TrajectoryPlace : std::size_t {
  kTimeAt = 0,
  kQAt = 1,
  kOmegaBAt = 5,
  kOmegaWAt = 8,
  kLWAt = 11,
  kEnergyAt = 14
};

using TrajectoryRow = std::array<double, kTrajectoryColumns.size()>;

TrajectoryRow trajectoryRow(const physics::RigidBodyState& state);

}  // namespace poinsot::app
