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

/// Herpolhode: the curve that the tip of omega draws on the invariable plane, around the axis of L. Its radius
/// swings between two values. Each radial period of the curve is a copy of the previous period, turned about L by
/// a fixed angle. It is therefore enough to draw one period and copy it.
class Herpolhode {
 public:
  /// @param omega0_P angular velocity in principal axes, rad/s
  /// @throws core::Error(kPhysics) if omega0_P is not finite.
  Herpolhode(const PrincipalMoments& moments, const Eigen::Vector3d& omega0_P);

  PolhodeRegime regime() const { return regime_; }

  /// Returns the smallest distance of omega from the axis of L, rad/s. largestRadius() returns the largest
  /// distance. Both are 0 for a steady motion, and equal for a symmetric top, whose herpolhode is a circle. On the
  /// separatrix, the smallest radius is 0.
  double smallestRadius() const { return smallestRadius_; }
  double largestRadius() const { return largestRadius_; }

  /// Returns the time from one largest radius to the next, s. It is half the polhode's period, 0 for a steady
  /// motion, and infinite on the separatrix.
  double radialPeriod() const { return radialPeriod_; }

  /// Returns the positive angle by which omega turns about L in a radial period, rad: (L/I2)(2K/lambda) +- 2Q. The
  /// angle is 0 for a steady motion, and infinite on the separatrix.
  double anglePerRadialPeriod() const { return anglePerRadialPeriod_; }

  /// Returns chi', the rate (in rad/s) at which omega turns about L when it is at a distance `radius` (in rad/s)
  /// from L:
  ///   chi' = 2T/L + (L² - 2T I1)(L² - 2T I2)(2T I3 - L²)/(I1 I2 I3 L³ radius²)
  /// chi' lies between L/I3 and L/I1, and is 0 for a steady motion. The radius must be between the two radii of
  /// the curve. Derived in herpolhode.cpp.
  /// @pre radius > 0 of a curve that is not a circle.
  double rate(double radius) const;

  /// Returns the smallest number of radial periods after which the curve closes, within `tolerance_rad`. Returns
  /// nullopt if more than `longest` periods are needed, or if the curve has no period. (The circle of a symmetric
  /// top is always closed.)
  std::optional<HerpolhodeClosure> closure(int longest, double tolerance_rad) const;

 private:
  PolhodeRegime regime_ = PolhodeRegime::kSteady;
  double smallestRadius_ = 0;
  double largestRadius_ = 0;
  double radialPeriod_ = 0;
  double anglePerRadialPeriod_ = 0;
  int rateExponent_ = 0;
  // Constants of rate(), which is meanRate_ + areaTerm_/radius². meanRate_ is 2T/L. All are scaled by
  // 2^rateExponent_.
  double meanRate_ = 0;
  double areaTerm_ = 0;
};

}  // namespace poinsot::physics
