// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/forcing.h"
#include "physics/principal_axes.h"
#include "physics/rigid_body_state.h"

namespace poinsot::physics {

/// All of the forcing's torque on a body in that state, about its fixed point, in W, N·m: gravity, given torques
/// and drag; the rate of change of L_W. A loss of energy inside the body has none.
Eigen::Vector3d torque_W(const Forcing& forcing, const PrincipalAxes& axes, const RigidBodyState& state);

}  // namespace poinsot::physics
