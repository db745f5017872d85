// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "physics/forcing_piece.h"
#include "physics/splitting.h"

namespace poinsot::physics {

/// The most steps of a run, unless its caller allows others. As many take half a minute to a minute and a half on
/// one core, the search for the length of the steps included (measured: 12 us a step of the run; with losses, 200
/// us, so that of those there are a fifth).
inline constexpr double kMostSteps = 2e6;

/// Of so many the most with this composition; a run that needs more is refused.
double mostSteps(const Composition& composition, double allowed);

/// A stretch of time that is integrated in equal steps.
struct Stretch {
  ForcingPiece piece;  ///< holds the stretch
  double begin_s = 0;  ///< the end nearer to 0
  double end_s = 0;
  double step_s = 0;    ///< > 0; the longest that the pilot found good, perhaps longer than the stretch
  bool atRest = false;  ///< nothing changes any more
};

/// From 0 to one end of the run.
struct StepPlan {
  std::vector<Stretch> stretches;  ///< in the order in which they are met
  double turned_rad = 0;           ///< integral of |omega|, about
};

/// Local error that the pilot allows itself, as a part of a radian and of the angular momentum.
inline constexpr double kPilotError = 1e-7;

/// Goes from 0 to end_s in steps of such lengths that each is good to kPilotError, and notes the lengths: one for
/// each piece of the forcing where energy is conserved (a structure-preserving method must not change its step
/// then), else one for each part of it.
/// @throws core::Error(kPhysics) where no step is short enough; (kLimit) where mostSteps() are too few.
StepPlan pilotPlan(const Splitting& splitting, const Composition& composition, const DrivenState& start,
                   const std::vector<ForcingPiece>& pieces, bool conservative, double allowedSteps = kMostSteps);

/// The number of equal steps for a stretch whose step is scaled: at least `fewest`.
double stepsIn(const Stretch& stretch, double scale, double fewest);

}  // namespace poinsot::physics
