// SPDX-License-Identifier: Apache-2.0
#include "physics/stability.h"

#include <cmath>
#include <limits>

#include "core/expect.h"
#include "physics/free_motion_constants.h"
#include "physics/require_finite.h"
#include "physics/transcendental.h"

namespace poinsot::physics {
namespace {

bool isAlongPrincipalAxis(const PrincipalMoments& moments, const Eigen::Vector3d& omega_P) {
  constexpr double kParallel = 1e-12;
  const double largest = omega_P.cwiseAbs().maxCoeff();
  if (largest == 0) return true;
  const Eigen::Vector3d direction = omega_P / largest;
  const Eigen::Vector3d m = moments.values().cwiseProduct(direction) / moments.values().maxCoeff();
  return m.cross(direction).cwiseAbs().maxCoeff() <= kParallel * m.cwiseAbs().maxCoeff();
}

}  // namespace

SpinStability spinStability(const PrincipalMoments& moments, int axis, double spin) {
  POINSOT_EXPECT(axis >= 0 && axis < 3);
  requireFinite(spin, "the spin", " rad/s");
  const double Ik = moments[axis], Ii = moments[(axis + 1) % 3], Ij = moments[(axis + 2) % 3];
  const double stiffness = ((Ik - Ii) / Ii) * ((Ik - Ij) / Ij);
  const double rate = std::abs(spin) * std::sqrt(std::abs(stiffness));
  if (rate == 0) return {};
  return {stiffness > 0 ? Stability::kStable : Stability::kUnstable, rate};
}

SpinStability spinStability(const PrincipalMoments& moments, const Eigen::Vector3d& omega_P) {
  requireFinite(omega_P, "the spin", " rad/s");
  POINSOT_EXPECT(isAlongPrincipalAxis(moments, omega_P));
  int axis = 0;
  omega_P.cwiseAbs().maxCoeff(&axis);
  return spinStability(moments, axis, omega_P[axis]);
}

namespace {

constexpr double kTangentOfFlip = 0.36397023426620234;  // tan 20 deg, see FlipTimes::turnsOver

/// Returns the tangent of the smallest angle between L and the middle axis: |m_c/m_2| at m_a = 0, from eq (38) and
/// |m| = L.
double tangentFromMiddle(const FreeMotionConstants& k) {
  const DoubleDouble& other = k.c == 2 ? k.D3 : k.D1;
  return toDouble(sqrt(abs(k.D) * k.start.I[k.c] / (other * k.start.I[1])));
}

}  // namespace

FlipTimes flipTimes(const PrincipalMoments& moments, const Eigen::Vector3d& omega_P) {
  const FreeMotionConstants k = freeMotionConstants(moments, omega_P);
  if (k.regime == PolhodeRegime::kSteady) return {};
  const double lambda = std::ldexp(toDouble(k.lambda), k.start.rateExponent), mc = toDouble(k.mc);
  if (!k.periodic()) {
    constexpr double kEndless = std::numeric_limits<double>::infinity();
    return {kEndless, kEndless, lambda, 0, 0, true};
  }
  const double logarithmic = logarithm(4 / std::sqrt(mc)), tangent = tangentFromMiddle(k);
  const bool distinct = k.start.I[0] < k.start.I[1] && k.start.I[1] < k.start.I[2];
  return {2 * toDouble(k.K) / lambda,          2 * logarithmic / lambda, lambda, mc, arcTangent(tangent),
          distinct && tangent < kTangentOfFlip};
}

double flipInterval(const PrincipalMoments& moments, const Eigen::Vector3d& m_P) {
  POINSOT_EXPECT(moments[0] != moments[1] || moments[1] != moments[2]);
  POINSOT_EXPECT(!m_P.isZero(0));
  const Eigen::Vector3d omega_P = m_P.cwiseQuotient(moments.values());
  const double interval_s = flipTimes(moments, omega_P).interval_s;
  if (interval_s > 0) return interval_s;
  const SpinStability spin = spinStability(moments, omega_P);
  return spin.kind == Stability::kStable ? std::numbers::pi / spin.rate : std::numeric_limits<double>::infinity();
}

}  // namespace poinsot::physics
