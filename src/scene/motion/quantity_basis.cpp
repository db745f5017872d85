// SPDX-License-Identifier: Apache-2.0
#include "scene/motion/quantity_basis.h"

#include <optional>

namespace poinsot::scene {
namespace {

std::optional<ThrownBody> thrownBody(const Scene& scene) {
  if (!scene.motion.flight) return std::nullopt;
  ThrownBody thrown{.flight = *scene.motion.flight};
  if (scene.body.mass) thrown.mass_kg = scene.body.mass->mass_kg();
  return thrown;
}

}  // namespace

QuantityBasis quantityBasis(const Scene& scene, const physics::Motion& motion) {
  const physics::RigidBodyState start = motion.at(scene.time.start_s);
  // The axis k of a rolling cone points to its base, as the figures draw it.
  const Eigen::Vector3d sense_B = scene.motion.rolling ? scene.motion.rolling->cone.axis_B : start.omega_B;
  QuantityBasis basis(motion.axes(), scene.motion.forcing, motion.axes().toP(sense_B), thrownBody(scene));
  basis.follow(motion);
  return basis;
}

}  // namespace poinsot::scene
