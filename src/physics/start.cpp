// SPDX-License-Identifier: Apache-2.0
#include "physics/start.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/expect.h"
#include "physics/double_double.h"
#include "physics/expansion.h"
#include "physics/free_motion.h"
#include "physics/inertia_tensor.h"
#include "physics/polhode.h"
#include "physics/require_finite.h"
#include "physics/transcendental.h"

namespace poinsot::physics {
namespace {

using DD = DoubleDouble;

/// Given |L|, T and moments, which ascend. They are divided by powers of two that bring |L| and the largest moment
/// into [1/2, 1), so that squares stay in range. omega = m/I has the unit 2^rateExponent rad/s.
struct ScaledEnergy {
  double L = 0, T = 0;
  std::array<double, 3> I{};
  int rateExponent = 0;
};

ScaledEnergy scaledEnergy(const PrincipalMoments& moments, const EnergyStart& start) {
  ScaledEnergy s;
  const auto axis = moments.ascendingAxes();
  const int momentExponent = exponentOf(moments[axis[2]]), momentumExponent = exponentOf(start.angularMomentum);
  s.rateExponent = momentumExponent - momentExponent;
  s.L = std::ldexp(start.angularMomentum, -momentumExponent);
  s.T = std::ldexp(start.kineticEnergy, -momentumExponent - s.rateExponent);
  for (std::size_t i = 0; i < 3; ++i) s.I[i] = std::ldexp(moments[axis[i]], -momentExponent);
  return s;
}

/// Returns L² - 2 T I exactly, or 0 if the difference may be only the rounding of given decimals. In this case,
/// the user probably meant a spin about the axis.
DD excess(const ScaledEnergy& s, double I) {
  constexpr double kRoundingOfGiven =
      8 * std::numeric_limits<double>::epsilon();  // T, L² and I are rounded numbers
  Expansion square, energy;
  square.add(s.L);
  square.scale(s.L);
  energy.add(-2 * s.T);
  energy.scale(I);
  square.add(energy);
  const DD difference = square.value();
  return std::abs(difference.hi) <= kRoundingOfGiven * s.L * s.L ? DD(0) : difference;
}

/// Returns whether the polhode runs around the axis of smallest moment, or is a point on this axis.
bool circlesSmallest(const ScaledEnergy& s) {
  return excess(s, s.I[2]) < DD(0) && (excess(s, s.I[0]) == DD(0) || excess(s, s.I[1]) < DD(0));
}

[[noreturn]] void refuseMomentum(const PrincipalMoments& moments, const EnergyStart& start) {
  const auto axis = moments.ascendingAxes();
  const auto bound = [&](int i) { return std::sqrt(2 * start.kineticEnergy) * std::sqrt(moments[i]); };
  throw core::physicsError(fmt::format(
      "with a kinetic energy of {} J the angular momentum must lie between {:.10g} and {:.10g} kg·m²/s "
      "(sqrt(2 T I) of the smallest and the largest moment), got {}",
      start.kineticEnergy, bound(axis[0]), bound(axis[2]), start.angularMomentum));
}

void requireValid(const PrincipalMoments& moments, const EnergyStart& start) {
  requireFinite(start.kineticEnergy, "kinetic energy");
  requireFinite(start.angularMomentum, "angular momentum");
  if (start.kineticEnergy < 0)
    throw core::physicsError(fmt::format("kinetic energy must not be negative, got {} J", start.kineticEnergy));
  if (start.angularMomentum < 0)
    throw core::physicsError(fmt::format(
        "the magnitude of the angular momentum must not be negative, got {} kg·m²/s", start.angularMomentum));
  if (!(start.phase >= 0 && start.phase < 1))
    throw core::physicsError(fmt::format("the phase must be at least 0 and below 1, got {}", start.phase));
  if ((start.kineticEnergy == 0) != (start.angularMomentum == 0)) refuseMomentum(moments, start);
}

Eigen::Vector3d omegaAtPhaseZero(const PrincipalMoments& moments, const EnergyStart& start) {
  const ScaledEnergy s = scaledEnergy(moments, start);
  const auto axis = moments.ascendingAxes();
  const DD D1 = excess(s, s.I[0]), D3 = -excess(s, s.I[2]), gap = twoSum(s.I[2], -s.I[0]);
  constexpr double kBeyondAnyBody = 0x1p200;  // limit of T, above which differences become NaN
  if (s.T > kBeyondAnyBody || D1 < DD(0) || D3 < DD(0)) refuseMomentum(moments, start);
  Eigen::Vector3d omega_P = Eigen::Vector3d::Zero();
  const auto set = [&](std::size_t i, const DD& omega) {
    omega_P[axis[i]] = std::ldexp(toDouble(omega), s.rateExponent);
  };
  if (D1 == DD(0) && D3 == DD(0)) {  // the body is a sphere, up to rounding errors
    set(2, DD(s.L) / s.I[2]);
  } else {
    set(0, sqrt(D3 / (gap * s.I[0])));
    set(2, sqrt(D1 / (gap * s.I[2])));
  }
  if (start.negative) omega_P[axis[circlesSmallest(s) ? 0 : 2]] *= -1;
  return omega_P;
}

}  // namespace

Eigen::Vector3d omegaFromSpace(const Quaternion& q_WB, const Eigen::Vector3d& omega_W) {
  POINSOT_EXPECT(!q_WB.coeffs().isZero(0));
  return turnedVector(q_WB.conjugate(), omega_W);
}

Eigen::Vector3d omegaFromMomentum(const PrincipalAxes& axes, const Quaternion& q_WB, const Eigen::Vector3d& L_W) {
  POINSOT_EXPECT(!q_WB.coeffs().isZero(0));
  return axes.angularVelocity(turnedVector(q_WB.conjugate(), L_W));
}

Eigen::Vector3d omegaFromSpin(const PrincipalAxes& axes, const SpinStart& start) {
  POINSOT_EXPECT(start.axis >= 0 && start.axis < 3);
  requireFinite(start.spin, "spin");
  requireFinite(start.towards_rad, "direction of the tilt");
  if (!(start.tilt_rad >= 0 && start.tilt_rad < kHalfPi.hi))
    throw core::physicsError(fmt::format("the tilt of a spin must be at least 0 and below 90 deg, got {:.10g} deg",
                                         start.tilt_rad * 180 / kPi.hi));
  const PrincipalMoments& I = axes.moments();
  const int k = start.axis, next = (k + 1) % 3, last = (k + 2) % 3;
  const SineCosine tilt = sineCosine(start.tilt_rad), side = sineCosine(start.towards_rad);
  const double across = I[k] * std::abs(start.spin) * (tilt.sine / tilt.cosine);
  Eigen::Vector3d omega_P;
  omega_P[k] = start.spin;
  omega_P[next] = across * side.cosine / I[next];
  omega_P[last] = across * side.sine / I[last];
  return axes.toB(omega_P);
}

Eigen::Vector3d omegaFromEnergy(const PrincipalAxes& axes, const EnergyStart& start) {
  const PrincipalMoments& moments = axes.moments();
  requireValid(moments, start);
  if (start.angularMomentum == 0) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d omega0_P = omegaAtPhaseZero(moments, start);
  const Polhode polhode(moments, omega0_P);
  if (start.phase == 0 || polhode.regime() == PolhodeRegime::kSteady) return axes.toB(omega0_P);
  const ScaledEnergy s = scaledEnergy(moments, start);
  if (excess(s, s.I[1]) == DD(0))
    throw core::physicsError(
        fmt::format("on the separatrix (L² = 2 T I, where I is the middle moment), the motion has no period; the "
                    "phase must be 0, got {}",
                    start.phase));
  const FreeMotion motion(moments, omega0_P, Quaternion::Identity());
  return axes.toB(motion.at(start.phase * polhode.period()).omega_B);
}

}  // namespace poinsot::physics
