// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "physics/polhode_regime.h"
#include "physics/principal_moments.h"

namespace poinsot::physics {

/// The herpolhode closes after so many radial periods, in so many turns about L.
struct HerpolhodeClosure {
  int radialPeriods = 0;
  int turns = 0;
};

/// The curve that omega draws in space, on the invariable plane, about the foot of L: its radius swings between
/// two values, and every radial period is the last one turned about L by the same angle. Draw one, copy the rest.
class Herpolhode {
 public:
  /// omega0_P in rad/s, in principal axes. @throws core::Error(kPhysics) if it is not finite.
  Herpolhode(const PrincipalMoments& moments, const Eigen::Vector3d& omega0_P);

  PolhodeRegime regime() const { return regime_; }

  /// Smallest and largest distance of omega from the axis of L, rad/s. Both 0 when steady; equal for a symmetric
  /// top (a circle); the smallest 0 on the separatrix.
  double smallestRadius() const { return smallestRadius_; }
  double largestRadius() const { return largestRadius_; }

  /// Time from one largest radius to the next, s: half the polhode's period. 0 steady, infinite on the separatrix.
  double radialPeriod() const { return radialPeriod_; }

  /// Angle that omega turns about L in a radial period, rad, positive: (L/I2)(2K/lambda) +- 2Q.
  /// 0 steady, infinite on the separatrix.
  double anglePerRadialPeriod() const { return anglePerRadialPeriod_; }

  /// chi': rate at which omega turns about L where the radius is `radius` rad/s; rad/s, between L/I3 and L/I1.
  ///   chi' = 2T/L + (L² - 2T I1)(L² - 2T I2)(2T I3 - L²)/(I1 I2 I3 L³ radius²)
  /// derived in herpolhode.cpp. 0 when steady. Means nothing outside the curve's two radii. @pre radius > 0 of a
  /// curve that is no circle.
  double rate(double radius) const;

  /// The least number of radial periods, up to `longest`, after which the curve meets itself to `tolerance_rad` of
  /// angle; empty if there is none, or no period. (The circle of a symmetric top is closed whatever this says.)
  std::optional<HerpolhodeClosure> closure(int longest, double tolerance_rad) const;

 private:
  PolhodeRegime regime_ = PolhodeRegime::kSteady;
  double smallestRadius_ = 0;
  double largestRadius_ = 0;
  double radialPeriod_ = 0;
  double anglePerRadialPeriod_ = 0;
  int rateExponent_ = 0;  // of the two below, and of a radius beside them
  double meanRate_ = 0;   // 2T/L
  double areaTerm_ = 0;   // rate = 2T/L + areaTerm/radius²
};

}  // namespace poinsot::physics
