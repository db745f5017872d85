// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/abi.h"
#include "physics/unaligned_types.h"

namespace poinsot::physics {

/// State of a rotating rigid body at one time. B are the axes in which the body is described, W are inertial axes.
struct RigidBodyState {
  double t_s = 0;
  Quaternion q_WB = Quaternion::Identity();  ///< attitude, of unit length; takes B components to W components
  Eigen::Vector3d omega_B = Eigen::Vector3d::Zero();  ///< angular velocity, rad/s
  Eigen::Vector3d omega_W = Eigen::Vector3d::Zero();
  Eigen::Vector3d L_W = Eigen::Vector3d::Zero();  ///< angular momentum, kg·m²/s
  double kineticEnergy = 0;                       ///< kinetic energy of rotation, J (eq 12)
};

static_assert(core::laidOut<RigidBodyState, 120>());

}  // namespace poinsot::physics
