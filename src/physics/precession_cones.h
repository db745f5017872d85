// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/abi.h"
#include "physics/principal_moments.h"

namespace poinsot::physics {

/// How the body cone (omega about k, fixed in the body) rolls on the space cone (omega about L, fixed in space).
enum class RollingSense {
  kOutside,  ///< prolate, I3 < I1: the cones roll on each other's outside
  kInside,   ///< oblate, I3 > I1: the body cone rolls with the space cone inside it
  kNone,     ///< sphere: omega and L are one line, the space cone has no opening
};

/// omega = omega_p + (-Omega_p) k (eq 32): the turning of k and omega about L, and the rest of the spin about k.
struct AngularVelocityParts {
  Eigen::Vector3d precession;  ///< omega_p = omega + Omega_p k = L/I1 (eq 34)
  Eigen::Vector3d spin;        ///< -Omega_p k
};

/// The steady precession of a free symmetric top, in the lecture's terms: k the symmetry axis, I1 = I2 the moment
/// across it, I3 about it, theta the angle between k and L. Angles in rad, rates in rad/s. Of the two directions
/// of the symmetry axis, k is the one with omega_3 = omega·k >= 0.
///
///   tan theta = I1 w/(I3 omega_3)      w = sqrt(omega_1² + omega_2²), omega_1 = L sin theta/I1
///   tan beta  = w/omega_3
///   space cone: |theta - beta|         tan of it: |I1 - I3| w omega_3/(I3 omega_3² + I1 w²), which does not
///   cancel
///
/// Source: lecture, eq (19) to (37). Checked against the motion, which does not know these, in
/// tests/physics/equations_30_37_test.cpp; the cones roll: omega_p sin|theta - beta| = |Omega_p| sin beta.
struct PrecessionCones {
  int axis = 2;  ///< the symmetry axis, of P
  Eigen::Vector3d k_P = Eigen::Vector3d::UnitZ();
  RollingSense sense = RollingSense::kNone;
  double tilt_rad = 0;        ///< theta
  double bodyCone_rad = 0;    ///< half-angle beta, between omega and k
  double spaceCone_rad = 0;   ///< half-angle, between omega and L
  double precessionRate = 0;  ///< omega_p = L/I1, of k and omega about L in space (eq 20, 34, 35)
  double bodyRate = 0;        ///< Omega_p = (I3/I1 - 1) omega_3, of omega about k in the body (eq 29, 37)
  double spinRate = 0;        ///< omega_3, constant

  /// Hand & Finch's "spin" Omega = omega_3 - omega_p cos theta = -Omega_p (eq 21): zero for a sphere.
  double handFinchSpin() const { return -bodyRate; }

  /// 2 pi/|Omega_p|, s: the wobble seen from the body (Chandler's, of the Earth). Infinite for a sphere and for a
  /// spin across k.
  double wobblePeriod() const;

  /// True if omega stands still along L: a spin along k or across it, or any spin of a sphere.
  bool steady() const { return tilt_rad == 0 || bodyRate == 0; }

  /// Both vectors in one frame, whichever; k as above.
  AngularVelocityParts parts(const Eigen::Vector3d& omega, const Eigen::Vector3d& k) const;
};

/// omega_P in rad/s. Empty for a body at rest and for one whose moments are all different. Of a sphere the axis is
/// z. @throws core::Error(kPhysics) if omega_P is not finite.
std::optional<PrecessionCones> precessionCones(const PrincipalMoments& moments, const Eigen::Vector3d& omega_P);

/// Mean sidereal day, s (IERS, "Useful constants": 86164.09053). Against the stars and not the equinox the Earth's
/// turn is 8 ms longer.
inline constexpr double kSiderealDay_s = 86164.0905;
inline constexpr double kSolarDay_s = 86400;

static_assert(core::laidOut<AngularVelocityParts, 48>() && core::laidOut<PrecessionCones, 88>());

}  // namespace poinsot::physics
