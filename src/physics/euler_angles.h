// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "core/abi.h"
#include "physics/unaligned_types.h"

namespace poinsot::physics {

/// Euler angles of an attitude, or their rates, in the order z, x, z: the body is turned by psi (`spin`) about the
/// world's z, then by theta (`nutation`) about the world's x, then by phi (`precession`) about the world's z. The
/// body's z axis then leans from the world's z by theta. At phi = 0, it leans towards -y. Angles in rad.
/// Source: Goldstein, Classical Mechanics, section 4.4; Landau & Lifshitz, Mechanics, section 35.
struct EulerAngles {
  double precession = 0;
  double nutation = 0;
  double spin = 0;
};

/// Returns the attitude q_WB = q_z(phi) q_x(theta) q_z(psi).
/// @throws core::Error(kPhysics) if an angle is not finite, or is too large for sineCosine()
Quaternion attitudeOf(const EulerAngles& angles);

/// Returns omega_B, rad/s, for the rates of the three angles:
///   omega_B = phi' (sin theta sin psi, sin theta cos psi, cos theta) + theta' (cos psi, -sin psi, 0) + psi' (0,
///   0, 1)
/// Source: Goldstein, eq 4.87; Landau & Lifshitz, eq 35.1.
/// @throws core::Error(kPhysics) as attitudeOf()
Eigen::Vector3d omegaFromEulerRates(const EulerAngles& angles, const EulerAngles& rates);

/// Roll, pitch and yaw of an attitude, rad. From an attitude in which the axes agree with the world's, the body is
/// turned by `yaw` about its z axis, then by `pitch` about its new y axis, then by `roll` about its newest x axis.
struct RollPitchYaw {
  double roll = 0;
  double pitch = 0;
  double yaw = 0;
};

/// Returns the attitude q_WB = q_z(yaw) q_y(pitch) q_x(roll).
/// @throws core::Error(kPhysics) if an angle is not finite, or is too large for sineCosine()
Quaternion attitudeOf(const RollPitchYaw& angles);

/// Returns the attitude q_WB in which an axis of the body leans from the world's z by an angle, towards -y.
/// Without the lean, the body is turned from B = W by the shortest turn that takes the axis onto z. For the body's
/// z axis, this is attitudeOf(EulerAngles{0, lean, 0}).
/// @param axis_B  any length but 0
/// @throws core::Error(kPhysics) if a number is not finite
Quaternion leaningAttitude(const Eigen::Vector3d& axis_B, double lean_rad);

static_assert(core::laidOut<EulerAngles, 24>() && core::laidOut<RollPitchYaw, 24>());

}  // namespace poinsot::physics
