// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "physics/forcing_piece.h"
#include "physics/splitting.h"

namespace poinsot::physics {

/// Default limit on the number of steps of a run. So many steps take 0.5 to 1.5 minutes on one core, including the
/// search for their length. Measured: 12 us for each step of the run, and 200 us with losses. Runs with losses
/// therefore get a fifth of the steps.
inline constexpr double kMostSteps = 2e6;

/// Returns the limit on the number of steps with a composition: a fifth of `allowed` for compositions of symmetric
/// steps, otherwise `allowed`.
double mostSteps(const Composition& composition, double allowed);

/// Time interval within one forcing piece, integrated in equal steps.
struct Stretch {
  ForcingPiece piece;
  double begin_s = 0;  ///< end of the interval nearer to time 0
  double end_s = 0;
  double step_s = 0;  ///< step length accepted by the pilot, > 0; may exceed the interval
  bool atRest = false;
};

/// Step lengths from time 0 to one end of the run, in the order of integration.
struct StepPlan {
  std::vector<Stretch> stretches;
  double turned_rad = 0;  ///< approximate integral of |omega| over time
};

/// Largest local error of a pilot step: angle in rad plus relative error of the angular momentum.
inline constexpr double kPilotError = 1e-7;

/// Integrates the pieces in steps that are each accurate to kPilotError, and records the step lengths. If energy
/// is conserved, each piece gets one step length, because a structure-preserving method must not change its step.
/// Otherwise a piece is divided into parts, and each part gets its own step length.
/// @throws core::Error(kPhysics) if no step is short enough, (kLimit) if mostSteps() are too few.
StepPlan pilotPlan(const Splitting& splitting, const Composition& composition, const DrivenState& start,
                   const std::vector<ForcingPiece>& pieces, bool conservative, double allowedSteps = kMostSteps);

/// Returns the number of equal steps for a stretch, if its planned step length is multiplied by `scale`. Returns
/// at least `fewest`.
double stepsIn(const Stretch& stretch, double scale, double fewest);

}  // namespace poinsot::physics
