// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <optional>

#include "physics/principal_axes.h"
#include "physics/rigid_body_state.h"
#include "physics/unaligned_types.h"
#include "reference/grade_table.h"

namespace poinsot::reference {

/// One row of somebody's trajectory: the quantities that it has, as they are written or read in another way.
struct LoggedState {
  double t_s = 0;
  std::optional<physics::Quaternion> q_WB;          ///< unit; not a number where the row's has no direction
  std::optional<Eigen::Vector3d> omega_B, omega_W;  ///< rad/s
  std::optional<Eigen::Vector3d> rate_B, rate_W;    ///< rate at which the attitude turns, rad/s
  std::optional<Eigen::Vector3d> L_W;               ///< kg·m²/s
  std::optional<double> kineticEnergy;              ///< J
  double quaternionLength = 1;                      ///< as written
};

LoggedState loggedState(const TrajectoryTable& theirs, std::size_t row);

/// Returns whether every value of the row is a number and its quaternion has a direction.
bool isFinite(const LoggedState& state);

inline bool hasAttitude(const LoggedState& s) { return s.q_WB.has_value(); }

/// Quantities computed from a row's omega and attitude.
struct DerivedState {
  std::optional<Eigen::Vector3d> L_W;
  std::optional<double> lengthOfL, kineticEnergy;
};

/// L_W and T: the row's own; else L = q (I omega_B), T = omega_B I omega_B / 2, omega_B from omega_W by q where it
/// is absent itself.
DerivedState derivedState(const physics::PrincipalAxes& axes, const LoggedState& state);

/// Angle of the rotation from one attitude to the other, rad, 0 to pi; either sign of a quaternion.
double angleBetween(const physics::Quaternion& a, const physics::Quaternion& b);
/// Angle between two vectors, rad, 0 to pi.
double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

}  // namespace poinsot::reference
