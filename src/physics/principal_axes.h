// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/abi.h"
#include "physics/principal_moments.h"
#include "physics/unaligned_types.h"

namespace poinsot::physics {

/// Principal axes P of a body, relative to the axes B in which it was described, with the moments about them (eq
/// 15 to 17).
class PrincipalAxes {
 public:
  /// Describes a body in its principal axes: B is P, and conversions between the two are exact.
  // NOLINTNEXTLINE(google-explicit-constructor): bare moments are principal axes.
  PrincipalAxes(const PrincipalMoments& moments) : moments_(moments) {}

  /// @param q_BP takes P components to B components
  /// @pre q_BP is of unit length.
  PrincipalAxes(const PrincipalMoments& moments, const Quaternion& q_BP);

  /// Diagonalizes an inertia tensor in B, kg·m². A diagonal tensor keeps its axes and its moments to the last bit;
  /// otherwise the moments ascend and the axes are a proper rotation. Moments that differ by less than the
  /// tensor's rounding become equal.
  /// @throws core::Error(kPhysics) for a tensor that is not finite, symmetric, positive and possible.
  explicit PrincipalAxes(const Eigen::Matrix3d& inertia_B);

  const PrincipalMoments& moments() const { return moments_; }
  const Quaternion& q_BP() const { return q_BP_; }
  bool aligned() const { return aligned_; }  ///< true if B is P

  /// Returns the components of v_B along the principal axes. If B is not P, components within the rounding of the
  /// turn (8 units in the last place of the largest) become 0.
  Eigen::Vector3d toP(const Eigen::Vector3d& v_B) const;
  Eigen::Vector3d toB(const Eigen::Vector3d& v_P) const;

  /// Returns I·omega, in B, kg·m²/s (eq 6).
  Eigen::Vector3d angularMomentum(const Eigen::Vector3d& omega_B) const;
  /// Returns I⁻¹·m, in B, rad/s.
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
