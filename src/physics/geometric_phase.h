// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/abi.h"
#include "physics/principal_moments.h"

namespace poinsot::physics {

/// Montgomery's phase: the angle by which a free body is turned about L after one period Tp of its polhode, when L
/// is at the same place in the body again. R(Tp) R(0)^-1 is the rotation about L by
///
///   turn_rad = dynamic_rad + geometric_rad,   dynamic_rad = 2 T Tp/L,   geometric_rad = -sense solidAngle_sr
///
/// Angles are not reduced, but only turn_rad modulo 2 pi shows in the attitude. Source: R. Montgomery, Am. J.
/// Phys. 59 (1991) 394. Checked against the attitude in tests/physics/geometric_phase_test.cpp.
struct GeometricPhase {
  double period_s = 0;  ///< Tp = 4K/lambda
  double turn_rad = 0;  ///< computed from the angle of the herpolhode, without the solid angle
  double dynamic_rad = 0;
  double geometric_rad = 0;
  /// Solid angle, in (0, 2 pi), of the part of the momentum sphere |m| = L that the polhode encloses, on the side
  /// of the principal axis that it circles.
  double solidAngle_sr = 0;
  /// 1 if L circles its principal axis counter-clockwise, seen from the tip of the axis; -1 if clockwise. It is 1
  /// for a polhode about the axis of largest moment, and -1 about the axis of smallest moment.
  int sense = 1;
};

/// Returns the phase of a free rotation; nullopt if L stands still in the body, or on the separatrix, whose period
/// is infinite. No digits are lost for small polhodes or next to the separatrix.
/// @param omega0_P angular velocity in principal axes, rad/s
/// @throws core::Error(kPhysics) if omega0_P is not finite.
std::optional<GeometricPhase> geometricPhase(const PrincipalMoments& moments, const Eigen::Vector3d& omega0_P);

static_assert(core::laidOut<GeometricPhase, 48>());

}  // namespace poinsot::physics
