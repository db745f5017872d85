// SPDX-License-Identifier: Apache-2.0
#include "physics/run_condition.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/free_motion_constants.h"
#include "physics/motion.h"
#include "physics/transcendental.h"

namespace poinsot::physics {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// Returns |omega| in the scaled units of `start`.
double size(const ScaledStart& start) {
  const auto& w = start.omega;
  return std::sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
}

/// Returns dD/eps, where dD is the error of D = I3 (I3 - I2) w3² - I1 (I2 - I1) w1² that is due to the rounding of
/// the inputs. The effects of all inputs are added.
double sensitivity(const ScaledStart& start, bool aligned) {
  const auto& I = start.I;
  const auto& w = start.omega;
  const auto of = [&](std::size_t k) {
    const double wk = std::abs(w[k]), rounded = aligned ? wk : size(start);
    return I[k] * ((I[k] + I[1]) * wk * wk + 2 * std::abs(I[k] - I[1]) * wk * rounded);
  };
  return of(0) + of(2);
}

double growth(double x) {
  return x > kLargestExponent ? std::numeric_limits<double>::infinity() : exponential(x) - 1;
}

/// Returns the uncertainty of the attitude that is due to the passages of the middle axis, divided by eps.
double ofPassages(const FreeMotionConstants& k, bool aligned, double tau, double flips) {
  if (k.regime == PolhodeRegime::kSteady) return 0;
  const double dD = sensitivity(k.start, aligned), D = std::abs(toDouble(k.D));
  const auto& I = k.start.I;
  const double unit = (I[k.c] - I[1]) / (I[k.c] - I[k.a]) * toDouble(k.c == 2 ? k.D1 : k.D3);  // D = mc * unit
  const double grown = dD / unit * growth(toDouble(k.lambda) * tau);
  return k.periodic() ? std::min(grown, flips * dD / D) : grown;
}

}  // namespace

RunCondition runCondition(const PrincipalAxes& axes, const Eigen::Vector3d& omega_B, double duration_s) {
  const FreeMotionConstants k = freeMotionConstants(axes.moments(), axes.toP(omega_B));
  const double tau = std::ldexp(std::abs(duration_s), k.start.rateExponent), angle = size(k.start) * tau;
  if (!(tau * std::max(size(k.start), toDouble(k.lambda)) <= kFarthestPhase_rad)) refuseTime(duration_s);
  RunCondition c;
  c.turns = angle / kTwoPi.hi;
  c.flips = k.periodic() ? tau * toDouble(k.lambda) / (2 * toDouble(k.K)) : 0;
  c.attitude_rad = std::min(kPi.hi, kEpsilon * (1 + angle + ofPassages(k, axes.aligned(), tau, c.flips)));
  c.digits = std::clamp(-logarithm(c.attitude_rad) / logarithm(10), 0.0, 16.0);
  return c;
}

}  // namespace poinsot::physics
