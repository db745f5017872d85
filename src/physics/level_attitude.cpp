// SPDX-License-Identifier: Apache-2.0
#include "physics/level_attitude.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "physics/double_double.h"
#include "physics/require_finite.h"
#include "physics/rotor.h"

namespace poinsot::physics {
namespace {

using DD = DoubleDouble;
using Vector = std::array<DD, 3>;

/// Horizontal part of a vector, as a direction (x, y) and a length, computed so that no square underflows.
struct Horizontal {
  explicit Horizontal(const DD& u, const DD& v) {
    const int exponent = exponentOf(std::max(std::abs(u.hi), std::abs(v.hi)));
    x = scaled(u, -exponent);
    y = scaled(v, -exponent);
    const DD norm = sqrt(x * x + y * y);
    if (norm.hi == 0) return;
    x /= norm;
    y /= norm;
    length = scaled(norm, exponent);
  }

  DD x, y, length;
};

Quaternion turnOnto(const Vector& d, Vertical vertical) {
  const double v = vertical == Vertical::kUp ? 1 : -1;
  const int exponent = exponentOf(std::max({std::abs(d[0].hi), std::abs(d[1].hi), std::abs(d[2].hi)}));
  if (d[0].hi == 0 && d[1].hi == 0 && d[2].hi == 0) return Quaternion::Identity();
  const Horizontal across(scaled(d[0], -exponent), scaled(d[1], -exponent));
  const DD c = scaled(d[2], -exponent) * DD(v), norm = sqrt(across.length * across.length + c * c);
  const bool near = !(c < DD(0));
  // Axis of the turn, d × v of unit length. If d is exactly opposite to v, the axis is chosen as if d leaned
  // towards +y.
  const bool opposite = across.length.hi == 0;
  const DD x = opposite ? DD(v) : DD(v) * across.y, y = opposite ? DD(0) : DD(-v) * across.x;
  const DD w = near ? norm + c : across.length / (norm - c), sine = near ? across.length : DD(1);
  const Rotor<double> q = toDouble(normalized(Rotor<DD>{w, x * sine, y * sine, DD(0)}));
  return {q.w, q.x, q.y, q.z};
}

Rotor<DD> exactUnit(const Quaternion& q) { return normalized(Rotor<DD>{q.w(), q.x(), q.y(), q.z()}); }

}  // namespace

Quaternion turnOntoVertical(const Eigen::Vector3d& direction, Vertical vertical) {
  requireFinite(direction, "the direction");
  return turnOnto({DD(direction[0]), DD(direction[1]), DD(direction[2])}, vertical);
}

Quaternion levelAttitude(const PrincipalAxes& axes, const Eigen::Vector3d& omega_B, Vertical vertical) {
  requireFinite(omega_B, "omega");
  // Both factors are scaled by powers of two, so that no product overflows.
  const Eigen::Vector3d omega_P = axes.toP(omega_B);
  const int rateExponent = exponentOf(omega_P.cwiseAbs().maxCoeff());
  const int momentExponent = exponentOf(axes.moments().values().maxCoeff());
  Vector L;
  for (int i = 0; i < 3; ++i)
    L[static_cast<std::size_t>(i)] =
        twoProduct(std::ldexp(axes.moments()[i], -momentExponent), std::ldexp(omega_P[i], -rateExponent));
  return turnOnto(axes.aligned() ? L : rotated(exactUnit(axes.q_BP()), L), vertical);
}

}  // namespace poinsot::physics
