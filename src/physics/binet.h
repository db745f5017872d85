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
/// stays on the momentum sphere |m| = L and on the energy ellipsoid sum m_i²/I_i = 2T; sphere and ellipsoid
/// intersect in the polhode of m. (Poinsot's construction is the same in omega.)
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

/// Separatrix: the curves between the polhodes about the axis of largest moment and those about the axis of
/// smallest moment. Two planes through the middle axis cut the momentum sphere in two great circles, and every
/// energy ellipsoid in two ellipses. From L² = 2 T I2, with I1 < I2 < I3:
///   m_3/m_1 = ± tan psi,   tan² psi = I3 (I2 - I1)/(I1 (I3 - I2))
///   omega_3/omega_1 = ± tan psi I1/I3
/// Both angles are measured from the axis of smallest moment; momentumAngle_rad is psi. `smallest`, `middle` and
/// `largest` are axes of P.
struct Separatrix {
  int smallest = 0, middle = 1, largest = 2;
  double momentumAngle_rad = 0;
  double velocityAngle_rad = 0;

  /// Returns `count` points of one of the two great circles |m| = L, at equal angles from the middle axis on, as
  /// m_P in kg·m²/s. The last point joins the first.
  /// @param mirrored selects the other circle, which has m_3 negated
  /// @pre count >= 3.
  /// @throws core::Error(kPhysics) if L is negative or not finite.
  std::vector<Eigen::Vector3d> momentumCircle(double L, int count, bool mirrored) const;
};

/// Returns the separatrix of a body, or nullopt if two moments are equal.
std::optional<Separatrix> separatrix(const PrincipalMoments& moments);

/// Polhode of a body with kinetic energy T (in J), as a closed curve in momentum space, kg·m²/s. The last point
/// joins the first; a steady motion has one point. Dividing m_i by I_i gives the curve in omega space.
struct MomentumPolhode {
  double kineticEnergy = 0;
  PolhodeRegime regime = PolhodeRegime::kSteady;
  std::vector<Eigen::Vector3d> m_P;
};

/// Returns both polhodes with energy T (in J) on the momentum sphere |m| = L (in kg·m²/s), about the positive and
/// about the negative half axis, with `count` points each. On the separatrix, they are its two circles.
/// @pre count >= 4.
/// @throws core::Error(kPhysics) if no state has this T and L (omegaFromEnergy, start.h).
std::vector<MomentumPolhode> momentumPolhodes(const PrincipalMoments& moments, double T, double L, int count);

/// Returns energies, in J and ascending, whose polhodes are spread evenly over the momentum sphere |m| = L (in
/// kg·m²/s). From the separatrix towards each extreme axis there are `perSide` polhodes; separatrix and axes are
/// left out. The polhodes are even in the angle at which they cross the plane of the two extreme axes. All
/// polhodes of a symmetric body are on one side.
/// @pre L > 0 and finite, perSide >= 1.
std::vector<double> evenEnergies(const PrincipalMoments& moments, double L, int perSide);

/// Returns the polhode scaled to the energy ellipsoid of energy T (in J), as omega_P in rad/s. The shape is the
/// same; L changes to match T.
/// @pre T > 0 and finite, curve.kineticEnergy > 0.
std::vector<Eigen::Vector3d> onEnergyEllipsoid(const MomentumPolhode& curve, const PrincipalMoments& moments,
                                               double T);

static_assert(core::laidOut<BinetConstruction, 32>());

}  // namespace poinsot::physics
