// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "physics/principal_axes.h"
#include "physics/unaligned_types.h"

namespace poinsot::physics {

enum class Vertical { kUp, kDown };  ///< +z or -z of the axes turned into

/// Returns the unit quaternion of the shortest turn that takes `direction` onto the vertical.
///
/// Each component is right to half a unit in its last place, so that the turned vector is off the vertical by at
/// most 2e-16 rad, also where `direction` points almost opposite. Half-angle formulas, v the vertical, c = d·v:
///   c >= 0:  q ~ (|d| + c, d × v)        c < 0:  q ~ (|d × v|/(|d| - c), (d × v)/|d × v|)
/// The second is the first divided by |d × v|; |d| + c would cancel there. Exactly opposite, every horizontal axis
/// is as short: the turn is the one of a direction that leans towards +y.
/// @param direction of any length; its unit does not matter. The zero vector gives the identity.
/// @throws core::Error(kPhysics) if the direction is not finite.
Quaternion turnOntoVertical(const Eigen::Vector3d& direction, Vertical vertical);

/// Returns the attitude q_WB reached by the shortest turn from B = W that brings the angular momentum onto the
/// vertical of W.
/// @param omega_B rad/s. A body at rest gives the identity.
/// @throws core::Error(kPhysics) if omega_B is not finite.
/// Measured in tests/physics/level_attitude_test.cpp: L_W is off the vertical by 1.6e-16 |L| at most.
Quaternion levelAttitude(const PrincipalAxes& axes, const Eigen::Vector3d& omega_B, Vertical vertical);

}  // namespace poinsot::physics
