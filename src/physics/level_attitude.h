// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "physics/principal_axes.h"
#include "physics/unaligned_types.h"

namespace poinsot::physics {

enum class Vertical { kUp, kDown };  ///< +z or -z of the target axes

/// Returns the unit quaternion of the shortest turn that takes `direction` onto the vertical.
///
/// Each component is accurate to half a unit in its last place. The turned vector is therefore off the vertical by
/// at most 2e-16 rad, even if `direction` is almost opposite. Half-angle formulas, with the vertical v and c =
/// d·v:
///   c >= 0:  q ~ (|d| + c, d × v)        c < 0:  q ~ (|d × v|/(|d| - c), (d × v)/|d × v|)
/// The second is the first divided by |d × v|, because |d| + c would cancel for c < 0. If `direction` is exactly
/// opposite, every horizontal axis is as short, and the turn is that of a direction that leans towards +y.
/// @param direction any length and unit; the zero vector gives the identity
/// @throws core::Error(kPhysics) if the direction is not finite.
Quaternion turnOntoVertical(const Eigen::Vector3d& direction, Vertical vertical);

/// Returns the attitude q_WB after the shortest turn from B = W that brings the angular momentum onto the vertical
/// of W. L_W is off the vertical by at most 1.6e-16 |L| (measured in tests/physics/level_attitude_test.cpp).
/// @param omega_B rad/s; a body at rest gives the identity
/// @throws core::Error(kPhysics) if omega_B is not finite.
Quaternion levelAttitude(const PrincipalAxes& axes, const Eigen::Vector3d& omega_B, Vertical vertical);

}  // namespace poinsot::physics
