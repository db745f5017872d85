// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "physics/double_double.h"

namespace poinsot::physics {

// Elliptic integrals and functions of real arguments. All take the complementary parameter mc = 1 - k^2, because k
// rounds to 1 near the separatrix, where mc is 1e-18 or less. The type T is double or DoubleDouble. Only + - * /
// and sqrt are used. The accuracy is measured against Boost.Multiprecision in tests/physics/elliptic_test.cpp.

/// Returns the complete elliptic integral of the first kind, K(mc) = pi / (2 AGM(1, sqrt mc)). @pre 0 < mc <= 1.
/// Source: DLMF 19.8.5.
template <typename T>
T completeK(const T& mc);

/// Returns Carlson's symmetric integral of the first kind, R_F(x, y, z). @pre x, y, z >= 0, at most one of them 0.
/// Source: B. C. Carlson, Numer. Algorithms 10 (1995) 13; series to degree 7 as in DLMF 19.36.1.
template <typename T>
T carlsonRF(T x, T y, T z);

/// Returns Carlson's symmetric integral of the third kind, R_J(x, y, z, p). Requires 0 <= x <= p <= y <= z, y > 0
/// and p > 0, the only case that a free rotation needs. Source: as carlsonRF(); DLMF 19.36.2.
double carlsonRJ(double x, double y, double z, double p);

/// Returns Bulirsch's complete elliptic integral cel(kc, p, a, b): the integral over 0..pi/2 of
///   (a cos^2 + b sin^2) / ((cos^2 + p sin^2) sqrt(cos^2 + kc^2 sin^2)).
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
  /// Prepares the functions of mc. For mc = 0, sn is tanh, and cn and dn are sech. @pre 0 <= mc <= 1.
  explicit JacobiFunctions(const DoubleDouble& mc);

  /// Returns sn, cn and dn of u. They satisfy dn^2 = cn^2 + mc sn^2 and sn^2 + cn^2 = 1 up to rounding. An error
  /// of the result is therefore equivalent to a small change of u.
  /// @pre |u| <= K(mc), up to rounding.
  SnCnDn at(double u) const;

 private:
  static constexpr std::size_t kMaxLevels = 24;  // enough, because mc = 1e-290 needs 14 levels

  double mc_;
  double agm_ = 1;  // arithmetic-geometric mean: pi / (2 K)
  std::size_t levels_ = 0;
  std::array<double, kMaxLevels> arithmetic_{};
  std::array<double, kMaxLevels> geometric_{};
};

}  // namespace poinsot::physics
