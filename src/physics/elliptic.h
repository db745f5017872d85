// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "physics/double_double.h"

namespace poinsot::physics {

// Elliptic integrals and functions of real arguments. All take the complementary parameter mc = 1 - k^2, because
// near the separatrix mc is 1e-18 or less, where k itself rounds to 1. T is double or DoubleDouble. Only + - * /
// and sqrt are used. Accuracy is measured against Boost.Multiprecision in tests/physics/elliptic_test.cpp.

/// Returns the complete integral K(mc) = pi / (2 AGM(1, sqrt mc)). @pre 0 < mc <= 1. Source: DLMF 19.8.5.
template <typename T>
T completeK(const T& mc);

/// Returns Carlson's symmetric integral of the first kind. @pre x, y, z >= 0, at most one of them 0.
/// Source: B. C. Carlson, Numer. Algorithms 10 (1995) 13; series to degree 7 as in DLMF 19.36.1.
template <typename T>
T carlsonRF(T x, T y, T z);

/// Returns Carlson's symmetric integral of the third kind for 0 <= x <= p <= y <= z, y > 0, p > 0. A free rotation
/// needs only this case, in which the argument of every R_C is at least 1. Source: as carlsonRF(); DLMF 19.36.2.
double carlsonRJ(double x, double y, double z, double p);

/// Returns the integral over 0..pi/2 of (a cos^2 + b sin^2) / ((cos^2 + p sin^2) sqrt(cos^2 + kc^2 sin^2)).
/// @pre kc, p > 0. Source: R. Bulirsch, Numer. Math. 13 (1969) 305, the branch p > 0.
template <typename T>
T cel(T kc, T p, T a, T b);

struct SnCnDn {
  double sn = 0;
  double cn = 1;
  double dn = 1;
};

/// Jacobi elliptic functions sn, cn and dn of one parameter mc. Immutable.
class JacobiFunctions {
 public:
  /// @pre 0 <= mc <= 1; mc = 0 gives tanh, sech, sech.
  explicit JacobiFunctions(const DoubleDouble& mc);

  /// Returns sn, cn and dn of u with dn^2 = cn^2 + mc sn^2 and, to rounding, sn^2 + cn^2 = 1; an error is a shift
  /// of u.
  /// @pre |u| <= K(mc), up to rounding.
  SnCnDn at(double u) const;

 private:
  static constexpr std::size_t kMaxLevels = 24;  // mc = 1e-290 needs 14 levels

  double mc_;
  double agm_ = 1;  // pi / (2 K)
  std::size_t levels_ = 0;
  std::array<double, kMaxLevels> arithmetic_{};
  std::array<double, kMaxLevels> geometric_{};
};

}  // namespace poinsot::physics
