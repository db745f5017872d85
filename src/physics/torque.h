// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/forcing.h"
#include "physics/principal_axes.h"
#include "physics/rigid_body_state.h"

namespace poinsot::physics {

/// Returns the torque of all forcing on a body in this state, about its fixed point, in W, N·m: gravity, given
/// torques and drag. The torque equals the rate of change of L_W. Energy loss inside the body has no torque.
Eigen::Vector3d torque_W(const Forcing& forcing, const PrincipalAxes& axes, const RigidBodyState& state);

}  // namespace poinsot::physics
