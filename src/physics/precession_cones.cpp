// SPDX-License-Identifier: Apache-2.0
#include "physics/precession_cones.h"

#include <cmath>
#include <limits>

#include "physics/scaled_start.h"
#include "physics/transcendental.h"

namespace poinsot::physics {
namespace {

std::optional<std::size_t> symmetryAxis(const ScaledStart& start) {
  if (start.I[0] == start.I[1]) return 2;
  if (start.I[1] == start.I[2]) return 0;
  return std::nullopt;
}

RollingSense senseOf(double I1, double I3) {
  if (I1 == I3) return RollingSense::kNone;
  return I3 < I1 ? RollingSense::kOutside : RollingSense::kInside;
}

}  // namespace

std::optional<PrecessionCones> precessionCones(const PrincipalMoments& moments, const Eigen::Vector3d& omega_P) {
  const ScaledStart s = scaledStart(moments, omega_P);
  const auto c = symmetryAxis(s);
  if (!c) return std::nullopt;
  const double I1 = s.I[1], I3 = s.I[*c];  // I[1] is one of the two equal moments
  const double u = s.omega[(*c + 1) % 3], v = s.omega[(*c + 2) % 3];
  const double across = std::sqrt(u * u + v * v), along = std::abs(s.omega[*c]);
  if (across == 0 && along == 0) return std::nullopt;
  const auto rate = [&](double scaled) { return std::ldexp(scaled, s.rateExponent); };
  const double momentumAlong = I3 / I1 * along;  // component of L along k, divided by I1
  PrecessionCones cones;
  cones.axis = s.axis[*c];
  cones.k_P = (omega_P[cones.axis] < 0 ? -1 : 1) * Eigen::Vector3d::Unit(cones.axis);
  cones.sense = senseOf(I1, I3);
  cones.tilt_rad = arcTangent(across / momentumAlong);
  cones.bodyCone_rad = arcTangent(across / along);
  cones.spaceCone_rad =
      arcTangent(std::abs(I1 - I3) * across * along / (I3 * along * along + I1 * across * across));
  cones.precessionRate = rate(std::sqrt(across * across + momentumAlong * momentumAlong));
  cones.bodyRate = rate((I3 - I1) / I1 * along);
  cones.spinRate = rate(along);
  return cones;
}

double PrecessionCones::wobblePeriod() const {
  return bodyRate == 0 ? std::numeric_limits<double>::infinity() : kTwoPi.hi / std::abs(bodyRate);
}

AngularVelocityParts PrecessionCones::parts(const Eigen::Vector3d& omega, const Eigen::Vector3d& k) const {
  return {omega + bodyRate * k, -bodyRate * k};
}

}  // namespace poinsot::physics
