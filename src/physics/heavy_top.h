// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/abi.h"
#include "physics/principal_moments.h"

namespace poinsot::physics {

/// Rates of precession at which a heavy top keeps its tilt, rad/s about the vertical.
struct SteadyPrecession {
  double slow = 0;
  double fast = 0;  ///< infinite for a level axis
};

/// How the tilt of a heavy top swings. theta is the angle of k from the vertical.
struct Nutation {
  double leastTilt_rad = 0;
  double mostTilt_rad = 0;
  double period_s = 0;        ///< from one least tilt to the next; infinite when the top only tends to upright
  double precession_rad = 0;  ///< turned about the vertical in a period; infinite with it
};

/// The symmetric top with a fixed point on its axis, in uniform gravity. k: from the fixed point to the centre of
/// mass; I1 across k, I3 along it, both about the fixed point; M g l > 0, N·m. With u = cos theta, omega_3 and the
/// vertical component L_z of L are constant (L_3 = I3 omega_3), and
///
///   u'² = f(u) = (alpha - a u)(1 - u²) - (L_z - L_3 u)²/I1²        a = 2 M g l/I1,  alpha = 2 T'/I1 + a u
///   phi' = (L_z - L_3 u)/(I1 (1 - u²))
///
/// T' the kinetic energy of omega across k. f has the roots u1 <= u2 <= 1 <= u3; u swings between u1 and u2.
/// Source: Landau & Lifshitz, Mechanics, section 35, problem 1; Goldstein, Classical Mechanics, section 5.7.
/// Checked against the integrated motion in tests/physics/heavy_top_test.cpp.
struct HeavyTop {
  Eigen::Vector3d k_P;
  double across = 0;  ///< I1, kg·m²
  double along = 0;   ///< I3, kg·m²
  double weight = 0;  ///< M g l, N·m

  /// The least spin |omega_3| at which the upright top is stable ("sleeps"), rad/s: 2 sqrt(I1 M g l)/I3.
  double sleepingSpin() const;

  /// Rates Omega with I1 cos theta Omega² - I3 omega_3 Omega + M g l = 0; empty for a spin too slow for the tilt.
  /// Of a hanging top (theta > pi/2) the rates have opposite signs. spin: omega_3, rad/s, not 0 for a level axis.
  /// @throws core::Error(kPhysics) for numbers that are not finite.
  std::optional<SteadyPrecession> steadyPrecession(double tilt_rad, double spin) const;

  /// omega_P in rad/s, up_P the upward vertical in the body.
  ///   period = 4 K/sqrt(a (u3 - u1)),  mc = (u3 - u2)/(u3 - u1), and precession by two integrals of the third
  ///   kind.
  /// A start next to steady precession gives the tilts to half the digits only, as it must.
  /// @pre up_P is of unit length.
  /// @throws core::Error(kPhysics) if omega_P is not finite.
  Nutation nutation(const Eigen::Vector3d& omega_P, const Eigen::Vector3d& up_P) const;
};

/// gravity_P: M g r of the centre of mass from the fixed point, N·m. Empty unless r is along a principal axis, to
/// `uneven` of its length or 1e-14, and not 0, and the moments about the other two differ by no more than `uneven`
/// of themselves; then their mean is taken.
/// @throws core::Error(kPhysics) for numbers that are not finite.
std::optional<HeavyTop> heavyTop(const PrincipalMoments& moments, const Eigen::Vector3d& gravity_P,
                                 double uneven = 0);

static_assert(core::laidOut<HeavyTop, 48>());

}  // namespace poinsot::physics
