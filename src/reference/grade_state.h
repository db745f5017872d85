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

/// Quantities of a row of a log, as written or converted by readings.
struct LoggedState {
  double t_s = 0;
  std::optional<physics::Quaternion> q_WB;          ///< normalised; NaN if 0 or not finite in the log
  std::optional<Eigen::Vector3d> omega_B, omega_W;  ///< rad/s
  std::optional<Eigen::Vector3d> rate_B, rate_W;    ///< angular velocity of the attitude, rad/s
  std::optional<Eigen::Vector3d> L_W;               ///< kg·m²/s
  std::optional<double> kineticEnergy;              ///< J
  double quaternionLength = 1;                      ///< length of the quaternion in the log
};

LoggedState loggedState(const TrajectoryTable& theirs, std::size_t row);

/// Returns whether all values of a row are finite, and its quaternion is not 0.
bool isFinite(const LoggedState& state);

inline bool hasAttitude(const LoggedState& s) { return s.q_WB.has_value(); }

struct DerivedState {
  std::optional<Eigen::Vector3d> L_W;
  std::optional<double> lengthOfL, kineticEnergy;
};

/// Returns L_W and T of a row. If the row lacks them, computes L = q (I omega_B) and T = omega_B I omega_B / 2. If
/// the row lacks omega_B, computes it from omega_W and q.
DerivedState derivedState(const physics::PrincipalAxes& axes, const LoggedState& state);

/// Returns the angle of the rotation between two attitudes, in rad, 0 to pi. q and -q are the same attitude.
double angleBetween(const physics::Quaternion& a, const physics::Quaternion& b);
double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

}  // namespace poinsot::reference
