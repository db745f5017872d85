// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "physics/principal_moments.h"

namespace poinsot::physics {

// Estimates for a body that loses energy at constant L (Forcing::dissipation, m' = alpha m x (m x omega)). They
// hold if the body turns many times while the energy changes. T then falls at the mean rate -alpha <|m x omega|²>.

/// Returns the time in which the angle between L and the axis of largest moment falls by a factor of e, once it is
/// small, s: 2/(alpha L² (1/I1 + 1/I2 - 2/I3)), where I3 is the largest moment. For a symmetric body, the tangent
/// of the angle falls at exactly this rate at any angle. Returns infinity for a sphere.
/// @param alpha as Forcing::dissipation, s/(kg·m²), positive
/// @param L kg·m²/s, positive
double dampingTime(const PrincipalMoments& moments, double alpha, double L);

/// Returns the mean time until the motion reaches the separatrix, s. Returns 0 if L already circles the axis of
/// largest moment, and infinity if the body spins exactly about the axis of smallest moment, or has no separatrix
/// because two moments are equal.
/// @param omega_P angular velocity in principal axes, rad/s, not 0
/// @param alpha as in dampingTime()
/// @throws core::Error(kPhysics) if omega_P is not finite.
double timeToSeparatrix(const PrincipalMoments& moments, const Eigen::Vector3d& omega_P, double alpha);

}  // namespace poinsot::physics
