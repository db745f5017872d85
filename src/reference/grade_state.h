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

/// Row of a log: the quantities that it has, as written or in another reading.
struct LoggedState {
  double t_s = 0;
  std::optional<physics::Quaternion> q_WB;          ///< normalised; NaN if the row's quaternion has no direction
  std::optional<Eigen::Vector3d> omega_B, omega_W;  ///< rad/s
  std::optional<Eigen::Vector3d> rate_B, rate_W;    ///< rate at which the attitude turns, rad/s
  std::optional<Eigen::Vector3d> L_W;               ///< kg·m²/s
  std::optional<double> kineticEnergy;              ///< J
  double quaternionLength = 1;                      ///< length of the quaternion as written
};

LoggedState loggedState(const TrajectoryTable& theirs, std::size_t row);

/// Returns whether all values of a row are finite and its quaternion has a direction.
bool isFinite(const LoggedState& state);

inline bool hasAttitude(const LoggedState& s) { return s.q_WB.has_value(); }

struct DerivedState {
  std::optional<Eigen::Vector3d> L_W;
  std::optional<double> lengthOfL, kineticEnergy;
};

/// Returns L_W and T of a row. Missing values are computed: L = q (I omega_B), T = omega_B I omega_B / 2, with
/// omega_B from omega_W by q if necessary.
DerivedState derivedState(const physics::PrincipalAxes& axes, const LoggedState& state);

/// Returns the angle of the rotation between two attitudes, rad, 0 to pi. The sign of a quaternion has no effect.
double angleBetween(const physics::Quaternion& a, const physics::Quaternion& b);
double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

}  // namespace poinsot::reference
