// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/abi.h"
#include "physics/polhode_regime.h"
#include "physics/principal_moments.h"

namespace poinsot::physics {

/// Binet's picture of a free rotation, in the space of the body's angular momentum m = I omega: the tip of m stays
/// on the momentum sphere |m| = L and on the energy ellipsoid sum m_i²/I_i = 2T; their intersection is the polhode
/// in m. (Poinsot's picture is the same in omega.) Source: Goldstein, Classical Mechanics,
/// section 5.6 (Binet's ellipsoid).
class BinetConstruction {
 public:
  /// omega_P in rad/s at any one time of the motion.
  /// @throws core::Error(kPhysics) if the body is at rest or omega_P is not finite.
  BinetConstruction(const PrincipalMoments& moments, const Eigen::Vector3d& omega_P);

  /// Radius of the momentum sphere, |L|, kg·m²/s.
  double sphereRadius() const { return sphereRadius_; }

  /// Semi-axes of the energy ellipsoid, sqrt(2 T I_i), kg·m²/s. The sphere's radius is between the least and the
  /// greatest.
  const Eigen::Vector3d& semiAxes_P() const { return semiAxes_P_; }

 private:
  double sphereRadius_ = 0;
  Eigen::Vector3d semiAxes_P_;
};

/// The curves that part the polhodes round the largest axis from those round the smallest: two planes through the
/// middle axis cut the momentum sphere in two great circles, and any energy ellipsoid in two ellipses.
///   m_3/m_1 = ± tan psi,   tan² psi = I3 (I2 - I1)/(I1 (I3 - I2))             I1 < I2 < I3
///   omega_3/omega_1 = ± tan psi I1/I3
/// from L² = 2 T I2. Angles in rad from the axis of smallest moment.
struct Separatrix {
  int smallest = 0, middle = 1, largest = 2;  ///< axes of P
  double momentumAngle_rad = 0;               ///< psi
  double velocityAngle_rad = 0;

  /// `count` points of one of the two great circles |m| = L, even in angle, from the middle axis; the last joins
  /// the first. m_P in kg·m²/s. The other circle (`mirrored`) has m_3 negated. @pre count >= 3.
  /// @throws core::Error(kPhysics) for an L that is negative or not finite.
  std::vector<Eigen::Vector3d> momentumCircle(double L, int count, bool mirrored) const;
};

/// Empty where two moments are equal.
std::optional<Separatrix> separatrix(const PrincipalMoments& moments);

/// One of the polhodes of a body, as a curve in momentum space; times 1/I_i in omega space.
struct MomentumPolhode {
  double kineticEnergy = 0;  ///< T, J
  PolhodeRegime regime = PolhodeRegime::kSteady;
  std::vector<Eigen::Vector3d> m_P;  ///< kg·m²/s; closed, the last point joins the first; one point when steady
};

/// Both polhodes with energy T on the momentum sphere |m| = L, round the positive and the negative half axis, of
/// `count` points each; on the separatrix its two circles. @pre count >= 4.
/// @throws core::Error(kPhysics) if no state has this T and L (omegaFromEnergy, start.h).
std::vector<MomentumPolhode> momentumPolhodes(const PrincipalMoments& moments, double T, double L, int count);

/// Energies whose polhodes are spread evenly over the momentum sphere |m| = L: from the separatrix (left out)
/// towards each extreme axis (left out), `perSide` each, even in the angle at which they cross the plane of the
/// two extreme axes. Ascending, J. A symmetric body's are all on one side. @pre L > 0 and finite, perSide >= 1.
std::vector<double> evenEnergies(const PrincipalMoments& moments, double L, int perSide);

/// The polhode on the energy ellipsoid of energy T: the same curve, for L changed to suit. omega_P in rad/s.
/// @pre T > 0 and finite, curve.kineticEnergy > 0.
std::vector<Eigen::Vector3d> onEnergyEllipsoid(const MomentumPolhode& curve, const PrincipalMoments& moments,
                                               double T);

static_assert(core::laidOut<BinetConstruction, 32>());

}  // namespace poinsot::physics
