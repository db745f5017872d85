// SPDX-License-Identifier: Apache-2.0
#include "scene/make_motion.h"

#include <algorithm>

#include "physics/driven_motion.h"
#include "physics/free_motion.h"

namespace poinsot::scene {

Eigen::Vector3d directionOfL(const Scene& scene) {
  const bool plane = std::ranges::any_of(scene.views, [](const View& view) { return view.show.plane.visible; });
  const bool down = scene.motion.lPoints == LPoints::kDown || (scene.motion.lPoints == LPoints::kAuto && plane);
  return {0, 0, down ? -1.0 : 1.0};
}

Eigen::Quaterniond startOrientation(const Scene& scene) {
  if (scene.motion.orientation_WB) return *scene.motion.orientation_WB;
  return Eigen::Quaterniond::FromTwoVectors(scene.body.axes.angularMomentum(scene.motion.omega_B),
                                            directionOfL(scene));
}

std::unique_ptr<const physics::Motion> makeMotion(const Scene& scene, double from_s, double to_s) {
  const Motion& motion = scene.motion;
  const Eigen::Quaterniond q0_WB = startOrientation(scene);
  if (motion.forcing.none()) return std::make_unique<physics::FreeMotion>(scene.body.axes, motion.omega_B, q0_WB);
  const physics::TimeSpan span{std::min(from_s, to_s), std::max(from_s, to_s)};
  return std::make_unique<physics::DrivenMotion>(scene.body.axes, motion.omega_B, q0_WB, motion.forcing, span,
                                                 motion.tolerance_rad);
}

}  // namespace poinsot::scene
