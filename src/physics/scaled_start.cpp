// SPDX-License-Identifier: Apache-2.0
#include "physics/scaled_start.h"

#include <cmath>

#include "physics/double_double.h"
#include "physics/require_finite.h"

namespace poinsot::physics {
namespace {

// Components below this fraction of the largest count as 0, because their squares would leave the range of later
// products. This changes the attitude by less than 1e-105 rad. Even about the middle axis, such a change needs 240
// e-foldings to become visible.
constexpr double kSmallestComponent = 0x1p-350;

bool isOdd(const std::array<int, 3>& p) {
  return p == std::array{1, 0, 2} || p == std::array{0, 2, 1} || p == std::array{2, 1, 0};
}

double flushed(double component) { return std::abs(component) < kSmallestComponent ? 0 : component; }

}  // namespace

Eigen::Vector3d ScaledStart::toP(const std::array<double, 3>& sorted) const {
  Eigen::Vector3d body;
  for (std::size_t k = 0; k < 3; ++k) body[axis[k]] = parity * sorted[k];
  return body;
}

ScaledStart scaledStart(const PrincipalMoments& moments, const Eigen::Vector3d& omega0_P) {
  requireFinite(omega0_P, "angular velocity", " rad/s");
  ScaledStart s;
  s.axis = moments.ascendingAxes();
  s.parity = isOdd(s.axis) ? -1 : 1;
  s.momentExponent = exponentOf(moments.values().maxCoeff());
  s.rateExponent = exponentOf(omega0_P.cwiseAbs().maxCoeff());
  for (std::size_t k = 0; k < 3; ++k) {
    s.I[k] = std::ldexp(moments[s.axis[k]], -s.momentExponent);
    s.omega[k] = flushed(std::ldexp(s.parity * omega0_P[s.axis[k]], -s.rateExponent));
  }
  return s;
}

}  // namespace poinsot::physics
