// SPDX-License-Identifier: Apache-2.0
#include "physics/free_motion_constants.h"

#include "core/error.h"
#include "physics/elliptic.h"
#include "physics/expansion.h"

namespace poinsot::physics {
namespace {

using DD = DoubleDouble;

constexpr double kLargestRatioOfMoments = 1e20;  // prevents underflow, as does kSmallestComponent

DD square(const DD& x) { return x * x; }

/// Returns whether the rotation is steady: m × omega = 0, tested without rounding.
bool isSteady(const ScaledStart& start) {
  const auto couples = [&](std::size_t j, std::size_t k) {
    return start.I[j] != start.I[k] && start.omega[j] != 0 && start.omega[k] != 0;
  };
  return !couples(0, 1) && !couples(1, 2) && !couples(0, 2);
}

Expansion moment(double Ij, double Ik, double wj) {
  Expansion product;
  product.add(Ij);
  product.add(-Ik);
  product.scale(Ij);
  product.scale(wj);
  product.scale(wj);
  return product;
}

/// Sets L, 2T and the differences D. All are sums of terms of one sign, except D, which is computed exactly. Near
/// the separatrix, the period grows as log(1/|D|), so that every digit of D matters after many periods.
void setInvariants(FreeMotionConstants& k) {
  const auto& I = k.start.I;
  const auto& w = k.start.omega;
  DD squares, energy;
  for (std::size_t i = 0; i < 3; ++i) {
    const DD m = twoProduct(I[i], w[i]);
    squares += square(m);
    energy += m * w[i];
  }
  k.L = sqrt(squares);
  k.twoT = energy;
  const DD I12 = twoSum(I[1], -I[0]), I23 = twoSum(I[2], -I[1]), I13 = twoSum(I[2], -I[0]);
  const DD w1 = twoProduct(w[0], w[0]), w2 = twoProduct(w[1], w[1]), w3 = twoProduct(w[2], w[2]);
  k.D1 = I12 * I[1] * w2 + I13 * I[2] * w3;
  k.D3 = I13 * I[0] * w1 + I23 * I[1] * w2;
  Expansion difference = moment(I[2], I[1], w[2]);
  difference.add(moment(I[0], I[1], w[0]));  // this term is not positive, because I1 <= I2
  k.D = difference.value();
}

/// Sets the constants of a rotation that is not steady. For motions about the axis of smallest moment, the same
/// formulas hold with axes 1 and 3 exchanged and all differences positive.
void setEllipticConstants(FreeMotionConstants& k) {
  const auto& I = k.start.I;
  const bool aboutSmallest = k.regime == PolhodeRegime::kAboutSmallest;
  k.c = aboutSmallest ? 0 : 2;
  k.a = 2 - k.c;
  k.s = aboutSmallest ? -1 : 1;
  const double Ia = I[k.a], I2 = I[1], Ic = I[k.c];
  const DD gapCA = abs(twoSum(Ic, -Ia)), gapC2 = abs(twoSum(Ic, -I2)), gap2A = abs(twoSum(I2, -Ia));
  const DD Da = aboutSmallest ? k.D3 : k.D1, Dc = aboutSmallest ? k.D1 : k.D3;  // |L^2 - 2 T I_a|, |L^2 - 2 T I_c|
  k.lambda = sqrt(gapC2 * Da / (DD(Ia) * I2 * Ic));
  k.mc = gapCA * abs(k.D) / (gapC2 * Da);
  if (k.mc > DD(1)) k.mc = 1;  // rounding may give more than 1 for a symmetric body
  k.A_a = sqrt(Dc * Ia / gapCA);
  k.A_2 = sqrt(Dc * I2 / gapC2);
  k.A_c = sqrt(Da * Ic / gapCA);
  k.g = gapCA * I2 / (gapC2 * Ia);
  k.p = k.L * gap2A / (DD(Ia) * I2 * k.lambda);
  k.sigma = k.start.omega[k.c] < 0 ? -1 : 1;
}

/// Sets the phase u0 from sn u0 and cn u0, by the integral R_F. An arctangent would lose relative accuracy near
/// the middle axis, where cn u0 is tiny.
void setPhase(FreeMotionConstants& k) {
  const auto& I = k.start.I;
  const auto& w = k.start.omega;
  DD sn = twoProduct(I[1], k.sigma * w[1]) / k.A_2, cn = twoProduct(I[k.a], w[k.a]) / k.A_a;
  if (!k.periodic()) {
    k.sigmaA = cn < DD(0) ? -1 : 1;
    sn = sn * k.sigmaA;
    cn = cn * k.sigmaA;
  }
  const DD norm = sqrt(square(sn) + square(cn));
  k.sn0 = sn / norm;
  k.cn0 = cn / norm;
  const DD cn2 = square(k.cn0);
  k.u0 = k.sn0 * carlsonRF<DD>(cn2, cn2 + k.mc * square(k.sn0), 1);
  if (cn < DD(0)) k.u0 = (sn < DD(0) ? -2.0 : 2.0) * k.K - k.u0;
}

void setPeriod(FreeMotionConstants& k) {
  if (!k.periodic()) return;
  k.K = completeK(k.mc);
  k.Q = k.p * cel<DD>(sqrt(k.mc), k.g, 1, 0);
}

PolhodeRegime regimeOf(const DD& D) {
  if (D == DD(0)) return PolhodeRegime::kSeparatrix;
  return D > DD(0) ? PolhodeRegime::kAboutLargest : PolhodeRegime::kAboutSmallest;
}

}  // namespace

FreeMotionConstants freeMotionConstants(const PrincipalMoments& moments, const Eigen::Vector3d& omega0_P) {
  FreeMotionConstants k;
  k.start = scaledStart(moments, omega0_P);
  if (k.start.I[0] * kLargestRatioOfMoments < k.start.I[2])
    throw core::physicsError("principal moments differ by more than a factor of 1e20");
  setInvariants(k);
  if (isSteady(k.start)) return k;
  k.regime = regimeOf(k.D);
  setEllipticConstants(k);
  setPeriod(k);
  setPhase(k);
  return k;
}

}  // namespace poinsot::physics
