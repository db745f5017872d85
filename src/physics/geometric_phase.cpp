// SPDX-License-Identifier: Apache-2.0
#include "physics/geometric_phase.h"

#include <cmath>

#include "physics/free_motion_constants.h"

namespace poinsot::physics {
namespace {

using DD = DoubleDouble;

/// Integrand (A dn + B)/(C + E dn), with coefficients that are not negative.
struct Ratio {
  double A = 0, B = 0, C = 1, E = 0;
};

/// Returns the integrand for the next modulus of Landen's transformation, from the sum of `f` over u and u + K. As
/// dn(u + K) = k'/dn(u), the sum contains dn only in dn + k'/dn = (1 + k') dn((1 + k') u, k1).
Ratio atNextModulus(const Ratio& f, double kc) {
  Ratio next{(1 + kc) * (f.A * f.C + f.B * f.E), 2 * (f.A * f.E * kc + f.B * f.C), f.C * f.C + f.E * f.E * kc,
             (1 + kc) * f.C * f.E};
  const double size = next.C + next.E;
  for (double* value : {&next.A, &next.B, &next.C, &next.E}) *value /= size;
  return next;
}

/// Returns the integral of f du from 0 to the quarter period K of the complementary modulus kc. All terms are
/// positive, and kc approaches 1 quadratically.
double overQuarterPeriod(Ratio f, double kc) {
  constexpr double kNearlyOne = 1e-8;  // the next modulus is then 1 to rounding
  double factor = 1, gap = 0;
  do {
    gap = 1 - kc;
    f = atNextModulus(f, kc);
    factor /= 1 + kc;
    kc = 2 * std::sqrt(kc) / (1 + kc);
  } while (gap > kNearlyOne);
  return factor * kHalfPi.hi * (f.A + f.B) / (f.C + f.E);
}

// With kappa = A_c/L, the azimuth phi about axis c and the polar angle theta, where cos theta = kappa dn:
//   Omega = integral (1 - cos theta) dphi,   1 - cos theta = sin² theta/(1 + cos theta),
//   sin² theta dphi = (A_a A_2/L²) dn du
double solidAngle(const FreeMotionConstants& k) {
  const double kappa = toDouble(k.A_c / k.L), area = toDouble(k.A_a / k.L * (k.A_2 / k.L));
  return 4 * area * overQuarterPeriod({1, 0, 1, kappa}, toDouble(sqrt(k.mc)));
}

}  // namespace

// In a period, omega turns about L by 4 K L/(lambda I2) + 4 s Q, twice the angle of a radial period
// (herpolhode.h). In the same time, it goes once round the principal axis, in the sense s, which the body's own
// turn lacks.
std::optional<GeometricPhase> geometricPhase(const PrincipalMoments& moments, const Eigen::Vector3d& omega0_P) {
  const FreeMotionConstants k = freeMotionConstants(moments, omega0_P);
  if (!k.periodic()) return std::nullopt;
  const DD period = k.K * 4.0 / k.lambda;
  GeometricPhase phase;
  phase.period_s = std::ldexp(toDouble(period), -k.start.rateExponent);
  phase.turn_rad = toDouble(k.L / k.start.I[1] * period + (k.Q * 4.0 - kTwoPi) * k.s);
  phase.dynamic_rad = toDouble(k.twoT / k.L * period);
  phase.solidAngle_sr = solidAngle(k);
  phase.sense = k.s < 0 ? -1 : 1;
  phase.geometric_rad = -phase.sense * phase.solidAngle_sr;
  return phase;
}

}  // namespace poinsot::physics
