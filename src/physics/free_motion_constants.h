// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/double_double.h"
#include "physics/polhode_regime.h"
#include "physics/scaled_start.h"

namespace poinsot::physics {

/// The constants of one free rotation, in about 100 bits, shared by the motion, the polhode and the herpolhode.
///
/// Units are those of `start`. Axes are its sorted ones: c is the axis that the polhode goes round, a the other
/// extreme axis, 2 the middle one. With s the sense and sigma the sign of omega_c,
///
///   m_a = A_a cn u,  m_2 = sigma A_2 sn u,  m_c = sigma A_c dn u,     u = lambda t + u0,  parameter mc = 1 - k^2
///
/// (Landau & Lifshitz, Mechanics, section 37, written so that nothing cancels; the attitude is in
/// free_motion.cpp.) Checked against an integrator of its own in tests/physics/free_motion_oracle_test.cpp.
struct FreeMotionConstants {
  ScaledStart start;
  PolhodeRegime regime = PolhodeRegime::kSteady;

  DoubleDouble L;     ///< |L|
  DoubleDouble twoT;  ///< 2 T
  DoubleDouble D1;    ///< L^2 - 2 T I1 >= 0
  DoubleDouble D3;    ///< 2 T I3 - L^2 >= 0
  DoubleDouble D;     ///< L^2 - 2 T I2, relatively accurate however small

  // All below: not of a steady rotation.
  std::size_t a = 0;
  std::size_t c = 2;
  double s = 1;  ///< +1 about the largest axis (and on the separatrix), -1 about the smallest
  double sigma = 1;
  double sigmaA = 1;  ///< sign of m_a and sigma m_2 on the separatrix, else 1
  DoubleDouble lambda;
  DoubleDouble mc;
  DoubleDouble g;
  DoubleDouble p;
  DoubleDouble A_a, A_2, A_c;
  DoubleDouble sn0, cn0;  ///< sn u0, cn u0
  DoubleDouble u0;
  DoubleDouble K;  ///< quarter period in u; 0 on the separatrix, where it is infinite
  DoubleDouble Q;  ///< growth of H over K (free_motion.cpp); 0 on the separatrix

  bool periodic() const {
    return regime == PolhodeRegime::kAboutLargest || regime == PolhodeRegime::kAboutSmallest;
  }
};

/// @throws core::Error(kPhysics) if omega0_P is not finite, or the moments differ by more than the range of
/// doubles allows (a factor of 1e20).
FreeMotionConstants freeMotionConstants(const PrincipalMoments& moments, const Eigen::Vector3d& omega0_P);

}  // namespace poinsot::physics
