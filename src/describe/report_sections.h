// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "describe/report.h"
#include "scene/scene.h"

namespace poinsot::describe {

/// Motion times of a scene: 0, where its start is given, and the film.
struct ReportSpan {
  double from_s = 0, to_s = 0;  ///< of the film; to before from where it runs backwards
};

// Each gives what holds for the scene, or an empty section.

/// Mass, centre, tensor, principal axes (eq 13 to 17).
Section bodySection(const scene::Scene& scene);
/// State at motion time 0 (eq 2, 6, 12).
Section startSection(const scene::Scene& scene);
/// Of a body that flies: its path and, where it has a mass, momenta and energies (eq 1 to 10).
Section flightSection(const scene::Scene& scene);
/// Poinsot's construction, polhode, herpolhode, flips (eq 38 to 40): free motion.
Section constructionSection(const scene::Scene& scene);
/// Cones and rates of a free symmetric top (eq 19 to 37); Chandler's period of one with the Earth's shape and
/// spin.
Section symmetricSection(const scene::Scene& scene);
/// Whether a spin about each axis at the present rate is stable (eq 24 to 26).
Section stabilitySection(const scene::Scene& scene);
/// The symmetric top on a pivot, in gravity alone: sleeping, steady precession, nutation.
Section heavyTopSection(const scene::Scene& scene);
/// Time constants of drag; where dissipation alone ends (spin about the axis of largest moment, at the same L).
Section lossSection(const scene::Scene& scene);
/// What was changed of a film that repeats, and by how much (film_loop.h).
Section loopSection(const scene::Scene& scene);
/// How many digits mean something at the end of the run; of driven motion, how it was integrated.
Section accuracySection(const scene::Scene& scene, const ReportSpan& span);

}  // namespace poinsot::describe
