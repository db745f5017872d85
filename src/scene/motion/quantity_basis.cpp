// SPDX-License-Identifier: Apache-2.0
#include "scene/motion/quantity_basis.h"

#include <optional>

#include "physics/precession_cones.h"

namespace poinsot::scene {
namespace {

std::optional<ThrownBody> thrownBody(const Scene& scene) {
  if (!scene.motion.flight) return std::nullopt;
  ThrownBody thrown{.flight = *scene.motion.flight};
  if (!scene.body.mass) return thrown;
  thrown.mass_kg = scene.body.mass->mass_kg();
  if (scene.motion.thrownBy_B) thrown.point = {*scene.body.mass, *scene.motion.thrownBy_B};
  return thrown;
}

}  // namespace

std::string lackFor(const StateQuantity& quantity, const Scene& scene) {
  const Motion& motion = scene.motion;
  switch (quantity.needs) {
    case QuantityNeeds::kNothing:
      return "";
    case QuantityNeeds::kFreeSymmetricBody: {
      if (!motion.isFree()) return "exists only for a body on which nothing acts";
      const auto cones = physics::precessionCones(scene.body.axes.moments(), Eigen::Vector3d::UnitZ());
      return cones ? "" : "exists only for a symmetric body; give two equal principal moments";
    }
    default:
      break;
  }
  if (!motion.flight) return "exists only for a thrown body; give [motion.flight]";
  if (quantity.needs == QuantityNeeds::kFlightByPoint && !motion.thrownBy_B)
    return "exists only for a body that is thrown by a point; give motion.flight.point";
  if (quantity.needs != QuantityNeeds::kFlight && !scene.body.mass)
    return "needs a body with a mass; give body.mass in addition to the moments of inertia";
  return "";
}

QuantityBasis quantityBasis(const Scene& scene, const physics::Motion& motion) {
  const physics::RigidBodyState start = motion.at(scene.time.start_s);
  // The axis k of a rolling cone points to its base, as the figures draw it.
  const Eigen::Vector3d sense_B = scene.motion.rolling ? scene.motion.rolling->cone.axis_B : start.omega_B;
  QuantityBasis basis(motion.axes(), scene.motion.forcing, motion.axes().toP(sense_B), thrownBody(scene));
  basis.follow(motion);
  return basis;
}

}  // namespace poinsot::scene
