// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <numbers>

#include "physics/principal_moments.h"

namespace poinsot::physics {

enum class Stability {
  kStable,    ///< a small disturbance circles the axis
  kUnstable,  ///< it grows as e^(rate t)
  kNeutral,   ///< it stays or drifts: another axis has the same moment
};

/// What becomes of a small disturbance of a steady spin about a principal axis.
struct SpinStability {
  Stability kind = Stability::kNeutral;
  double rate = 0;  ///< unstable: growth lambda, 1/s; stable: angular frequency of the circling, rad/s; else 0
};

/// For the spin w about axis k, and i, j the other axes: x'' = -w² (I_k - I_i)(I_k - I_j)/(I_i I_j) x for the
/// components x of omega across k, to first order.
/// Source: lecture, eq (24) to (26), linearised; Landau & Lifshitz, Mechanics, section 37. Checked against the
/// motion in tests/physics/stability_test.cpp. spin in rad/s, either sign. @pre axis is 0, 1 or 2.
/// @throws core::Error(kPhysics) if the spin is not finite.
SpinStability spinStability(const PrincipalMoments& moments, int axis, double spin);

/// Returns the stability of a steady spin omega_P, rad/s, about the principal axis that it is along.
/// @pre omega_P is along a principal axis, to 1e-12 of its length; across the axis of a symmetric body each is
/// one.
/// @throws core::Error(kPhysics) if omega_P is not finite.
SpinStability spinStability(const PrincipalMoments& moments, const Eigen::Vector3d& omega_P);

/// Flips of a body that spins about its middle axis (tennis racket, T-handle): omega_2 changes sign once in each
/// half period of the polhode. It does so too where the body only wobbles about another axis: see turnsOver.
struct FlipTimes {
  /// Half the polhode's period, s: 2K/lambda. 0 for a steady motion, infinite on the separatrix.
  double interval_s = 0;
  /// (2/lambda) ln(4/sqrt(mc)), s: what it tends to near the separatrix, too short by
  /// (mc/(2 lambda)) (ln(4/sqrt(mc)) - 1) to first order in mc. Each decade of the disturbance adds (2/lambda)
  /// ln 10.
  double asymptotic_s = 0;
  double growthRate = 0;     ///< lambda, 1/s
  double complementary = 1;  ///< mc = 1 - k² of the elliptic functions: 0 on the separatrix
  /// Smallest angle between L and the line of the middle axis, in [0, pi/2]: tan of it |m_c/m_2| at m_a = 0 (c the
  /// axis that the polhode goes round). pi/2 for a steady motion.
  double nearestToMiddle_rad = std::numbers::pi / 2;
  /// L comes within 20° of the middle axis, so that the body is seen to spin about it for a while and then to
  /// flip. (The bound is a choice: from about there on it looks like a wide wobble.) Never where two moments are
  /// equal.
  bool turnsOver = false;
};

/// omega_P in rad/s at any one time of the motion. Source: DLMF 19.12.1 (K near k = 1).
/// @throws core::Error(kPhysics) if it is not finite.
FlipTimes flipTimes(const PrincipalMoments& moments, const Eigen::Vector3d& omega_P);

/// Time between flips for any direction of L in the body, s: FlipTimes::interval_s, and at a steady spin what it
/// tends to: pi over the rate of SpinStability about an extreme axis, infinity about the middle one and across the
/// axis of a symmetric body. m_P = L in principal axes, kg·m²/s.
/// @pre the three moments are not all equal, m_P is not 0.
/// @throws core::Error(kPhysics) if m_P is not finite.
double flipInterval(const PrincipalMoments& moments, const Eigen::Vector3d& m_P);

}  // namespace poinsot::physics
