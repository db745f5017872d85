// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "physics/unaligned_types.h"

// Operations on tensors and vectors in a fixed order of additions. The order of Eigen's products depends on the
// CPU's vector unit, and with it the last bit of a result.
namespace poinsot::physics {

/// Relative tolerance for rounding errors of a tensor: for its asymmetry, and for a moment that exceeds the sum of
/// the other two. A flat body, for example, has I3 = I1 + I2, which rounding can violate, but by less than this
/// tolerance.
inline constexpr double kTensorSlack = 1e-12;

/// Rounding error of a tensor that was rotated or composed of parts, relative to its largest entry: 8 ulp at 1.
/// Moments that differ by less count as equal. Smaller off-diagonal entries count as 0.
inline constexpr double kTensorRounding = 0x1p-49;

/// Returns a tensor made exactly symmetric.
/// @throws core::Error(kPhysics) naming an entry that is not finite, or two opposite entries that differ by more
/// than kTensorSlack.
Eigen::Matrix3d symmetricTensor(const Eigen::Matrix3d& inertia);

/// Returns the rotated tensor R I Rᵀ, where R is the rotation of q (eq 16). The result is exactly symmetric, and
/// correctly rounded except for an error of about 1e-30. The length of q does not matter: a quarter turn given as
/// (1, 0, 0, 1)·0.7071... is exact.
/// @throws core::Error(kPhysics) for a zero or non-finite quaternion.
Eigen::Matrix3d turnedTensor(const Quaternion& q, const Eigen::Matrix3d& inertia);

/// Returns the rotated vector R v, where R is the rotation of q.
/// @throws core::Error(kPhysics) for a zero or non-finite quaternion.
Eigen::Vector3d turnedVector(const Quaternion& q, const Eigen::Vector3d& v);

}  // namespace poinsot::physics
