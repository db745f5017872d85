// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/abi.h"

/// Moments of inertia nearest to moments that no solid body can have.
///
/// A solid with the second moments p_i = ∫ x_i² dm >= 0 has I_1 = p_2 + p_3 and so on (eq 13). The possible
/// moments are therefore a convex cone: I_i <= I_j + I_k for every i. The nearest possible moments are the
/// orthogonal projection onto the cone, with the least sum of squared changes. A tensor is projected in the
/// Frobenius norm, which keeps the principal axes and projects the principal moments.
namespace poinsot::physics {

/// Least moment that these functions return, relative to the largest. On the cone's edge lie rods without
/// thickness, whose least moment is 0; poinsot accepts no such body.
inline constexpr double kLeastOfNearest = 1e-6;

/// Returns the nearest moments that a solid can have, in the order and the unit of the given ones. Possible
/// moments are unchanged, unless one is below kLeastOfNearest of the largest. Returns nullopt if a moment is not
/// finite, or if the nearest body has no moment at all.
std::optional<Eigen::Vector3d> nearestPossibleMoments(const Eigen::Vector3d& moments);

/// Returns the nearest symmetric tensor that a solid can have, in the axes and the unit of the given one, whose
/// lower triangle is read. Returns nullopt as nearestPossibleMoments() does.
std::optional<Eigen::Matrix3d> nearestPossibleTensor(const Eigen::Matrix3d& inertia);

}  // namespace poinsot::physics
