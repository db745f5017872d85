// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "physics/principal_axes.h"

namespace poinsot::physics {

/// Conditioning of a run: how well the inputs determine the attitude at its end if each carries the rounding of a
/// double, as decimals do. No method of computing can do better.
struct RunCondition {
  double attitude_rad = 0;  ///< uncertainty of the attitude, at most pi
  double digits = 0;        ///< significant decimals of an angle in rad: -log10(attitude_rad), 0 to 16
  double turns = 0;         ///< |omega| t/(2 pi)
  double flips = 0;         ///< half periods of the polhode in the run
};

/// Estimates the uncertainty of the attitude as the sum of two terms, with eps = 2^-52 the relative rounding of an
/// input and dD the rounding of D = L² - 2 T I2, which is a difference:
///   eps |omega| t       every rate is off by eps
///   flips dD/|D|        each passage of the middle axis takes K/lambda, and dK = dD/(2 D)
/// If the terms of D cancel, dD/|D| is of the order of eps/mc. On the separatrix and before the first flip, the
/// second term is dD grown by e^(lambda t). If the body's axes are not principal, omega along each principal axis
/// is off by eps |omega|. Source: linear propagation of errors through the closed form (free_motion_constants.h).
/// The motion of rounded inputs is within a factor of 60 of the estimate (tests/physics/run_condition_test.cpp).
/// @param omega_B rad/s
/// @throws core::Error(kPhysics) if omega_B is not finite, (kLimit) if a phase exceeds kFarthestPhase_rad
/// (motion.h).
RunCondition runCondition(const PrincipalAxes& axes, const Eigen::Vector3d& omega_B, double duration_s);

}  // namespace poinsot::physics
