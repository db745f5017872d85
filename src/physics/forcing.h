// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "physics/unaligned_types.h"

namespace poinsot::physics {

/// Table of a torque that depends on time: `torque` (N·m) at each of the ascending times `t_s`. If `linear`, the
/// torque is interpolated between the times, and is zero before the first and after the last time. Otherwise each
/// value holds until the next time, and the last value holds for ever; before the first time the torque is zero.
struct TorqueHistory {
  std::vector<double> t_s;
  std::vector<Eigen::Vector3d> torque;
  bool linear = false;

  bool empty() const { return t_s.empty(); }
};

/// Torques, drag and energy loss that act on a rotating body. If all are zero, the motion is free.
struct Forcing {
  /// Weight times lever arm, M g r, in B, N·m. r is the vector from the fixed point to the centre of mass. Gravity
  /// pulls along -z of W, so that the torque is (R_WB r) × (-M g z).
  Eigen::Vector3d gravity_B = Eigen::Vector3d::Zero();
  Eigen::Vector3d torque_B = Eigen::Vector3d::Zero();  ///< constant torque in body axes, N·m
  Eigen::Vector3d torque_W = Eigen::Vector3d::Zero();  ///< constant torque in space axes, N·m
  TorqueHistory torqueHistory_B, torqueHistory_W;  ///< torques that depend on time, added to the constant torques
  /// Drag rates along the principal axes P, 1/s, each >= 0. Drag adds -rate_i m_i to m_i', where m is the angular
  /// momentum along P.
  Eigen::Vector3d dragRate_P = Eigen::Vector3d::Zero();
  /// Rate alpha of energy loss at constant L, >= 0, in s/(kg·m²): m' = m × omega + alpha m × (m × omega). While
  /// the body spins by some angle, the axis moves by about alpha |m| times this angle.
  double dissipation = 0;

  bool none() const {
    return gravity_B.isZero(0) && torque_B.isZero(0) && torque_W.isZero(0) && torqueHistory_B.empty() &&
           torqueHistory_W.empty() && dragRate_P.isZero(0) && dissipation == 0;
  }
};

/// Checks that all values of a forcing are possible.
/// @throws core::Error(kPhysics) if a value is not finite or is negative, or if a torque table has times out of
/// order or not as many torques as times.
void validate(const Forcing& forcing);

/// Returns the potential energy M g z, J, where z is the height of the centre of mass above the fixed point. Under
/// gravity alone, potential plus kinetic energy is constant.
double potentialEnergy(const Forcing& forcing, const Quaternion& q_WB);

}  // namespace poinsot::physics
