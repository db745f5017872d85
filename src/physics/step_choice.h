// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/driven_trajectory.h"

namespace poinsot::physics {

/// Driven body with its start and the span of time to compute: from_s <= 0 <= to_s.
struct DrivenProblem {
  PrincipalAxes axes;
  Forcing forcing;
  DrivenState start;
  double from_s = 0;
  double to_s = 0;
  double allowedSteps = kMostSteps;
};

/// Run that meets a tolerance, or the best run that was found.
struct ChosenRun {
  const Composition* composition = nullptr;
  DrivenTrajectory forward, backward;  ///< from time 0 to the two ends of the span
  /// Estimated error of the attitude over the whole span: the largest angle between this run and a run with longer
  /// steps, plus the rounding errors that both may have in common.
  double error_rad = 0;
  bool limitedByRounding = false;  ///< the tolerance is not met, and shorter steps would not help
};

/// Integrates the whole span with two step lengths, and shortens both until the results agree to the tolerance or
/// differ only by rounding. Like the true error, the difference includes the effects of chaos, unstable motion and
/// rounding.
/// @throws core::Error(kLimit) if this needs more than mostSteps(), (kPhysics) as pilotPlan() does.
ChosenRun chosenRun(const DrivenProblem& problem, double tolerance_rad);

}  // namespace poinsot::physics
