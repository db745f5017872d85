// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "physics/motion.h"
#include "scene/scene.h"

namespace poinsot::scene {

/// Where L is turned to when the scene gives no orientation: straight down or up,
/// by itself down where a view shows the invariable plane.
Eigen::Vector3d directionOfL(const Scene& scene);

/// Attitude at motion time 0: the scene's, or the one that turns L onto directionOfL(). Unit.
Eigen::Quaterniond startOrientation(const Scene& scene);

/// The motion that a scene describes, known between two motion times (in either order) and between them and 0.
/// Free where nothing acts on the body, else integrated to Motion::tolerance_rad.
/// @throws core::Error(kPhysics) for a body or a start that has no solution.
std::unique_ptr<const physics::Motion> makeMotion(const Scene& scene, double from_s, double to_s);

}  // namespace poinsot::scene
