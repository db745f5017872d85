// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <numbers>

#include "physics/principal_moments.h"

namespace poinsot::physics {

enum class Stability {
  kStable,    ///< a small disturbance circles around the axis
  kUnstable,  ///< a small disturbance grows as e^(rate t)
  kNeutral,   ///< a small disturbance stays or drifts, because another axis has the same moment
};

/// Behaviour of a small disturbance of a steady spin about a principal axis. If the spin is unstable, `rate` is
/// the growth rate lambda (1/s). If the spin is stable, it is the angular frequency of the disturbance (rad/s),
/// otherwise 0.
struct SpinStability {
  Stability kind = Stability::kNeutral;
  double rate = 0;
};

/// Returns the stability of a spin w about axis k, with the other axes i and j. To first order, the components x
/// of omega across k obey x'' = -w² (I_k - I_i)(I_k - I_j)/(I_i I_j) x.
/// Source: lecture, eq (24) to (26), linearised; Landau & Lifshitz, Mechanics, section 37. Checked against the
/// motion in tests/physics/stability_test.cpp.
/// @param spin rad/s, either sign
/// @pre axis is 0, 1 or 2.
/// @throws core::Error(kPhysics) if the spin is not finite.
SpinStability spinStability(const PrincipalMoments& moments, int axis, double spin);

/// Returns the stability of a steady spin omega_P, rad/s, about the principal axis along it.
/// @pre omega_P is along a principal axis, to 1e-12 of its length; all axes across that of a symmetric body are
/// principal.
/// @throws core::Error(kPhysics) if omega_P is not finite.
SpinStability spinStability(const PrincipalMoments& moments, const Eigen::Vector3d& omega_P);

/// Flips of a body that spins about its middle axis, such as a tennis racket. At each flip, omega_2 changes sign,
/// once in each half period of the polhode. omega_2 of a body that only wobbles about another axis changes sign,
/// too: see turnsOver.
struct FlipTimes {
  /// Time between flips, s: half the polhode's period, 2K/lambda. It is 0 for a steady motion, and infinite on the
  /// separatrix.
  double interval_s = 0;
  /// Approximation of interval_s near the separatrix, s: (2/lambda) ln(4/sqrt(mc)). To first order in mc, it is
  /// too short by (mc/(2 lambda)) (ln(4/sqrt(mc)) - 1). If the disturbance is ten times smaller, it is longer by
  /// (2/lambda) ln 10.
  double asymptotic_s = 0;
  double growthRate = 0;     ///< lambda, 1/s
  double complementary = 1;  ///< parameter mc = 1 - k² of the elliptic functions; 0 on the separatrix
  /// Smallest angle between L and the line of the middle axis, in [0, pi/2]; pi/2 for a steady motion. Its tangent
  /// is |m_c/m_2| at m_a = 0, where c is the axis around which the polhode runs.
  double nearestToMiddle_rad = std::numbers::pi / 2;
  /// True if L comes within 20° of the middle axis. The body then seems to spin about this axis for a while, and
  /// flips. (The limit is a choice: beyond 20°, the motion looks like a wide wobble.) False if two moments are
  /// equal.
  bool turnsOver = false;
};

/// Returns the flips of a free motion. Source: DLMF 19.12.1 (K near k = 1).
/// @param omega_P angular velocity at any one time of the motion, rad/s
/// @throws core::Error(kPhysics) if omega_P is not finite.
FlipTimes flipTimes(const PrincipalMoments& moments, const Eigen::Vector3d& omega_P);

/// Returns the time between flips for any direction of L in the body, s. It is FlipTimes::interval_s, or its limit
/// if the spin is steady. For a spin about an extreme axis, the limit is pi divided by the rate of SpinStability.
/// About the middle axis, and across the axis of a symmetric body, the limit is infinite.
/// @param m_P L in principal axes, kg·m²/s
/// @pre the three moments are not all equal, m_P is not 0.
/// @throws core::Error(kPhysics) if m_P is not finite.
double flipInterval(const PrincipalMoments& moments, const Eigen::Vector3d& m_P);

}  // namespace poinsot::physics
