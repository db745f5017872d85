// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <random>

#include "physics/principal_moments.h"

namespace poinsot::physics {

/// Random numbers from a fixed seed. Maps bits to doubles itself, because the standard distributions may change.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}

  /// Returns a number in [0, 1).
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// Returns 10^x, with x uniform in [low, high].
  double decade(double low, double high) { return std::pow(10.0, between(low, high)); }
  double sign() { return engine_() & 1 ? 1 : -1; }

  Eigen::Vector3d direction() {
    for (;;) {
      const Eigen::Vector3d v(between(-1, 1), between(-1, 1), between(-1, 1));
      if (v.squaredNorm() < 1 && v.squaredNorm() > 0.01) return v.normalized();
    }
  }

  Eigen::Quaterniond attitude() {
    const Eigen::Vector3d axis = direction();
    return Eigen::Quaterniond(Eigen::AngleAxisd(between(-3, 3), axis));
  }

  /// Returns moments of a body whose mass has second moments a, b, c > 0, as every solid body has.
  PrincipalMoments moments() {
    const double a = between(0.02, 1), b = between(0.02, 1), c = between(0.02, 1);
    return PrincipalMoments({b + c, a + c, a + b});
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace poinsot::physics
