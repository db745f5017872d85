// SPDX-License-Identifier: Apache-2.0
#include "physics/torque.h"

#include "physics/fixed_order.h"
#include "physics/forcing_piece.h"
#include "physics/rotor.h"

namespace poinsot::physics {

using Eigen::Vector3d;

Vector3d torque_W(const Forcing& forcing, const PrincipalAxes& axes, const RigidBodyState& state) {
  const Eigen::Matrix3d R_WB = state.q_WB.toRotationMatrix();
  const Vector3d m_P = axes.moments().angularMomentum(axes.toP(state.omega_B));
  const Vector3d drag_B = -axes.toB(forcing.dragRate_P.cwiseProduct(m_P));
  const Vector3d given_B = forcing.torque_B + torqueAt(forcing.torqueHistory_B, state.t_s);
  const Vector3d given_W = forcing.torque_W + torqueAt(forcing.torqueHistory_W, state.t_s);
  const Vector3d gravity_W = (R_WB * forcing.gravity_B).cross(-Vector3d::UnitZ());
  const Vector3d torque_W = R_WB * (drag_B + given_B) + given_W + gravity_W;
  return forcing.forces.empty() ? torque_W : Vector3d(torque_W + torqueOfForces_W(forcing, state));
}

Vector3d force_W(const PointForce& force, const RigidBodyState& state) {
  if (!force.actsAt(state.t_s)) return Vector3d::Zero();
  return rotated(state.q_WB, force.force_B) + force.force_W;
}

Vector3d totalForce_W(const Forcing& forcing, const RigidBodyState& state) {
  Vector3d sum = Vector3d::Zero();
  for (const PointForce& force : forcing.forces) sum += force_W(force, state);
  return sum;
}

Vector3d torqueOfForces_W(const Forcing& forcing, const RigidBodyState& state) {
  Vector3d sum = Vector3d::Zero();
  for (const PointForce& force : forcing.forces)
    sum += crossProduct(rotated(state.q_WB, force.lever_B), force_W(force, state));
  return sum;
}

}  // namespace poinsot::physics
