// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/abi.h"
#include "physics/polhode_regime.h"
#include "physics/principal_moments.h"

namespace poinsot::physics {

/// Binet's construction of a free rotation, in the space of the body's angular momentum m = I omega. The tip of m
/// stays on the momentum sphere |m| = L and on the energy ellipsoid sum m_i²/I_i = 2T. It therefore moves on their
/// intersection, the polhode of m. (Poinsot's construction is the same in omega.)
/// Source: Goldstein, Classical Mechanics, section 5.6 (Binet's ellipsoid).
class BinetConstruction {
 public:
  /// @param omega_P angular velocity at any one time of the motion, rad/s
  /// @throws core::Error(kPhysics) if the body is at rest or omega_P is not finite.
  BinetConstruction(const PrincipalMoments& moments, const Eigen::Vector3d& omega_P);

  /// Returns the radius of the momentum sphere, |L|, in kg·m²/s.
  double sphereRadius() const { return sphereRadius_; }

  /// Returns the semi-axes of the energy ellipsoid, sqrt(2 T I_i), in kg·m²/s. The sphere's radius lies between
  /// the smallest and the largest semi-axis.
  const Eigen::Vector3d& semiAxes_P() const { return semiAxes_P_; }

 private:
  double sphereRadius_ = 0;
  Eigen::Vector3d semiAxes_P_;
};

/// Separatrix: the curves that separate the polhodes about the axis of largest moment from the polhodes about the
/// axis of smallest moment. The curves lie in two planes through the middle axis. They are great circles of the
/// momentum sphere, and ellipses on an energy ellipsoid. From L² = 2 T I2, with I1 < I2 < I3:
///   m_3/m_1 = ± tan psi,   tan² psi = I3 (I2 - I1)/(I1 (I3 - I2))
///   omega_3/omega_1 = ± tan psi I1/I3
/// momentumAngle_rad is psi, and velocityAngle_rad is the angle of omega. Both are measured from the axis of
/// smallest moment. `smallest`, `middle` and `largest` are axes of P.
struct Separatrix {
  int smallest = 0, middle = 1, largest = 2;
  double momentumAngle_rad = 0;
  double velocityAngle_rad = 0;

  /// Returns `count` points m_P of one of the two great circles |m| = L, in kg·m²/s. The points have equal angles
  /// and begin on the middle axis. The curve closes from the last point to the first.
  /// @param mirrored selects the other circle, whose m_3 has the opposite sign
  /// @pre count >= 3.
  /// @throws core::Error(kPhysics) if L is negative or not finite.
  std::vector<Eigen::Vector3d> momentumCircle(double L, int count, bool mirrored) const;
};

/// Returns the separatrix of a body, or nullopt if two moments are equal.
std::optional<Separatrix> separatrix(const PrincipalMoments& moments);

/// Polhode of a body with a given kinetic energy (J), as a closed curve of points m_P in kg·m²/s. The curve closes
/// from the last point to the first. A steady motion has one point. To get the curve of omega, divide m_i by I_i.
struct MomentumPolhode {
  double kineticEnergy = 0;
  PolhodeRegime regime = PolhodeRegime::kSteady;
  std::vector<Eigen::Vector3d> m_P;
};

/// Returns the two polhodes with energy T (in J) on the momentum sphere |m| = L (in kg·m²/s): first the polhode
/// about the positive half axis, then the polhode about the negative half axis. Each has `count` points. On the
/// separatrix, the result is its two circles.
/// @pre count >= 4.
/// @throws core::Error(kPhysics) if no state has this T and L (omegaFromEnergy, start.h).
std::vector<MomentumPolhode> momentumPolhodes(const PrincipalMoments& moments, double T, double L, int count);

/// Returns energies (in J, ascending) whose polhodes are spread evenly over the momentum sphere |m| = L (in
/// kg·m²/s). There are `perSide` polhodes between the separatrix and each extreme axis, that is, the axis of
/// smallest or largest moment. In the plane of the two extreme axes, neighbouring polhodes are at equal angles.
/// For a symmetric body, all polhodes are on one side of the separatrix.
/// @pre L > 0 and finite, perSide >= 1.
std::vector<double> evenEnergies(const PrincipalMoments& moments, double L, int perSide);

/// Returns the polhode as points omega_P in rad/s, scaled to the energy T (in J). The shape of the curve stays the
/// same, and L changes with T.
/// @pre T > 0 and finite, curve.kineticEnergy > 0.
std::vector<Eigen::Vector3d> onEnergyEllipsoid(const MomentumPolhode& curve, const PrincipalMoments& moments,
                                               double T);

static_assert(core::laidOut<BinetConstruction, 32>());

}  // namespace poinsot::physics
