// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "physics/level_attitude.h"
#include "physics/motion.h"
#include "physics/unaligned_types.h"
#include "scene/scene.h"

namespace poinsot::scene {

/// Returns where L points if the scene gives no orientation. Unless the scene chooses, L points down if a view
/// shows the invariable plane.
physics::Vertical verticalOfL(const Scene& scene);

/// Returns the attitude at motion time 0, a unit quaternion: the scene's, or the shortest turn of L onto
/// verticalOfL().
physics::Quaternion startOrientation(const Scene& scene);

/// Returns omega at motion time 0, in rad/s along the principal axes.
Eigen::Vector3d startOmega_P(const Scene& scene);

/// Returns seconds of motion per second of film: the scene's speed, or automaticPace().
double chosenSpeed(const Scene& scene);

/// Returns the index of the principal axis with the largest component of omega.
int spinAxis(const Eigen::Vector3d& omega_P);

/// Returns omega at motion time 0 as drawn, in rad/s along the principal axes: the scene's omega, with angles
/// enlarged by exaggerate_angles.
/// @throws core::Error(kScene) if enlarged angles would change the kind of motion.
Eigen::Vector3d drawnOmega_P(const Scene& scene);
/// Returns the start whose drawnOmega_P() is `drawn_P`.
Eigen::Vector3d undrawnOmega_P(const Scene& scene, const Eigen::Vector3d& drawn_P);

/// Makes the motion of a scene, valid from from_s to to_s (in either order) and from there to 0. Free if no
/// forcing acts, else integrated to Motion::tolerance_rad.
/// @throws core::Error(kPhysics) for a body or a start without a solution; (kLimit) if it needs more steps than
/// the user allows.
std::unique_ptr<const physics::Motion> makeMotion(const Scene& scene, double from_s, double to_s);

}  // namespace poinsot::scene
