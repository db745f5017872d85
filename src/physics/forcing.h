// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "physics/unaligned_types.h"

namespace poinsot::physics {

/// A torque as a function of time: its value at `t_s`, ascending. Between two times it is the first's, or, where
/// `linear`, what lies on the line; zero before the first. After the last it is zero where linear, else the
/// last's.
struct TorqueHistory {
  std::vector<double> t_s;
  std::vector<Eigen::Vector3d> torque;  ///< N·m, as many as times
  bool linear = false;

  bool empty() const { return t_s.empty(); }
};

/// What acts on a rotating body. All zero: free motion.
struct Forcing {
  /// M g r: weight times the centre of mass from the fixed point, in B, N·m; gravity pulls along -z of W, so the
  /// torque is (R_WB r) × (-M g z).
  Eigen::Vector3d gravity_B = Eigen::Vector3d::Zero();
  Eigen::Vector3d torque_B = Eigen::Vector3d::Zero();  ///< constant in body axes, N·m
  Eigen::Vector3d torque_W = Eigen::Vector3d::Zero();  ///< constant in space axes, N·m
  TorqueHistory torqueHistory_B, torqueHistory_W;      ///< besides
  /// Drag: m_i' = ... - rate_i m_i for the components along the principal axes P, 1/s, each >= 0.
  Eigen::Vector3d dragRate_P = Eigen::Vector3d::Zero();
  /// Energy loss at constant L: m' = m × omega + alpha m × (m × omega), alpha >= 0 in s/(kg·m²), so that
  /// alpha |m| is a bare number: about the part of the spin's angle that the axis turns by.
  double dissipation = 0;

  bool none() const {
    return gravity_B.isZero(0) && torque_B.isZero(0) && torque_W.isZero(0) && torqueHistory_B.empty() &&
           torqueHistory_W.empty() && dragRate_P.isZero(0) && dissipation == 0;
  }
};

/// @throws core::Error(kPhysics) naming what is not finite, negative, of unequal length or out of order.
void validate(const Forcing& forcing);

/// M g z of the centre of mass above the fixed point, J; with the kinetic energy it is constant under gravity
/// alone.
double potentialEnergy(const Forcing& forcing, const Quaternion& q_WB);

}  // namespace poinsot::physics
