// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>

#include "physics/principal_moments.h"
#include "physics/rigid_body_state.h"

namespace poinsot::physics {

/// Torque-free rotation of a rigid body in closed form: any body, any start, any time, without stepping.
/// Immutable and thread-safe; at(t) costs the same for every t.
class FreeMotion {
 public:
  /// Start at t = 0. omega0_B in rad/s, in the body's principal axes; q0_WB takes B to W, any nonzero quaternion.
  /// @throws core::Error(kPhysics) for a non-finite omega0_B or a zero or non-finite quaternion.
  FreeMotion(const PrincipalMoments& moments, const Eigen::Vector3d& omega0_B, const Eigen::Quaterniond& q0_WB);
  ~FreeMotion();
  FreeMotion(FreeMotion&&) noexcept;
  FreeMotion& operator=(FreeMotion&&) noexcept;

  /// State at motion time t_s (seconds, any sign).
  RigidBodyState at(double t_s) const;

  const PrincipalMoments& moments() const;
  /// Angular momentum in W, kg·m²/s: constant of the motion.
  const Eigen::Vector3d& L_W() const;
  /// Kinetic energy of rotation, J: constant of the motion (eq 12).
  double kineticEnergy() const;

 private:
  struct Solution;
  std::unique_ptr<const Solution> solution_;
};

}  // namespace poinsot::physics
