// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/abi.h"
#include "physics/principal_moments.h"
#include "physics/unaligned_types.h"

namespace poinsot::physics {

/// The principal axes P of a body, seen from the axes B that it was described in, and its moments about them
/// (eq 15 to 17).
class PrincipalAxes {
 public:
  /// A body described in its principal axes: B is P, and every change between the two is exact.
  // NOLINTNEXTLINE(google-explicit-constructor): bare moments are principal axes.
  PrincipalAxes(const PrincipalMoments& moments) : moments_(moments) {}

  /// q_BP takes P components to B components. @pre of unit length.
  PrincipalAxes(const PrincipalMoments& moments, const Quaternion& q_BP);

  /// Of an inertia tensor in B, kg·m². A diagonal tensor keeps its axes and its moments to the last bit; else the
  /// moments ascend and the axes are a proper rotation. Moments nearer to each other than the rounding of the
  /// tensor are equal.
  /// @throws core::Error(kPhysics) for a tensor that is not finite, symmetric, positive and possible.
  explicit PrincipalAxes(const Eigen::Matrix3d& inertia_B);

  const PrincipalMoments& moments() const { return moments_; }
  const Quaternion& q_BP() const { return q_BP_; }
  bool aligned() const { return aligned_; }  ///< B is P

  /// Components of v_B along the principal axes. If B is not P, those within the rounding of the turn are 0 (8
  /// units in the last place of the largest).
  Eigen::Vector3d toP(const Eigen::Vector3d& v_B) const;
  Eigen::Vector3d toB(const Eigen::Vector3d& v_P) const;

  /// I·omega, in B, kg·m²/s (eq 6).
  Eigen::Vector3d angularMomentum(const Eigen::Vector3d& omega_B) const;
  /// I⁻¹·m, in B, rad/s.
  Eigen::Vector3d angularVelocity(const Eigen::Vector3d& m_B) const;
  /// The tensor in B, kg·m² (eq 16).
  Eigen::Matrix3d inertia_B() const;

 private:
  PrincipalMoments moments_;
  Quaternion q_BP_ = Quaternion::Identity();
  bool aligned_ = true;
};

static_assert(core::laidOut<PrincipalAxes, 64>());

}  // namespace poinsot::physics
