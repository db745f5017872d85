// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/abi.h"

/// The moments of inertia nearest to ones that no solid body can have.
///
/// A solid with the second moments p_i = ∫ x_i² dm >= 0 has I_1 = p_2 + p_3 and so on (eq 13), so the possible
/// moments are a convex cone: I_i <= I_j + I_k for every i. The nearest possible moments are its orthogonal
/// projection, the least sum of squared changes. A tensor's are found with the Frobenius norm, in which the
/// projection keeps the principal axes and projects the principal moments.
namespace poinsot::physics {

/// The least moment of what these functions return, relative to the largest. On the cone's edge lie rods without
/// thickness, whose least moment is 0, and no body of this program is one.
inline constexpr double kLeastOfNearest = 1e-6;

/// Nearest moments that a solid can have, in the order and the unit of the given ones. Possible moments stay as
/// they are, unless one is below kLeastOfNearest of the largest. None where the nearest is a body without any
/// moment, or a moment is not finite.
std::optional<Eigen::Vector3d> nearestPossibleMoments(const Eigen::Vector3d& moments);

/// Nearest symmetric tensor that a solid can have, in the axes and the unit of the given one, of which the lower
/// triangle is read. None as above.
std::optional<Eigen::Matrix3d> nearestPossibleTensor(const Eigen::Matrix3d& inertia);

}  // namespace poinsot::physics
