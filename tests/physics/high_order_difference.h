// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace poinsot::physics {

/// Returns f' at t by the central difference of order 12, for smooth f with rates near 1. Its error (h^12/12012 of
/// the 13th derivative) is below the rounding of the values over h, some 1e-14.
template <typename F>
Eigen::Vector3d derivative(const F& f, double t) {
  constexpr double h = 0.06;
  const auto odd = [&](int k) { return Eigen::Vector3d(f(t + k * h) - f(t - k * h)); };
  return (odd(1) * (6. / 7) - odd(2) * (15. / 56) + odd(3) * (5. / 63) - odd(4) * (1. / 56) + odd(5) * (1. / 385) -
          odd(6) * (1. / 5544)) /
         h;
}

}  // namespace poinsot::physics
