// SPDX-License-Identifier: Apache-2.0
#include "physics/flight.h"

#include <cmath>

#include "physics/fixed_order.h"
#include "physics/motion.h"

namespace poinsot::physics {
namespace {

Eigen::Vector3d finite(const Eigen::Vector3d& v_W, double t_s) {
  if (!v_W.allFinite()) refuseTime(t_s);
  return v_W;
}

}  // namespace

Eigen::Vector3d Flight::positionAt(double t_s) const {
  return finite(position_W + t_s * (velocity_W + 0.5 * t_s * gravity_W), t_s);
}

Eigen::Vector3d Flight::velocityAt(double t_s) const { return finite(velocity_W + t_s * gravity_W, t_s); }

FlightTop Flight::top() const {
  if (gravity_W.isZero(0)) return {};
  const double g = gravity_W.norm(), up = -dotProduct(velocity_W, gravity_W) / g;
  return {up / g, 0.5 * up * up / g};
}

FlightQuantities flightQuantities(double mass_kg, const Flight& flight, const RigidBodyState& state) {
  const Eigen::Vector3d position_W = flight.positionAt(state.t_s), velocity_W = flight.velocityAt(state.t_s);
  FlightQuantities q;
  q.P_W = mass_kg * velocity_W;
  q.orbital_W = crossProduct(position_W, q.P_W);
  q.intrinsic_W = state.L_W;
  q.total_W = q.orbital_W + q.intrinsic_W;
  q.force_W = mass_kg * flight.gravity_W;
  q.torque_W = crossProduct(position_W, q.force_W);
  q.translationalEnergy = 0.5 * mass_kg * dotProduct(velocity_W, velocity_W);
  q.rotationalEnergy = state.kineticEnergy;
  q.potentialEnergy = -dotProduct(q.force_W, position_W);
  // If the mass is unknown (NaN), these quantities are NaN at every time, which is not an error.
  if (!std::isnan(mass_kg) &&
      !(q.total_W.allFinite() && q.torque_W.allFinite() && std::isfinite(q.kineticEnergy() + q.potentialEnergy)))
    refuseTime(state.t_s);
  return q;
}

}  // namespace poinsot::physics
