// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
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

/// Force at a point of the body, which acts while from_s <= t < to_s. The point moves with the body. Its torque is
/// lever × force (eq 9). The lever is the vector from the centre of mass to the point or, for a body with a fixed
/// point, from the fixed point.
struct PointForce {
  Eigen::Vector3d lever_B = Eigen::Vector3d::Zero();  ///< m
  Eigen::Vector3d force_B = Eigen::Vector3d::Zero();  ///< force that turns with the body, in body axes, N
  Eigen::Vector3d force_W = Eigen::Vector3d::Zero();  ///< force of constant direction in space, in space axes, N
  double from_s = -HUGE_VAL;                          ///< motion time; by default the force acts always
  double to_s = HUGE_VAL;

  bool actsAt(double t_s) const { return from_s <= t_s && t_s < to_s; }
};

/// Torques, forces, drag and energy loss that act on a rotating body. If all are zero, the motion is free.
struct Forcing {
  /// Weight times lever arm, M g r, in B, N·m. r is the vector from the fixed point to the centre of mass. Gravity
  /// pulls along -z of W, so that the torque is (R_WB r) × (-M g z).
  Eigen::Vector3d gravity_B = Eigen::Vector3d::Zero();
  Eigen::Vector3d torque_B = Eigen::Vector3d::Zero();  ///< constant torque in body axes, N·m
  Eigen::Vector3d torque_W = Eigen::Vector3d::Zero();  ///< constant torque in space axes, N·m
  TorqueHistory torqueHistory_B, torqueHistory_W;  ///< torques that depend on time, added to the constant torques
  std::vector<PointForce> forces;                  ///< forces at points of the body
  /// Drag rates along the principal axes P, 1/s, each >= 0. Drag adds -rate_i m_i to m_i', where m is the angular
  /// momentum along P.
  Eigen::Vector3d dragRate_P = Eigen::Vector3d::Zero();
  /// Rate alpha of energy loss at constant L, >= 0, in s/(kg·m²): m' = m × omega + alpha m × (m × omega). While
  /// the body spins by some angle, the axis moves by about alpha |m| times this angle.
  double dissipation = 0;

  bool none() const {
    return gravity_B.isZero(0) && torque_B.isZero(0) && torque_W.isZero(0) && torqueHistory_B.empty() &&
           torqueHistory_W.empty() && forces.empty() && dragRate_P.isZero(0) && dissipation == 0;
  }
};

/// Checks that all values of a forcing are possible.
/// @throws core::Error(kPhysics) if a value is not finite or is negative, if a torque table has times out of order
/// or not as many torques as times, or if a force does not end after it begins.
void validate(const Forcing& forcing);

/// Returns the potential energy M g z, J, where z is the height of the centre of mass above the fixed point. Under
/// gravity alone, potential plus kinetic energy is constant.
double potentialEnergy(const Forcing& forcing, const Quaternion& q_WB);

}  // namespace poinsot::physics
