// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "physics/unaligned_types.h"

// Tensors and vectors in arithmetic of a fixed order, because the order of Eigen's products, and so the last bit,
// depends on the vector unit.
namespace poinsot::physics {

/// Largest accepted excess of a moment over the sum of the other two, and largest asymmetry, both relative.
/// Rounding violates equalities by less than this; a lamina, for example, has I3 = I1 + I2.
inline constexpr double kTensorSlack = 1e-12;

/// Rounding of a tensor, relative to its largest entry: 8 ulp at 1. Moments that differ by less count as equal,
/// and smaller off-diagonal entries as 0. A tensor that was composed of parts, or turned, is off by a few
/// roundings.
inline constexpr double kTensorRounding = 0x1p-49;

/// Returns the tensor made exactly symmetric.
/// @throws core::Error(kPhysics) naming an entry that is not finite, or a pair that differs.
Eigen::Matrix3d symmetricTensor(const Eigen::Matrix3d& inertia);

/// Returns R I Rᵀ for the rotation R of q (eq 16), exactly symmetric and correctly rounded except for an error of
/// about 1e-30. The length of q does not matter. A quarter turn given as (1, 0, 0, 1)·0.7071... is exact.
/// @throws core::Error(kPhysics) for a zero or non-finite quaternion.
Eigen::Matrix3d turnedTensor(const Quaternion& q, const Eigen::Matrix3d& inertia);

/// Returns R v, with R as in turnedTensor(). @throws core::Error(kPhysics) for a zero or non-finite quaternion.
Eigen::Vector3d turnedVector(const Quaternion& q, const Eigen::Vector3d& v);

}  // namespace poinsot::physics
