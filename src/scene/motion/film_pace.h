// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "scene/keys/findings.h"
#include "scene/scene.h"

namespace poinsot::scene {

/// Returns a pace at which the eye can follow the motion, in seconds of motion per second of film. The pace
/// depends on |omega| at the start or, if faster, on the swing of the hanging body. For a heavy top it is higher
/// if the precession would otherwise hardly be visible.
double automaticPace(const Scene& scene);

/// Returns the mean time in which the axis of a heavy top rotates once about the vertical, in s. Computed from the
/// start, for the symmetric top that is most similar to the body, without drag and dissipation. Empty if no
/// precession is visible: without gravity, with another torque, for an axis within 1 deg of the vertical, or for a
/// pendulum.
std::optional<double> precessionPeriod_s(const Scene& scene);

/// Adds a note if the film shows less than a tenth of a turn of the precession.
/// @pre a scene without problems
void doubtPrecession(const Scene& scene, Findings& findings);

/// Adds a note for each force that never acts between motion time 0 and the ends of the film.
/// @pre a scene without problems
void doubtForces(const Scene& scene, Findings& findings);

}  // namespace poinsot::scene
