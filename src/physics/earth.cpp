// SPDX-License-Identifier: Apache-2.0
#include "physics/earth.h"

#include <cmath>

namespace poinsot::physics {
namespace {

bool within(double value, double expected, double share) { return std::abs(value / expected - 1) < share; }

}  // namespace

bool resemblesEarth(const PrecessionCones& cones) {
  const double H = earth::kDynamicalFlattening, ellipticity = cones.bodyRate / cones.spinRate;  // eq 29
  return within(ellipticity, H / (1 - H), 0.02) && within(cones.spinRate, earth::kSpin, 0.01);
}

std::optional<EarthWobble> earthWobble(const PrincipalMoments& moments, const PrecessionCones& cones) {
  const double C = moments[cones.axis], A = moments[(cones.axis + 1) % 3];
  if (!resemblesEarth(cones) || !within(C, earth::kPolarMoment, 0.01)) return std::nullopt;
  const double a = earth::kEquatorialRadius_m, spin = cones.spinRate;
  EarthWobble wobble;
  wobble.secularLoveNumber = 3 * earth::kGravitation * (C - A) / (spin * spin * a * a * a * a * a);
  wobble.rigid_s = cones.wobblePeriod();
  wobble.elastic_s = wobble.rigid_s / (1 - earth::kLoveNumber / wobble.secularLoveNumber);
  wobble.fluidCore_s = wobble.elastic_s * earth::kMantleShare;
  return wobble;
}

}  // namespace poinsot::physics
