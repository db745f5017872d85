// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "physics/polhode_regime.h"
#include "physics/principal_moments.h"

namespace poinsot::physics {

/// Closure of a herpolhode: the numbers of radial periods and of turns about L after which the curve repeats.
struct HerpolhodeClosure {
  int radialPeriods = 0;
  int turns = 0;
};

/// Herpolhode: the curve that omega draws in space, on the invariable plane, about the foot of L. Its radius
/// swings between two values. Every radial period is the previous one turned about L by the same angle, so that
/// one drawn period can be copied.
class Herpolhode {
 public:
  /// @param omega0_P in principal axes, rad/s
  /// @throws core::Error(kPhysics) if omega0_P is not finite.
  Herpolhode(const PrincipalMoments& moments, const Eigen::Vector3d& omega0_P);

  PolhodeRegime regime() const { return regime_; }

  /// Returns the smallest distance of omega from the axis of L, rad/s; largestRadius() returns the largest. Both
  /// are 0 if steady and equal for a symmetric top (a circle). On the separatrix the smallest is 0.
  double smallestRadius() const { return smallestRadius_; }
  double largestRadius() const { return largestRadius_; }

  /// Returns the time from one largest radius to the next, s: half the polhode's period. 0 if steady, infinite on
  /// the separatrix.
  double radialPeriod() const { return radialPeriod_; }

  /// Returns the positive angle that omega turns about L in a radial period, rad: (L/I2)(2K/lambda) +- 2Q. 0 if
  /// steady, infinite on the separatrix.
  double anglePerRadialPeriod() const { return anglePerRadialPeriod_; }

  /// Returns chi', the rate at which omega turns about L at the radius `radius`, both in rad/s:
  ///   chi' = 2T/L + (L² - 2T I1)(L² - 2T I2)(2T I3 - L²)/(I1 I2 I3 L³ radius²)
  /// chi' lies between L/I3 and L/I1, is 0 if steady, and has no meaning outside the curve's two radii. Derived in
  /// herpolhode.cpp.
  /// @pre radius > 0 of a curve that is no circle.
  double rate(double radius) const;

  /// Returns the least number of radial periods, up to `longest`, after which the curve meets itself to
  /// `tolerance_rad`. Returns nullopt if there is none, or no period. (The circle of a symmetric top is always
  /// closed.)
  std::optional<HerpolhodeClosure> closure(int longest, double tolerance_rad) const;

 private:
  PolhodeRegime regime_ = PolhodeRegime::kSteady;
  double smallestRadius_ = 0;
  double largestRadius_ = 0;
  double radialPeriod_ = 0;
  double anglePerRadialPeriod_ = 0;
  int rateExponent_ = 0;
  // meanRate_ is 2T/L, and rate() is meanRate_ + areaTerm_/radius², all scaled by 2^rateExponent_.
  double meanRate_ = 0;
  double areaTerm_ = 0;
};

}  // namespace poinsot::physics
