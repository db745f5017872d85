// SPDX-License-Identifier: Apache-2.0
#include "physics/heavy_top.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/error.h"
#include "core/expect.h"
#include "physics/elliptic.h"
#include "physics/fixed_order.h"
#include "physics/require_finite.h"
#include "physics/transcendental.h"

namespace poinsot::physics {
namespace {

// Components of r, the vector to the centre of mass, that are below this fraction of |r| count as 0. They are
// rounding errors of the turn into the principal axes.
constexpr double kRounding = 1e-14;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Cubic f(u0 + v) = f0 + f1 v + f2 v² + a v³ with f0 >= 0. In this form, nothing cancels if the swing is small.
struct Cubic {
  double f0, f1, f2, a;

  double at(double v) const { return f0 + v * (f1 + v * (f2 + v * a)); }
};

struct Roots {
  double v1, v2, v3;
};

double rootBetween(const Cubic& f, double positive, double negative) {
  for (;;) {
    const double middle = positive + (negative - positive) / 2;
    if (middle == positive || middle == negative) return middle;
    (f.at(middle) >= 0 ? positive : negative) = middle;
  }
}

/// Returns the roots of f other than v = 0, ascending, if f0 = 0. They are the roots of f1 + f2 v + a v² = 0.
std::array<double, 2> otherRoots(const Cubic& f) {
  const double root = std::sqrt(std::max(0.0, f.f2 * f.f2 - 4 * f.a * f.f1));
  const double q = -0.5 * (f.f2 + std::copysign(root, f.f2));
  const double first = q / f.a, second = q == 0 ? 0 : f.f1 / q;
  return {std::min(first, second), std::max(first, second)};
}

/// Returns the two ends of the swing that contains v = 0, and the third root.
/// @param lowest, highest  values of v at u = -1 and u = 1
Roots rootsOf(const Cubic& f, double lowest, double highest) {
  if (f.f0 == 0) {  // the start is an end of the swing, where u' = 0
    const auto [lower, upper] = otherRoots(f);
    const bool atTheLowEnd = f.f1 > 0 || (f.f1 == 0 && f.f2 <= 0);
    return atTheLowEnd ? Roots{0, std::min(lower, highest), upper} : Roots{std::max(lower, lowest), 0, upper};
  }
  Roots roots{rootBetween(f, 0, lowest), rootBetween(f, 0, highest), 0};
  roots.v3 = -f.f2 / f.a - roots.v1 - roots.v2;
  return roots;
}

/// Returns the tilt theta from `below` = 1 - cos theta and `above` = 1 + cos theta.
double tilt(double below, double above) { return 2 * arcTangent(std::sqrt(std::max(0.0, below) / above)); }

/// Returns the integral of rate/(1 ∓ u) over half a swing, up to a constant factor. `near` and `far` are the
/// values of 1 ∓ u at the two ends. Returns 0 for a swing through the pole, because the turns on its two sides
/// cancel.
double turning(double mc, double rate, double near, double far) {
  if (rate == 0 || !(near > 0 && far > 0)) return 0;
  return rate / near * cel<double>(std::sqrt(mc), far / near, 1, 1);
}

}  // namespace

std::optional<HeavyTop> heavyTop(const PrincipalMoments& moments, const Eigen::Vector3d& gravity_P,
                                 double uneven) {
  requireFinite(gravity_P, "the weight times the centre of mass");
  requireFinite(uneven, "the unevenness allowed");
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const double weight = std::abs(gravity_P[k]);
    const double across = std::max(std::abs(gravity_P[i]), std::abs(gravity_P[j]));
    if (weight == 0 || across > std::max(kRounding, uneven) * weight) continue;
    if (std::abs(moments[i] - moments[j]) > uneven * moments[i]) continue;
    const double mean = moments[i] + 0.5 * (moments[j] - moments[i]);
    return HeavyTop{(gravity_P[k] < 0 ? -1 : 1) * Eigen::Vector3d::Unit(k), mean, moments[k], weight};
  }
  return std::nullopt;
}

double HeavyTop::sleepingSpin() const { return 2 * std::sqrt(across * weight) / along; }

std::optional<SteadyPrecession> HeavyTop::steadyPrecession(double tilt_rad, double spin) const {
  requireFinite(tilt_rad, "the tilt");
  requireFinite(spin, "the spin");
  constexpr double kLevel = 1e-15;  // limit for a level axis; larger than the cosine of pi/2 in double
  const double cosine = sineCosine(tilt_rad).cosine, stiffness = std::abs(cosine) < kLevel ? 0 : across * cosine;
  const double L3 = along * spin;
  const double square = L3 * L3 - 4 * stiffness * weight;
  if (square < 0 || (L3 == 0 && square == 0)) return std::nullopt;
  const double sum = L3 + std::copysign(std::sqrt(square), L3);  // terms of the same sign
  return SteadyPrecession{2 * weight / sum, stiffness == 0 ? kInfinity : sum / (2 * stiffness)};
}

