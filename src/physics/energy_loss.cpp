// SPDX-License-Identifier: Apache-2.0
#include "physics/energy_loss.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "core/expect.h"
#include "physics/elliptic.h"
#include "physics/require_finite.h"

namespace poinsot::physics {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Moments in ascending order and the length of L.
struct Body {
  Eigen::Vector3d I;
  double L = 0;
};

Body bodyOf(const PrincipalMoments& moments, double L) {
  const auto axis = moments.ascendingAxes();
  return {{moments[axis[0]], moments[axis[1]], moments[axis[2]]}, L};
}

/// Returns the mean of omega² over a polhode around the axis of smallest moment, in rad²/s². L² and 2T fix m1² and
/// m3² for each m2² = A² sn², and the mean of sn² is (1 - E/K)/k².
double meanSquareOfOmega(const Body& body, double twoT) {
  const Eigen::Vector3d& I = body.I;
  const double square = body.L * body.L, D1 = square - twoT * I[0], D3 = twoT * I[2] - square;
  const double parameter = (I[2] - I[1]) * D1 / ((I[1] - I[0]) * D3), kc = std::sqrt(1 - parameter);
  const double EOverK = cel(kc, 1.0, 1.0, kc * kc) / cel(kc, 1.0, 1.0, 1.0);
  const double m2 = I[1] * D1 / (I[1] - I[0]) * (1 - EOverK) / parameter;
  const double m1 = I[0] * (D3 - m2 * (I[2] - I[1]) / I[1]) / (I[2] - I[0]);
  const double m3 = I[2] * (D1 - m2 * (I[1] - I[0]) / I[1]) / (I[2] - I[0]);
  return m1 / (I[0] * I[0]) + m2 / (I[1] * I[1]) + m3 / (I[2] * I[2]);
}

/// Returns the mean of |m x omega|² on the polhode with the energy T = Tmax - w (Tmax - Tseparatrix).
double meanLoss(const Body& body, double w) {
  const double square = body.L * body.L;
  const double twoT = square / body.I[0] - w * (square / body.I[0] - square / body.I[1]);
  return square * meanSquareOfOmega(body, twoT) - twoT * twoT;
}

/// Returns the integral of w/loss(w) over z = ln w from `from` to 0, by the tanh-sinh rule. The integrand is
/// smooth but for its logarithm at the separatrix, z = 0.
double integral(const Body& body, double from) {
  constexpr double kStep = 1.0 / 16, kEnd = 3.2;
  double sum = 0;
  for (double t = -kEnd; t <= kEnd; t += kStep) {
    const double u = std::numbers::pi / 2 * std::sinh(t), fraction = 1 / (1 + std::exp(2 * u));
    const double weight = std::numbers::pi / 4 * std::cosh(t) / (std::cosh(u) * std::cosh(u));
    const double w = std::exp(from * fraction);
    if (w < 1) sum += weight * w / meanLoss(body, w);
  }
  return -from * kStep * sum;
}

}  // namespace

double dampingTime(const PrincipalMoments& moments, double alpha, double L) {
  POINSOT_EXPECT(alpha > 0 && L > 0);
  const Eigen::Vector3d I = bodyOf(moments, L).I;
  // A rod-like symmetric body comes to a spin across its axis, which has only one moment to fall from.
  if (I[1] == I[2]) return 1 / (alpha * L * L * (1 / I[0] - 1 / I[2]));
  return 2 / (alpha * L * L * (1 / I[0] + 1 / I[1] - 2 / I[2]));
}

double timeToSeparatrix(const PrincipalMoments& moments, const Eigen::Vector3d& omega_P, double alpha) {
  requireFinite(omega_P, "the angular velocity", " rad/s");
  POINSOT_EXPECT(alpha > 0 && !omega_P.isZero(0));
  const Body body = bodyOf(moments, moments.angularMomentum(omega_P).norm());
  const Eigen::Vector3d& I = body.I;
  if (!(I[0] < I[1] && I[1] < I[2])) return kNever;
  const double square = body.L * body.L, twoT = omega_P.dot(moments.angularMomentum(omega_P));
  const double w = (square / I[0] - twoT) / (square / I[0] - square / I[1]);
  if (w >= 1) return 0;
  if (w <= 0) return kNever;
  const double range = 0.5 * (square / I[0] - square / I[1]);
  return range / alpha * integral(body, std::log(w));
}

}  // namespace poinsot::physics
