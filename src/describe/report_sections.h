// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "describe/report.h"
#include "scene/scene.h"

namespace poinsot::describe {

/// Motion times at which the film begins and ends; the state is given at motion time 0.
struct ReportSpan {
  double from_s = 0, to_s = 0;  ///< to_s < from_s if the film runs backwards
};

// Each function returns an empty section if its subject does not apply to the scene.

/// Returns the mass, centre of mass, inertia tensor and principal axes (eq 13 to 17).
Section bodySection(const scene::Scene& scene);
/// Returns the state at motion time 0 (eq 2, 6, 12).
Section startSection(const scene::Scene& scene);
/// Returns the flight of a thrown body and, if its mass is given, momenta and energies (eq 1 to 10).
Section flightSection(const scene::Scene& scene);
/// Returns Poinsot's construction, polhode, herpolhode and flips of a free motion (eq 38 to 40).
Section constructionSection(const scene::Scene& scene);
/// Returns cones and rates of a free symmetric top (eq 19 to 37), with Chandler's period for a top with the
/// Earth's shape and spin.
Section symmetricSection(const scene::Scene& scene);
/// Reports whether a spin about each principal axis at the present |omega| is stable (eq 24 to 26).
Section stabilitySection(const scene::Scene& scene);
/// Returns sleeping spin, steady precession and nutation of a symmetric top on a pivot in gravity alone.
Section heavyTopSection(const scene::Scene& scene);
/// Returns time constants of drag and, if dissipation acts alone, the final spin: about the axis of largest
/// moment, at the same |L|.
Section lossSection(const scene::Scene& scene);
/// Returns what was changed to make the film repeat, and by how much (film_loop.h).
Section loopSection(const scene::Scene& scene);
/// Returns the film's motion times and pace, with the meaningful digits at the end of a free motion or the
/// integration statistics of a driven one.
Section accuracySection(const scene::Scene& scene, const ReportSpan& span);

}  // namespace poinsot::describe