Nutation HeavyTop::nutation(const Eigen::Vector3d& omega_P, const Eigen::Vector3d& up_P) const {
  constexpr double kUnit = 1e-12;  // tolerance of a squared length
  POINSOT_EXPECT(std::abs(dotProduct(up_P, up_P) - 1) < kUnit);
  requireFinite(omega_P, "omega");
  const double u0 = dotProduct(k_P, up_P), spin = dotProduct(omega_P, k_P), c = along * spin / across;
  const Eigen::Vector3d across_P = omega_P - spin * k_P, down_P = up_P - k_P, sum_P = up_P + k_P;
  const double below = dotProduct(down_P, down_P) / 2, above = dotProduct(sum_P, sum_P) / 2;  // 1 - u0, 1 + u0
  const double speed = dotProduct(crossProduct(omega_P, k_P), up_P);                          // u' at the start
  const double excess = dotProduct(across_P, across_P), twist = dotProduct(across_P, up_P);   // (1 - u0²) phi'
  const double a = 2 * weight / across;
  const Cubic f{speed * speed, -2 * u0 * excess - a * below * above + 2 * c * twist, 2 * a * u0 - excess - c * c,
                a};
  const Roots v = rootsOf(f, -above, below);
  const double span = v.v3 - v.v1, mc = std::min(1.0, (v.v3 - v.v2) / span);
  Nutation swing{tilt(below - v.v2, above + v.v2), tilt(below - v.v1, above + v.v1), kInfinity, kInfinity};
  if (!(mc > 0)) return swing;
  const double unit = 4 / std::sqrt(a * span);
  swing.period_s = unit * completeK(mc);
  // Integrates phi' = (b - c u)/(1 - u²), with b = L_z/I1, in partial fractions. Their numerators b - c and b + c
  // are computed without cancellation.
  swing.precession_rad = unit / 2 *
                         (turning(mc, twist - c * below, below - v.v1, below - v.v2) +
                          turning(mc, twist + c * above, above + v.v1, above + v.v2));
  return swing;
}

std::optional<NutationKind> HeavyTop::nutationKind(const Eigen::Vector3d& omega_P,
                                                   const Eigen::Vector3d& up_P) const {
  constexpr double kSameTilt = 1e-7, kSmallRate = 1e-6;
  const Nutation swing = nutation(omega_P, up_P);
  const auto [leastSine, leastCosine] = sineCosine(swing.leastTilt_rad);
  const auto [mostSine, mostCosine] = sineCosine(swing.mostTilt_rad);
  if (std::min(leastSine, mostSine) < kSameTilt || !std::isfinite(swing.period_s)) return std::nullopt;
  if (swing.mostTilt_rad - swing.leastTilt_rad < kSameTilt) return NutationKind::kSteady;
  const double L_z =
      across * dotProduct(omega_P, up_P) + (along - across) * dotProduct(omega_P, k_P) * dotProduct(k_P, up_P);
  const double L_3 = along * dotProduct(omega_P, k_P);
  const double least = (L_z - L_3 * leastCosine) / (leastSine * leastSine);
  const double most = (L_z - L_3 * mostCosine) / (mostSine * mostSine);
  if (std::abs(least) < kSmallRate * std::abs(most)) return NutationKind::kCusps;
  return (least < 0) == (most < 0) ? NutationKind::kWaves : NutationKind::kLoops;
}

double HeavyTop::spinOfPrecession(double tilt_rad, double precession) const {
  requireFinite(tilt_rad, "the tilt");
  requireFinite(precession, "the rate of precession");
  POINSOT_EXPECT(precession != 0);
  return (weight / precession + across * sineCosine(tilt_rad).cosine * precession) / along;
}

ClosedPrecession HeavyTop::nearestClosedPrecession(double tilt_rad, double precession, double wanted_s) const {
  constexpr double kTurn = 2 * std::numbers::pi, kMostTurns = 1e6, kWithin = 0.25;
  requireFinite(wanted_s, "the time until the motion repeats");
  POINSOT_EXPECT(wanted_s > 0);
  const double spin = spinOfPrecession(tilt_rad, precession), cosine = sineCosine(tilt_rad).cosine;
  const double turns = wanted_s * std::abs(precession) / kTurn;
  if (turns > kMostTurns)
    throw core::physicsError(fmt::format(
        "the top precesses {:.3g} times; at most {:g} turns can be made to repeat", turns, kMostTurns));
  const double ratio = spin / precession - cosine, offset = (across / along - 1) * cosine;
  ClosedPrecession best;
  double least = kInfinity;
  const int from = std::max(1, static_cast<int>(std::ceil((1 - kWithin) * turns)));
  const auto tryRatio = [&](double n, int m) {
    const double excess = n / m - offset;
    if (!(excess > 0)) return;
    const double rate = std::copysign(std::sqrt(weight / (along * excess)), precession);
    if (std::abs(rate - precession) >= least) return;
    least = std::abs(rate - precession);
    best = {rate, spinOfPrecession(tilt_rad, rate), m * kTurn / std::abs(rate), m};
  };
  for (int m = from; m <= std::max<double>(from, (1 + kWithin) * turns); ++m) {
    tryRatio(std::floor(ratio * m), m);
    tryRatio(std::floor(ratio * m) + 1, m);  // greater than the ratio, so that at least this one exists
  }
  return best;
}

Eigen::Vector3d HeavyTop::omegaPrecessing(const Eigen::Vector3d& up_P, double spin, double precession) const {
  return spin * k_P + precession * (up_P - dotProduct(up_P, k_P) * k_P);
}

}  // namespace poinsot::physics
