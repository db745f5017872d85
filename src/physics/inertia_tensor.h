// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "physics/unaligned_types.h"

// Tensors and vectors in arithmetic of a fixed order: the order of Eigen's own products depends on the vector unit
// compiled for, and with it the last bit.
namespace poinsot::physics {

/// Largest excess of a moment over the sum of the other two, relative, and largest asymmetry: what computing in
/// doubles leaves of an equality (a lamina has I3 = I1 + I2).
inline constexpr double kTensorSlack = 1e-12;

/// Of the largest entry: moments nearer to each other than this are equal, and entries off the diagonal below it
/// are 0. A tensor composed of parts, or turned, is off by a few roundings.
inline constexpr double kTensorRounding = 0x1p-49;  // 8 steps of a double at 1

/// The tensor made exactly symmetric. @throws core::Error(kPhysics) naming an entry that is not finite, or a pair
/// that differs.
Eigen::Matrix3d symmetricTensor(const Eigen::Matrix3d& inertia);

/// R I Rᵀ for the rotation R of q (eq 16), correctly rounded but for some 1e-30; exactly symmetric. The length of
/// q does not matter; a quarter turn given as (1, 0, 0, 1)·0.7071... turns exactly.
/// @throws core::Error(kPhysics) for a zero or non-finite quaternion.
Eigen::Matrix3d turnedTensor(const Quaternion& q, const Eigen::Matrix3d& inertia);

/// Returns R v, turned like a tensor. @throws core::Error(kPhysics) for a zero or non-finite quaternion.
Eigen::Vector3d turnedVector(const Quaternion& q, const Eigen::Vector3d& v);

}  // namespace poinsot::physics
