// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/driven_trajectory.h"

namespace poinsot::physics {

/// A driven body, its start and the span of time wanted of it.
struct DrivenProblem {
  PrincipalAxes axes;
  Forcing forcing;
  DrivenState start;
  double from_s = 0;  ///< <= 0
  double to_s = 0;    ///< >= 0
  double allowedSteps = kMostSteps;
};

/// A run that meets a tolerance, or the best that was found.
struct ChosenRun {
  const Composition* composition = nullptr;
  DrivenTrajectory forward, backward;  ///< from 0 to either end
  /// Largest angle between this run and one of longer steps, over the whole span, plus what roundings common to
  /// both may hide: an estimate of the error of the attitude.
  double error_rad = 0;
  bool limitedByRounding = false;  ///< the tolerance is not met, and shorter steps would not help
};

/// Integrates the whole span with two step lengths, shorter and shorter until the two agree to the tolerance, or
/// rounding alone is left. Chaos, growth by an unstable motion and the roundings themselves are all in that
/// difference, as they are in the error.
/// @throws core::Error(kLimit) if that needs more than mostSteps(); (kPhysics) as pilotPlan().
ChosenRun chosenRun(const DrivenProblem& problem, double tolerance_rad);

}  // namespace poinsot::physics
