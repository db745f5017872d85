// SPDX-License-Identifier: Apache-2.0
#include "physics/herpolhode.h"

#include <cmath>
#include <limits>

#include "core/expect.h"
#include "physics/free_motion_constants.h"

namespace poinsot::physics {
namespace {

using DD = DoubleDouble;

/// Returns a radius rho of the herpolhode. The difference rho^2 = |omega|^2 - (2T/L)^2 is computed as a product,
/// so that nothing cancels:
///   largest  (m_2 = 0):  sqrt(D1 D3/(I1 I3))/L
///   smallest (m_a = 0):  sqrt(|D| Dc/(I2 Ic))/L,  Dc = |L^2 - 2 T I_c|
double radius(const FreeMotionConstants& k, const DD& difference1, const DD& difference2, double Ij, double Ik) {
  const DD rho = sqrt(difference1 * difference2 / (DD(Ij) * Ik)) / k.L;
  return std::ldexp(toDouble(rho), k.start.rateExponent);
}

}  // namespace

Herpolhode::Herpolhode(const PrincipalMoments& moments, const Eigen::Vector3d& omega0_P) {
  const FreeMotionConstants k = freeMotionConstants(moments, omega0_P);
  regime_ = k.regime;
  if (regime_ == PolhodeRegime::kSteady) return;
  const auto& I = k.start.I;
  largestRadius_ = radius(k, k.D1, k.D3, I[0], I[2]);
  smallestRadius_ = radius(k, abs(k.D), k.c == 2 ? k.D3 : k.D1, I[1], I[k.c]);
  rateExponent_ = k.start.rateExponent;
  meanRate_ = toDouble(k.twoT / k.L);
  areaTerm_ = toDouble(k.D1 / I[0] * (k.D3 / I[2]) * (k.D / I[1]) / (k.L * k.L * k.L));
  radialPeriod_ = anglePerRadialPeriod_ = std::numeric_limits<double>::infinity();
  if (!k.periodic()) return;
  const DD halfPeriod = k.K * 2.0 / k.lambda;
  radialPeriod_ = std::ldexp(toDouble(halfPeriod), -k.start.rateExponent);
  anglePerRadialPeriod_ = toDouble(k.L / I[1] * halfPeriod + k.Q * (2.0 * k.s));
}

// Derivation of the rate: omega' is the same vector in space and in the body (eq 31). In the body m' = m × omega,
// and the component of omega along L is constant, so that
//   rho² chi' = L^·(omega × omega') = omega'·(m × omega)/L = sum m_i'²/(I_i L),      rho² = |m × omega|²/L²
// chi' is the mean of L/I_i with the weights m_i'², and therefore lies between L/I3 and L/I1. Eq (38) and |m| = L
// give the m_i², and with them the formula in herpolhode.h.
double Herpolhode::rate(double radius) const {
  if (areaTerm_ == 0) return std::ldexp(meanRate_, rateExponent_);
  POINSOT_EXPECT(radius > 0);
  const double scaled = std::ldexp(radius, -rateExponent_);
  return std::ldexp(meanRate_ + areaTerm_ / scaled / scaled, rateExponent_);
}

std::optional<HerpolhodeClosure> Herpolhode::closure(int longest, double tolerance_rad) const {
  if (radialPeriod_ == 0 || std::isinf(radialPeriod_)) return std::nullopt;
  for (int n = 1; n <= longest; ++n) {
    const Reduced turned = reduced(DD(anglePerRadialPeriod_) * static_cast<double>(n), kTwoPi);
    if (std::abs(turned.rest.hi) <= tolerance_rad) return HerpolhodeClosure{n, static_cast<int>(turned.multiple)};
  }
  return std::nullopt;
}

}  // namespace poinsot::physics
