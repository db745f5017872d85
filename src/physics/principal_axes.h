// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/abi.h"
#include "physics/principal_moments.h"
#include "physics/unaligned_types.h"

namespace poinsot::physics {

/// Principal axes P of a body, and the moments about them (eq 15 to 17). P is given relative to B, the axes in
/// which the body was described.
class PrincipalAxes {
 public:
  /// Describes a body in its principal axes: B is P, and conversions between the two are exact.
  // NOLINTNEXTLINE(google-explicit-constructor): bare moments are principal axes.
  PrincipalAxes(const PrincipalMoments& moments) : moments_(moments) {}

  /// @param q_BP takes P components to B components
  /// @pre q_BP is of unit length.
  PrincipalAxes(const PrincipalMoments& moments, const Quaternion& q_BP);

  /// Diagonalizes an inertia tensor in B, kg·m². A diagonal tensor keeps its axes, and its moments to the last
  /// bit. For any other tensor, the moments ascend and the axes are a proper rotation of B. Moments that differ by
  /// less than the tensor's rounding become equal.
  /// @throws core::Error(kPhysics) for a tensor that is not finite, symmetric, positive and possible.
  explicit PrincipalAxes(const Eigen::Matrix3d& inertia_B);

  const PrincipalMoments& moments() const { return moments_; }
  const Quaternion& q_BP() const { return q_BP_; }
  bool aligned() const { return aligned_; }  ///< true if the axes B and P are the same

  /// Returns the components of v_B along the principal axes. If B is not P, tiny components become 0: those within
  /// the rounding of the turn, which is 8 units in the last place of the largest component.
  Eigen::Vector3d toP(const Eigen::Vector3d& v_B) const;
  Eigen::Vector3d toB(const Eigen::Vector3d& v_P) const;

  /// Returns the angular momentum I·omega, in B, kg·m²/s (eq 6).
  Eigen::Vector3d angularMomentum(const Eigen::Vector3d& omega_B) const;
  /// Returns the angular velocity I⁻¹·m, in B, rad/s.
  Eigen::Vector3d angularVelocity(const Eigen::Vector3d& m_B) const;
  /// Returns the tensor in B, kg·m² (eq 16).
  Eigen::Matrix3d inertia_B() const;

 private:
  PrincipalMoments moments_;
  Quaternion q_BP_ = Quaternion::Identity();
  bool aligned_ = true;
};

static_assert(core::laidOut<PrincipalAxes, 64>());

}  // namespace poinsot::physics
