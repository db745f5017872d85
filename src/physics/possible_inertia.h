// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/abi.h"

/// Functions that find the possible moments of inertia nearest to moments that no solid body can have.
///
/// A solid with the second moments p_i = ∫ x_i² dm >= 0 has I_1 = p_2 + p_3 and so on (eq 13). The possible
/// moments therefore form a convex cone: I_i <= I_j + I_k for every i. The nearest possible moments are the
/// orthogonal projection onto the cone, which minimizes the sum of squared changes. For a tensor, the Frobenius
/// norm is used: its principal axes stay, and its principal moments are projected.
namespace poinsot::physics {

/// Smallest moment that these functions return, as a fraction of the largest. It is not 0, because poinsot does
/// not accept rods without thickness.
inline constexpr double kLeastOfNearest = 1e-6;

/// Returns the nearest moments that a solid can have, in the order and the unit of `moments`. Possible moments are
/// unchanged, unless one is below kLeastOfNearest of the largest. Returns nullopt if a moment is not finite, or if
/// all nearest moments are 0.
std::optional<Eigen::Vector3d> nearestPossibleMoments(const Eigen::Vector3d& moments);

/// Returns the nearest symmetric tensor that a solid can have, in the axes and the unit of `inertia`. Reads only
/// the lower triangle of `inertia`. Returns nullopt as nearestPossibleMoments() does.
std::optional<Eigen::Matrix3d> nearestPossibleTensor(const Eigen::Matrix3d& inertia);

}  // namespace poinsot::physics
