// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "physics/unaligned_types.h"

namespace poinsot::physics {

/// Torque as a function of time, given by `torque` (N·m) at each of the ascending times `t_s`. Between two times,
/// the torque keeps the value of the first, or is interpolated if `linear`. Before the first time the torque is
/// zero. After the last time the torque is zero if `linear`, otherwise it keeps the last value.
struct TorqueHistory {
  std::vector<double> t_s;
  std::vector<Eigen::Vector3d> torque;
  bool linear = false;

  bool empty() const { return t_s.empty(); }
};

/// Torques, drag and energy loss that act on a rotating body. If all are zero, the motion is free.
struct Forcing {
  /// M g r: weight times the vector from the fixed point to the centre of mass, in B, N·m. Gravity pulls along -z
  /// of W, so the torque is (R_WB r) × (-M g z).
  Eigen::Vector3d gravity_B = Eigen::Vector3d::Zero();
  Eigen::Vector3d torque_B = Eigen::Vector3d::Zero();  ///< constant in body axes, N·m
  Eigen::Vector3d torque_W = Eigen::Vector3d::Zero();  ///< constant in space axes, N·m
  TorqueHistory torqueHistory_B, torqueHistory_W;      ///< added to the constant torques
  /// Drag rates, 1/s, each >= 0: m_i' = ... - rate_i m_i for the components of m along the principal axes P.
  Eigen::Vector3d dragRate_P = Eigen::Vector3d::Zero();
  /// Energy loss at constant L: m' = m × omega + alpha m × (m × omega), alpha >= 0 in s/(kg·m²). The number alpha
  /// |m| has no unit; the axis turns by about this fraction of the angle of spin.
  double dissipation = 0;

  bool none() const {
    return gravity_B.isZero(0) && torque_B.isZero(0) && torque_W.isZero(0) && torqueHistory_B.empty() &&
           torqueHistory_W.empty() && dragRate_P.isZero(0) && dissipation == 0;
  }
};

/// Checks that all values of a forcing are possible.
/// @throws core::Error(kPhysics) naming what is not finite, negative, of unequal length or out of order.
void validate(const Forcing& forcing);

/// Returns M g z of the centre of mass above the fixed point, J. Under gravity alone, potential plus kinetic
/// energy is constant.
double potentialEnergy(const Forcing& forcing, const Quaternion& q_WB);

}  // namespace poinsot::physics
