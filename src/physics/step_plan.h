// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "physics/forcing_piece.h"
#include "physics/splitting.h"

namespace poinsot::physics {

/// Default limit of the steps of a run. This many steps take 0.5 to 1.5 minutes on one core, including the search
/// for their length. Measured: 12 us for each step of the run; 200 us with losses, which therefore get a fifth of
/// the steps.
inline constexpr double kMostSteps = 2e6;

/// Returns the limit of steps with a composition: a fifth of `allowed` for symmetric steps, otherwise `allowed`.
double mostSteps(const Composition& composition, double allowed);

/// Stretch of time within one forcing piece, integrated in equal steps.
struct Stretch {
  ForcingPiece piece;
  double begin_s = 0;  ///< end nearer to time 0
  double end_s = 0;
  double step_s = 0;  ///< > 0; accepted by the pilot, may exceed the stretch
  bool atRest = false;
};

/// Step lengths from time 0 to one end of the run, in the order of integration.
struct StepPlan {
  std::vector<Stretch> stretches;
  double turned_rad = 0;  ///< approximate integral of |omega|
};

/// Largest local error of a pilot step: angle in rad plus relative error of the angular momentum.
inline constexpr double kPilotError = 1e-7;

/// Integrates the pieces in steps that are each accurate to kPilotError, and records the step lengths. If energy
/// is conserved, each piece gets one length, because a structure-preserving method must not change its step.
/// Otherwise each part of a piece gets its own length.
/// @throws core::Error(kPhysics) if no step is short enough, (kLimit) if mostSteps() are too few.
StepPlan pilotPlan(const Splitting& splitting, const Composition& composition, const DrivenState& start,
                   const std::vector<ForcingPiece>& pieces, bool conservative, double allowedSteps = kMostSteps);

/// Returns the number of equal steps, at least `fewest`, for a stretch whose step is scaled.
double stepsIn(const Stretch& stretch, double scale, double fewest);

}  // namespace poinsot::physics
