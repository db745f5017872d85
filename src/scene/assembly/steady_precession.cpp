// SPDX-License-Identifier: Apache-2.0
#include "scene/assembly/steady_precession.h"

#include <fmt/format.h>

#include <algorithm>

#include "physics/precession_cones.h"

namespace poinsot::scene {

std::string withoutPrecession(const Scene& scene, const std::optional<Rest>& rest) {
  if (!scene.motion.isFree())
    return "only free motion precesses steadily about L; here something acts on the body";
  if (rest) return "a body at rest does not precess";
  const physics::PrincipalAxes& axes = scene.body.axes;
  if (physics::precessionCones(axes.moments(), axes.toP(scene.motion.omega_B))) return "";
  const Eigen::Vector3d& I = axes.moments().values();
  const std::string differ = fmt::format(
      "only a symmetric body precesses steadily; all three moments differ here: ({:g}, {:g}, {:g}) kg·m²", I[0],
      I[1], I[2]);
  constexpr double kSeen = 1e-5;  // larger differences are visible in the printed moments
  const double least = std::min(I[1] - I[0], I[2] - I[1]) / I[1];
  return least > kSeen ? differ : fmt::format("{}, two of them by a relative {:.1g}", differ, least);
}

}  // namespace poinsot::scene
