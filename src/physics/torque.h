// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/forcing.h"
#include "physics/principal_axes.h"
#include "physics/rigid_body_state.h"

namespace poinsot::physics {

/// Returns the total torque on a body about its fixed point, in W, N·m: gravity, given torques and drag. It equals
/// the rate of change of L_W. Energy loss inside the body causes no torque.
Eigen::Vector3d torque_W(const Forcing& forcing, const PrincipalAxes& axes, const RigidBodyState& state);

}  // namespace poinsot::physics
