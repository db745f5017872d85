// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace poinsot::physics {

/// All that varies of a rotating rigid body, at one time. B: principal axes of the body, W: inertial axes.
struct RigidBodyState {
  double t_s = 0;                                            ///< motion time, s
  Eigen::Quaterniond q_WB = Eigen::Quaterniond::Identity();  ///< unit, takes B components to W components
  Eigen::Vector3d omega_B = Eigen::Vector3d::Zero();         ///< angular velocity, rad/s
  Eigen::Vector3d omega_W = Eigen::Vector3d::Zero();         ///< the same vector in W
};

}  // namespace poinsot::physics
