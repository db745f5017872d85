// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/double_double.h"
#include "physics/polhode_regime.h"
#include "physics/scaled_start.h"

namespace poinsot::physics {

/// Constants of one free rotation, accurate to about 100 bits. The motion, the polhode and the herpolhode use
/// them.
///
/// Units and axes are those of `start`. The polhode runs around axis c; a is the other extreme axis, and 2 is the
/// middle axis. With sigma, the sign of omega_c:
///
///   m_a = A_a cn u,  m_2 = sigma A_2 sn u,  m_c = sigma A_c dn u,     u = lambda t + u0,  parameter mc = 1 - k^2
///
/// Source: Landau & Lifshitz, Mechanics, section 37, rewritten so that nothing cancels. The attitude is computed
/// in free_motion.cpp. Checked against an independent integrator in tests/physics/free_motion_oracle_test.cpp.
struct FreeMotionConstants {
  ScaledStart start;
  PolhodeRegime regime = PolhodeRegime::kSteady;

  DoubleDouble L;
  DoubleDouble twoT;
  DoubleDouble D1;  ///< L^2 - 2 T I1 >= 0
  DoubleDouble D3;  ///< 2 T I3 - L^2 >= 0
  DoubleDouble D;   ///< L^2 - 2 T I2, with full relative accuracy even if tiny

  // The fields below are not set for a steady rotation.
  std::size_t a = 0;
  std::size_t c = 2;
  double s = 1;  ///< -1 for a motion about the axis of smallest moment, otherwise +1
  double sigma = 1;
  double sigmaA = 1;  ///< on the separatrix, the sign of m_a and of sigma m_2; otherwise 1
  DoubleDouble lambda;
  DoubleDouble mc;
  DoubleDouble g;
  DoubleDouble p;
  DoubleDouble A_a, A_2, A_c;
  DoubleDouble sn0, cn0;
  DoubleDouble u0;
  DoubleDouble K;  ///< quarter period of u; 0 on the separatrix, where the period is infinite
  DoubleDouble Q;  ///< increase of H (free_motion.cpp) in a quarter period; 0 on the separatrix

  bool periodic() const {
    return regime == PolhodeRegime::kAboutLargest || regime == PolhodeRegime::kAboutSmallest;
  }
};

/// Computes the constants of the rotation that starts with omega0_P.
/// @throws core::Error(kPhysics) if omega0_P is not finite, or if the moments differ by more than a factor of
/// 1e20, which the range of doubles does not allow.
FreeMotionConstants freeMotionConstants(const PrincipalMoments& moments, const Eigen::Vector3d& omega0_P);

}  // namespace poinsot::physics
