// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "physics/principal_axes.h"

namespace poinsot::physics {

/// How well the attitude at the end of a run is determined by its inputs when each of them carries the rounding of
/// a double, as decimals do: no method of computing can know more.
struct RunCondition {
  double attitude_rad = 0;  ///< uncertainty of the attitude, at most pi
  double digits = 0;        ///< decimal digits of an angle in rad that mean something: -log10 of it, 0 to 16
  double turns = 0;         ///< |omega| t/(2 pi)
  double flips = 0;         ///< half periods of the polhode in the run
};

/// With eps = 2^-52 the relative rounding of an input, and dD that of D = L² - 2 T I2, which is a difference:
///   eps |omega| t          every rate is off by eps
/// + flips dD/|D|           each passage of the middle axis takes K/lambda, and dK = dD/(2 D); where the terms of
/// D
///                          cancel, dD/|D| is of the order of eps/mc
/// On the separatrix and before the first flip the second term is what e^(lambda t) has made of dD. Of a body
/// described in axes that are not principal, omega along each principal axis is off by eps |omega|.
/// Source: linear propagation of errors through the closed form (free_motion_constants.h). An estimate: the motion
/// of rounded inputs is within a factor of 60 of it (tests/physics/run_condition_test.cpp). omega_B in rad/s.
/// @throws core::Error(kPhysics) if it is not finite, (kLimit) for a time beyond kFarthestPhase_rad (motion.h).
RunCondition runCondition(const PrincipalAxes& axes, const Eigen::Vector3d& omega_B, double duration_s);

}  // namespace poinsot::physics
