// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/abi.h"
#include "physics/principal_moments.h"

namespace poinsot::physics {

/// Two rates of precession about the vertical at which a heavy top keeps its tilt, rad/s. If the axis is level,
/// `fast` is infinite.
struct SteadyPrecession {
  double slow = 0;
  double fast = 0;
};

/// Kinds of nutation, by the path of the axis on a sphere about the fixed point (Goldstein, figure 5.9). With
/// `kWaves`, the axis always precesses in one direction; with `kCusps`, it stops at its least tilt; with `kLoops`,
/// it goes back there.
enum class NutationKind { kSteady, kCusps, kLoops, kWaves };

/// Nutation of a heavy top: the swing of its tilt theta, the angle between k and the vertical. period_s is the
/// time from one least tilt to the next, and precession_rad is the turn about the vertical in this time. Both are
/// infinite if the top approaches the upright position without reaching it.
struct Nutation {
  double leastTilt_rad = 0;
  double mostTilt_rad = 0;
  double period_s = 0;
  double precession_rad = 0;
};

/// Steady precession of a heavy top whose attitude repeats after period_s. Rates in rad/s.
struct ClosedPrecession {
  double precession = 0;
  double spin = 0;  ///< omega_3
  double period_s = 0;
  int turns = 0;  ///< turns about the vertical in period_s
};

/// Symmetric top with a fixed point on its axis, in uniform gravity. k_P is the unit vector from the fixed point
/// to the centre of mass. The moments about the fixed point are I1 (`across`) across k and I3 (`along`) along k,
/// in kg·m². M g l (`weight`) is positive, in N·m. omega_3 and the vertical component L_z of L are constant. With
/// u = cos theta and L_3 = I3 omega_3:
///
///   u'² = f(u) = (alpha - a u)(1 - u²) - (L_z - L_3 u)²/I1²        a = 2 M g l/I1,  alpha = 2 T'/I1 + a u
///   phi' = (L_z - L_3 u)/(I1 (1 - u²))
///
/// T' is the kinetic energy of the part of omega across k. f has the roots u1 <= u2 <= 1 <= u3, and u swings
/// between u1 and u2. Source: Landau & Lifshitz, Mechanics, section 35, problem 1; Goldstein, Classical Mechanics,
/// section 5.7. Checked against the integrated motion in tests/physics/heavy_top_test.cpp.
struct HeavyTop {
  Eigen::Vector3d k_P;
  double across = 0;
  double along = 0;
  double weight = 0;

  /// Returns the least spin |omega_3| at which the upright top is stable ("sleeps"), rad/s: 2 sqrt(I1 M g l)/I3.
  double sleepingSpin() const;

  /// Returns the two rates Omega of steady precession, which solve I1 cos theta Omega² - I3 omega_3 Omega + M g l
  /// = 0. Returns nullopt if the spin is too slow for the tilt. If the top hangs (theta > pi/2), the rates have
  /// opposite signs.
  /// @param spin omega_3, rad/s; 0 gives nullopt for a level axis
  /// @throws core::Error(kPhysics) if a number is not finite.
  std::optional<SteadyPrecession> steadyPrecession(double tilt_rad, double spin) const;

  /// Returns the nutation of the motion that has the given state at any one time:
  ///   period = 4 K/sqrt(a (u3 - u1)),  mc = (u3 - u2)/(u3 - u1)
  /// The precession is computed from two elliptic integrals of the third kind. If the motion is nearly a steady
  /// precession, only half of the digits of the tilts are correct, which no method can avoid.
  /// @param omega_P rad/s
  /// @param up_P upward vertical in the body
  /// @pre up_P is of unit length.
  /// @throws core::Error(kPhysics) if omega_P is not finite.
  Nutation nutation(const Eigen::Vector3d& omega_P, const Eigen::Vector3d& up_P) const;

  /// Returns the kind of nutation of the motion that has the given state at any one time. Angles that differ by
  /// less than 1e-7 rad and rates that are less than 1e-6 of each other count as rounding. Returns nullopt for a
  /// motion through the vertical, or towards it, where no such path exists.
  /// @pre up_P is of unit length.
  /// @throws core::Error(kPhysics) if omega_P is not finite.
  std::optional<NutationKind> nutationKind(const Eigen::Vector3d& omega_P, const Eigen::Vector3d& up_P) const;

  /// Returns the spin omega_3 at which the top precesses steadily at the rate `precession`, rad/s: (M g l + I1 cos
  /// theta Omega²)/(I3 Omega). @pre the rate is not 0.
  /// @throws core::Error(kPhysics) if a number is not finite.
  double spinOfPrecession(double tilt_rad, double precession) const;

  /// Returns the steady precession nearest to the given one, at the same tilt, whose motion repeats in about
  /// `wanted_s`. In m turns about the vertical, the top turns n times about its axis: psi'/phi' = n/m, where
  ///   psi'/phi' = M g l/(I3 Omega²) + (I1/I3 - 1) cos theta
  /// Takes the nearest rate among those whose period is within a quarter of `wanted_s`. If there is none, takes
  /// the least number of turns.
  /// @throws core::Error(kPhysics) if a number is not finite, or for more than 1e6 turns in `wanted_s`
  /// @pre the rate is not 0, wanted_s > 0
  ClosedPrecession nearestClosedPrecession(double tilt_rad, double precession, double wanted_s) const;

  /// Returns omega_P, rad/s, of a top with the spin omega_3 whose axis turns about the vertical at the rate
  /// `precession` and does not nod: omega_3 k + Omega (z - (z·k) k).
  Eigen::Vector3d omegaPrecessing(const Eigen::Vector3d& up_P, double spin, double precession) const;
};

/// Returns the heavy top with these moments and this weight, or nullopt if it is not a symmetric top. The centre
/// of mass must not be at the fixed point, and must lie on a principal axis. It may be off this axis by a fraction
/// max(`uneven`, 1e-14) of its distance from the fixed point. The moments about the other two axes may differ by
/// the fraction `uneven`; their mean is used.
/// @param gravity_P M g r in N·m, where r points from the fixed point to the centre of mass
/// @throws core::Error(kPhysics) if a number is not finite.
std::optional<HeavyTop> heavyTop(const PrincipalMoments& moments, const Eigen::Vector3d& gravity_P,
                                 double uneven = 0);

static_assert(core::laidOut<HeavyTop, 48>());

}  // namespace poinsot::physics
