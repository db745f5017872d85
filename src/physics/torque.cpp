// SPDX-License-Identifier: Apache-2.0
#include "physics/torque.h"

#include "physics/forcing_piece.h"

namespace poinsot::physics {

using Eigen::Vector3d;

Vector3d torque_W(const Forcing& forcing, const PrincipalAxes& axes, const RigidBodyState& state) {
  const Eigen::Matrix3d R_WB = state.q_WB.toRotationMatrix();
  const Vector3d m_P = axes.moments().angularMomentum(axes.toP(state.omega_B));
  const Vector3d drag_B = -axes.toB(forcing.dragRate_P.cwiseProduct(m_P));
  const Vector3d given_B = forcing.torque_B + torqueAt(forcing.torqueHistory_B, state.t_s);
  const Vector3d given_W = forcing.torque_W + torqueAt(forcing.torqueHistory_W, state.t_s);
  const Vector3d gravity_W = (R_WB * forcing.gravity_B).cross(-Vector3d::UnitZ());
  return R_WB * (drag_B + given_B) + given_W + gravity_W;
}

}  // namespace poinsot::physics
