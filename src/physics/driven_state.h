// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "physics/double_double.h"
#include "physics/rotor.h"

namespace poinsot::physics {

/// Rotation, stored as its unit quaternion minus 1, so that no digits of a small angle are lost.
struct TurnLessOne {
  Rotor<double> q{0, 0, 0, 0};
};

/// State of a driven body during integration: its attitude, and its angular momentum in space (kg·m²/s). Both are
/// sums of many small terms. They are stored with about 100 bits, so that rounding errors do not add up
/// (compensated summation: G. Vilmart, J. Comput. Phys. 227 (2008) 7083). Quantities computed from them are
/// doubles.
struct DrivenState {
  Rotor<DoubleDouble> q_WP;
  std::array<DoubleDouble, 3> L_W;

  /// Returns the angular momentum along the principal axes, kg·m²/s. Each component has full relative accuracy,
  /// even if it is small. A thin rod needs this, because a small component along its axis turns the rod fastest.
  std::array<double, 3> momentum_P() const {
    const auto m = rotated(conjugate(q_WP), L_W);
    return {m[0].hi, m[1].hi, m[2].hi};
  }

  /// Rotates the attitude about axes of the body: q becomes q (1 + turn).
  void turn(const TurnLessOne& turn) {
    const Rotor<double> high = toDouble(q_WP) * turn.q;
    const Rotor<double> low = Rotor<double>{q_WP.w.lo, q_WP.x.lo, q_WP.y.lo, q_WP.z.lo} * turn.q;
    q_WP.w += twoSum(high.w, low.w);
    q_WP.x += twoSum(high.x, low.x);
    q_WP.y += twoSum(high.y, low.y);
    q_WP.z += twoSum(high.z, low.z);
  }

  void addMomentum(double factor, const std::array<double, 3>& change_W) {
    for (std::size_t i = 0; i < 3; ++i) L_W[i] += twoProduct(factor, change_W[i]);
  }

  void stop() { L_W = {}; }

  /// Corrects |q| to 1 after rounding errors, to first order.
  void normalize() {
    auto& q = q_WP;
    const DoubleDouble excess = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z - DoubleDouble(1);
    const double half = 0.5 * excess.hi;
    for (DoubleDouble* part : {&q.w, &q.x, &q.y, &q.z}) *part -= DoubleDouble(part->hi * half);
  }
};

}  // namespace poinsot::physics
