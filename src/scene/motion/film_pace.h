// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "scene/keys/findings.h"
#include "scene/scene.h"

namespace poinsot::scene {

/// Seconds of motion per second of film that the eye follows: chosen from |omega| at the start or, if that is
/// faster, from the swing of a body that hangs; and faster where the precession of a heavy top would otherwise
/// hardly be seen to go round.
double automaticPace(const Scene& scene);

/// Mean time in which the axis of a heavy top goes once round the vertical, s. Computed for the top as it is let
/// go, without drag and dissipation, and for the symmetric top nearest to the body. Empty where nothing is seen to
/// go round: no gravity, another torque beside it, an axis that stays within 1 deg of the vertical, a pendulum.
std::optional<double> precessionPeriod_s(const Scene& scene);

/// Notes a film that shows less than a tenth of a turn of that precession. @pre a scene without problems
void doubtPrecession(const Scene& scene, Findings& findings);

}  // namespace poinsot::scene
