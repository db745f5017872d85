// SPDX-License-Identifier: Apache-2.0
#include "scene/steady_precession.h"

#include <fmt/format.h>

#include "physics/precession_cones.h"

namespace poinsot::scene {

std::string withoutPrecession(const Scene& scene, const std::optional<Rest>& rest) {
  if (!scene.motion.forcing.none())
    return "only free motion precesses steadily about L; here something acts on the body";
  if (rest) return "a body at rest does not precess";
  const physics::PrincipalAxes& axes = scene.body.axes;
  if (physics::precessionCones(axes.moments(), axes.toP(scene.motion.omega_B))) return "";
  const Eigen::Vector3d& I = axes.moments().values();
  return fmt::format(
      "only a symmetric body precesses steadily; all three moments differ here: ({:g}, {:g}, {:g}) kg·m²", I[0],
      I[1], I[2]);
}

}  // namespace poinsot::scene
