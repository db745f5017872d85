// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "describe/report.h"
#include "physics/motion.h"
#include "scene/scene.h"

namespace poinsot::describe {

/// Motion times of the film's first and last frame. The scene's initial state is given at motion time 0.
struct ReportSpan {
  double from_s = 0, to_s = 0;  ///< to_s < from_s if the film is played backwards
};

// Sections of the report. Each function returns an empty section if its subject does not apply to the scene.

/// Returns the mass, centre of mass, inertia tensor and principal axes (eq 13 to 17).
Section bodySection(const scene::Scene& scene);
/// Returns the tensor along the axes that [body.own_axes] gives, and the matrix U of these axes (eq 15, 16).
Section ownAxesSection(const scene::Scene& scene);
/// Returns the state at motion time 0 (eq 2, 6, 12).
Section startSection(const scene::Scene& scene);
/// Returns the flight of a thrown body. If the mass is given, also momenta and energies (eq 1 to 10).
Section flightSection(const scene::Scene& scene);
/// Returns the forces at points of the body, their sum and their torque at motion time 0 and, if this is another
/// time, at the film's start (eq 1, 8, 9).
/// @param motion  motion of the scene over the span
Section forcesSection(const scene::Scene& scene, const physics::Motion& motion, const ReportSpan& span);
/// Returns the terms of L_tot for the reference point K by which the body is thrown (eq 4).
Section referencePointSection(const scene::Scene& scene);
/// Returns Poinsot's construction, polhode, herpolhode and flips of a free motion (eq 38 to 40).
Section constructionSection(const scene::Scene& scene);
/// Returns cones and rates of a free symmetric top (eq 19 to 37). If the top has the Earth's shape and spin, also
/// Chandler's period.
Section symmetricSection(const scene::Scene& scene);
/// Returns whether a spin about each principal axis, at the scene's |omega|, would be stable (eq 24 to 26).
Section stabilitySection(const scene::Scene& scene);
/// Returns sleeping spin, steady precession and nutation of a symmetric top on a pivot, if only gravity acts.
Section heavyTopSection(const scene::Scene& scene);
/// Returns the two parts of omega, L and the forces of a cone that rolls on a table.
Section rollingSection(const scene::Scene& scene);
/// Returns time constants of drag. If only dissipation acts, also its damping time, the time of crossing the
/// separatrix, and the final spin, which is about the axis of largest moment and has the same |L|.
/// @param motion  motion of the scene over the span
Section lossSection(const scene::Scene& scene, const physics::Motion& motion, const ReportSpan& span);
/// Returns the changes that make the film repeat, with their amounts (film_loop.h).
Section loopSection(const scene::Scene& scene);
/// Returns the motion times and film times of the events in the film: flips, crossings of the separatrix, turning
/// points of the nutation, the highest point of a flight.
/// @param motion  motion of the scene over the span
Section eventsSection(const scene::Scene& scene, const physics::Motion& motion, const ReportSpan& span);
/// Returns motion times and pace of the film, and its accuracy: for a free motion, the meaningful digits at the
/// end; for a driven motion, the statistics of the integration.
/// @param motion  motion of the scene over the span
Section accuracySection(const scene::Scene& scene, const physics::Motion& motion, const ReportSpan& span);

}  // namespace poinsot::describe
