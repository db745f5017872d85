// SPDX-License-Identifier: Apache-2.0
#include "scene/assembly/steady_precession.h"

#include <fmt/format.h>

#include <algorithm>

#include "physics/polhode.h"
#include "physics/precession_cones.h"

namespace poinsot::scene {
namespace {

std::optional<physics::PrecessionCones> precessionOf(const Scene& scene) {
  const physics::PrincipalAxes& axes = scene.body.axes;
  return physics::precessionCones(axes.moments(), axes.toP(scene.motion.omega_B));
}

}  // namespace

std::string withoutPrecession(const Scene& scene, const std::optional<Rest>& rest) {
  if (!scene.motion.isFree())
    return "only free motion precesses steadily about L; here something acts on the body";
  if (rest) return "a body at rest does not precess";
  if (precessionOf(scene)) return "";
  const Eigen::Vector3d& I = scene.body.axes.moments().values();
  const std::string differ = fmt::format(
      "only a symmetric body precesses steadily; all three moments differ here: ({:g}, {:g}, {:g}) kg·m²", I[0],
      I[1], I[2]);
  constexpr double kSeen = 1e-5;  // larger differences are visible in the printed moments
  const double least = std::min(I[1] - I[0], I[2] - I[1]) / I[1];
  return least > kSeen ? differ : fmt::format("{}, two of them by a relative {:.1g}", differ, least);
}

std::string withoutTriad(const Scene& scene, const std::optional<Rest>& rest) {
  if (std::string why = withoutPrecession(scene, rest); !why.empty()) return why;
  if (precessionOf(scene)->tilt_rad > 0) return "";
  return "L lies along the axis k here, and they have no common plane; start with a rotation that is not about k";
}

std::string withoutCones(const Scene& scene, const std::optional<Rest>& rest) {
  if (!scene.motion.isFree() || rest || precessionOf(scene)) return withoutPrecession(scene, rest);
  const physics::PrincipalAxes& axes = scene.body.axes;
  switch (physics::Polhode(axes.moments(), axes.toP(scene.motion.omega_B)).regime()) {
    case physics::PolhodeRegime::kSteady:
      return "a spin about a principal axis is steady, and omega draws no cone; start with a rotation about "
             "another axis";
    case physics::PolhodeRegime::kSeparatrix:
      return "this start is on the separatrix, where omega draws no closed cone in the body; change the start";
    default:
      return "";
  }
}

}  // namespace poinsot::scene
