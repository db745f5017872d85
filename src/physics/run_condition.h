// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "physics/principal_axes.h"

namespace poinsot::physics {

/// Conditioning of a run: how accurately the inputs determine the attitude at its end. Each input is assumed to be
/// rounded to a double, as decimal numbers are. No method of computation can be more accurate.
struct RunCondition {
  double attitude_rad = 0;  ///< uncertainty of the attitude at the end, at most pi
  double digits = 0;        ///< significant decimals of an angle in rad: -log10(attitude_rad), 0 to 16
  double turns = 0;         ///< number of turns, |omega| t/(2 pi)
  double flips = 0;         ///< number of half periods of the polhode in the run
};

/// Estimates the uncertainty of the attitude at the end of a run. eps = 2^-52 is the relative rounding error of an
/// input, and dD the resulting error of D = L² - 2 T I2. The estimate is the sum of two terms:
///   eps |omega| t       every rate has the relative error eps
///   flips dD/|D|        each passage of the middle axis takes K/lambda, and dK = dD/(2 D)
/// If the terms of D cancel, dD/|D| is of the order of eps/mc. On the separatrix and before the first flip, the
/// second term is instead dD grown by e^(lambda t). If the body's axes are not principal, omega along each
/// principal axis has the error eps |omega|.
/// Source: linear propagation of errors through the closed form (free_motion_constants.h). The measured effect of
/// rounded inputs is within a factor of 60 of the estimate (tests/physics/run_condition_test.cpp).
/// @param omega_B rad/s
/// @throws core::Error(kPhysics) if omega_B is not finite, (kLimit) if a phase exceeds kFarthestPhase_rad
/// (motion.h).
RunCondition runCondition(const PrincipalAxes& axes, const Eigen::Vector3d& omega_B, double duration_s);

}  // namespace poinsot::physics
