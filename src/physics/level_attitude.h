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
/// Each component is accurate to half a unit in its last place. The turned vector therefore deviates from the
/// vertical by at most 2e-16 rad, even if `direction` is almost opposite. With d = `direction`, the vertical v and
/// c = d·v, the quaternion follows from half-angle formulas:
///   c >= 0:  q ~ (|d| + c, d × v)        c < 0:  q ~ (|d × v|/(|d| - c), (d × v)/|d × v|)
/// The second formula is the first divided by |d × v|, and avoids the cancellation of |d| + c. If d is exactly
/// opposite to v, turns about all horizontal axes are equally short. The turn is then chosen as if d leaned
/// towards +y.
/// @param direction any length and unit; the zero vector gives the identity
/// @throws core::Error(kPhysics) if the direction is not finite.
Quaternion turnOntoVertical(const Eigen::Vector3d& direction, Vertical vertical);

/// Returns an attitude q_WB in which the angular momentum is along the vertical of W. B is turned into this
/// attitude from B = W, by the shortest turn. L_W deviates from the vertical by at most 1.6e-16 |L| (measured in
/// tests/physics/level_attitude_test.cpp).
/// @param omega_B rad/s; a body at rest gives the identity
/// @throws core::Error(kPhysics) if omega_B is not finite.
Quaternion levelAttitude(const PrincipalAxes& axes, const Eigen::Vector3d& omega_B, Vertical vertical);

}  // namespace poinsot::physics
