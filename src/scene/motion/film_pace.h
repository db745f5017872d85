// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "scene/keys/findings.h"
#include "scene/scene.h"

namespace poinsot::scene {

/// Chooses a pace that the eye can follow, in seconds of motion per second of film. It depends on |omega| at the
/// start or, if faster, on the swing of a hanging body. A higher pace is chosen if the precession of a heavy top
/// would otherwise hardly be visible.
double automaticPace(const Scene& scene);

/// Returns the mean time in which the axis of a heavy top goes once round the vertical, in s. Computed from the
/// start for the symmetric top nearest to the body, without drag and dissipation. Empty if no precession is
/// visible: no gravity, another torque, an axis within 1 deg of the vertical, or a pendulum.
std::optional<double> precessionPeriod_s(const Scene& scene);

/// Adds a note if the film shows less than a tenth of a turn of the precession. @pre a scene without problems
void doubtPrecession(const Scene& scene, Findings& findings);

}  // namespace poinsot::scene
