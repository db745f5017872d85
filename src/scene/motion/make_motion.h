// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "physics/level_attitude.h"
#include "physics/motion.h"
#include "physics/unaligned_types.h"
#include "scene/scene.h"

namespace poinsot::scene {

/// Where L points when the scene gives no orientation: straight down or up. Unless the scene chooses, down if a
/// view shows the invariable plane.
physics::Vertical verticalOfL(const Scene& scene);

/// Attitude at motion time 0: the scene's, or the shortest turn of L onto verticalOfL(). Unit.
physics::Quaternion startOrientation(const Scene& scene);

/// omega at motion time 0, rad/s in principal axes.
Eigen::Vector3d startOmega_P(const Scene& scene);

/// Seconds of motion per second of film: the scene's, or one that the eye follows: of omega, and of a heavy top's
/// precession.
double chosenSpeed(const Scene& scene);

/// The principal axis that omega is about most.
int spinAxis(const Eigen::Vector3d& omega_P);

/// omega at motion time 0 as it is drawn, rad/s in principal axes: the scene's, or with larger angles where it
/// says so.
/// @throws core::Error(kScene) where larger angles would be another kind of motion.
Eigen::Vector3d drawnOmega_P(const Scene& scene);
/// The start that is drawn so: its inverse.
Eigen::Vector3d undrawnOmega_P(const Scene& scene, const Eigen::Vector3d& drawn_P);

/// The motion that a scene describes, known between two motion times (in either order) and between them and 0.
/// Free where nothing acts on the body, else integrated to Motion::tolerance_rad.
/// @throws core::Error(kPhysics) for a body or a start that has no solution; (kLimit) for more steps than the user
/// allows.
std::unique_ptr<const physics::Motion> makeMotion(const Scene& scene, double from_s, double to_s);

}  // namespace poinsot::scene
