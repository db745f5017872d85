// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/abi.h"
#include "physics/principal_moments.h"

namespace poinsot::physics {

/// Way in which the body cone rolls on the space cone. omega draws the body cone about k, in the body, and the
/// space cone about L, in space.
enum class RollingSense {
  kOutside,  ///< prolate body, I3 < I1: each cone rolls on the outside of the other
  kInside,   ///< oblate body, I3 > I1: the body cone rolls with the space cone inside it
  kNone,     ///< sphere: omega is along L, so that the space cone is only a line
};

/// Two parts of omega (eq 32): the common turn of k and omega about L, and the remaining spin about k.
struct AngularVelocityParts {
  Eigen::Vector3d precession;  ///< omega_p = omega + Omega_p k = L/I1 (eq 34)
  Eigen::Vector3d spin;        ///< -Omega_p k
};

/// Steady precession of a free symmetric top, in the terms of the lecture. k is the symmetry axis, in the
/// direction in which omega_3 = omega·k >= 0. I1 = I2 is the moment across k, I3 the moment about k, and theta the
/// angle between k and L. Angles are in rad, rates in rad/s. Half-angle beta of the body cone and |theta - beta|
/// of the space cone:
///
///   tan theta = I1 w/(I3 omega_3)      w = sqrt(omega_1² + omega_2²), omega_1 = L sin theta/I1
///   tan beta  = w/omega_3
///   tan |theta - beta| = |I1 - I3| w omega_3/(I3 omega_3² + I1 w²)      (nothing cancels)
///
/// The cones roll on each other: omega_p sin|theta - beta| = |Omega_p| sin beta. Source: lecture, eq (19) to (37).
/// Checked against the integrated motion in tests/physics/equations_30_37_test.cpp.
struct PrecessionCones {
  int axis = 2;  ///< index of the symmetry axis in P
  Eigen::Vector3d k_P = Eigen::Vector3d::UnitZ();
  RollingSense sense = RollingSense::kNone;
  double tilt_rad = 0;        ///< angle theta between k and L
  double bodyCone_rad = 0;    ///< half-angle beta, between omega and k
  double spaceCone_rad = 0;   ///< half-angle |theta - beta|, between omega and L
  double precessionRate = 0;  ///< omega_p = L/I1, rate of k and omega about L in space (eq 20, 34, 35)
  double bodyRate = 0;        ///< Omega_p = (I3/I1 - 1) omega_3, rate of omega about k in the body (eq 29, 37)
  double spinRate = 0;        ///< omega_3, constant

  /// Returns Hand & Finch's "spin" Omega = omega_3 - omega_p cos theta = -Omega_p (eq 21), which is zero for a
  /// sphere.
  double handFinchSpin() const { return -bodyRate; }

  /// Returns the period of the wobble seen from the body (for the Earth, the Chandler wobble), 2 pi/|Omega_p|, s.
  /// The period is infinite for a sphere and for a spin across k.
  double wobblePeriod() const;

  /// Returns whether omega is constant in space, along L: for a spin along k or across k, and for any spin of a
  /// sphere.
  bool steady() const { return tilt_rad == 0 || bodyRate == 0; }

  /// Splits omega into its two parts. omega and the symmetry axis k are given in the same frame, such as B or W.
  AngularVelocityParts parts(const Eigen::Vector3d& omega, const Eigen::Vector3d& k) const;
};

/// Returns the precession of a symmetric body, or nullopt if the body is at rest or its moments are all different.
/// For a sphere, z is taken as the symmetry axis.
/// @param omega_P rad/s
/// @throws core::Error(kPhysics) if omega_P is not finite.
std::optional<PrecessionCones> precessionCones(const PrincipalMoments& moments, const Eigen::Vector3d& omega_P);

/// Mean sidereal day, s (IERS, "Useful constants": 86164.09053): the time of one turn of the Earth relative to the
/// equinox. A turn relative to the stars takes 8 ms longer.
inline constexpr double kSiderealDay_s = 86164.0905;
inline constexpr double kSolarDay_s = 86400;

static_assert(core::laidOut<AngularVelocityParts, 48>() && core::laidOut<PrecessionCones, 88>());

}  // namespace poinsot::physics
