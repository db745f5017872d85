// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/forcing.h"
#include "physics/principal_axes.h"
#include "physics/rigid_body_state.h"

namespace poinsot::physics {

/// Returns the total torque on a body about its fixed point or its centre of mass, in W, N·m: gravity, given
/// torques, forces at points and drag. It equals the rate of change of L_W. Energy loss inside the body causes no
/// torque.
Eigen::Vector3d torque_W(const Forcing& forcing, const PrincipalAxes& axes, const RigidBodyState& state);

/// Returns a force at the attitude of a state, in W, N. Returns 0 while the force does not act.
Eigen::Vector3d force_W(const PointForce& force, const RigidBodyState& state);

/// Returns the sum of the forces at points of the body that act at the time of a state, in W, N.
Eigen::Vector3d totalForce_W(const Forcing& forcing, const RigidBodyState& state);

/// Returns the torque lever × force of the forces at points of the body, in W, N·m (eq 9).
Eigen::Vector3d torqueOfForces_W(const Forcing& forcing, const RigidBodyState& state);

}  // namespace poinsot::physics
