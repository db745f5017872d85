// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "physics/flight_path.h"
#include "physics/level_attitude.h"
#include "physics/motion.h"
#include "physics/unaligned_types.h"
#include "scene/scene.h"

namespace poinsot::scene {

/// Returns whether L points up or down if the scene gives no orientation. If the scene does not choose, L points
/// down if a view shows the invariable plane, and up otherwise.
physics::Vertical verticalOfL(const Scene& scene);

/// Returns the attitude at motion time 0, as a unit quaternion. If the scene gives none, this is the shortest
/// rotation that makes L point to verticalOfL().
physics::Quaternion startOrientation(const Scene& scene);

/// Returns omega at motion time 0, in rad/s along the principal axes.
Eigen::Vector3d startOmega_P(const Scene& scene);

/// Returns the scene's speed, or automaticPace() if it has none, in seconds of motion per second of film.
double chosenSpeed(const Scene& scene);

/// Returns the index of the principal axis with the largest component of omega.
int spinAxis(const Eigen::Vector3d& omega_P);

/// Returns omega at motion time 0 as the picture shows it, in rad/s along the principal axes. The key
/// exaggerate_angles enlarges the angles between omega and its principal axis.
/// @throws core::Error(kScene) if the enlarged angles would change the kind of motion.
Eigen::Vector3d drawnOmega_P(const Scene& scene);
/// Returns the omega for which drawnOmega_P() returns `drawn_P`.
Eigen::Vector3d undrawnOmega_P(const Scene& scene, const Eigen::Vector3d& drawn_P);

/// Returns the flight of a thrown body under gravity and forces, over the span of its motion; nullopt for a body
/// that is not thrown.
/// @throws core::Error(kLimit) as physics::FlightPath does.
std::optional<physics::FlightPath> flightPath(const Scene& scene, const physics::Motion& motion);

/// Makes the motion of a scene. The motion is valid at all times between 0, from_s and to_s, in any order. If no
/// forcing acts, or a cone rolls, the motion is exact; otherwise it is integrated to Motion::tolerance_rad.
/// @throws core::Error(kPhysics) for a body or a start without a solution; core::Error(kLimit) if the integration
/// needs more steps than the user allows.
std::unique_ptr<const physics::Motion> makeMotion(const Scene& scene, double from_s, double to_s);

}  // namespace poinsot::scene
