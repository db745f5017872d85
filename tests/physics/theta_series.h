// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace poinsot::physics {

using Real100 =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

/// Jacobi's four theta functions of the argument v - i w, by their series in the nome (DLMF 20.2).
class ThetaSeries {
 public:
  using Real = Real100;
  struct Complex {
    Real re, im;
  };

  explicit ThetaSeries(const Real& nome) : q_(nome) {}

  /// Value and derivative of theta_1/(2 q^(1/4)) at v - i w: sum (-1)^n q^(n(n+1)) sin((2n+1)(v - i w)).
  struct WithSlope {
    Complex value, slope;
  };
  WithSlope first(const Real& v, const Real& w) const {
    const Real grown = exp(w), shrunk = 1 / grown, c = cos(v), s = sin(v);
    const Complex up{grown * c, grown * s}, down{shrunk * c, Real(-shrunk * s)};  // e^(+-i z), z = v - i w
    return summed(up, down);
  }

  /// Returns sn, cn, dn of u = 2 K v/pi (DLMF 22.2), from ratios of the real series.
  std::array<Real, 3> jacobi(const Real& v) const {
    const auto at0 = realSeries(1, 0), atV = realSeries(cos(v), sin(v));
    return {at0[2] / at0[1] * atV[0] / atV[3], at0[3] / at0[1] * atV[1] / atV[3],
            at0[3] / at0[2] * atV[2] / atV[3]};
  }

 private:
  static constexpr double kNegligible = 1e-110;  // below the last of 100 digits

  static Complex product(const Complex& a, const Complex& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }

  WithSlope summed(Complex up, Complex down) const {
    const Complex up2 = product(up, up), down2 = product(down, down);
    WithSlope sum{{0, 0}, {0, 0}};
    Real weight = 1, power = 1;  // q^(n(n+1)) with its sign, q^(2n)
    for (int n = 0; n == 0 || abs(Real(weight * (abs(up.re) + abs(up.im) + 1))) > kNegligible; ++n) {
      // sin z = (e^(iz) - e^(-iz))/2i, cos z = (e^(iz) + e^(-iz))/2
      const Real half = weight / 2, slope = half * (2 * n + 1);
      sum.value.re += half * (up.im - down.im);
      sum.value.im -= half * (up.re - down.re);
      sum.slope.re += slope * (up.re + down.re);
      sum.slope.im += slope * (up.im + down.im);
      up = product(up, up2);
      down = product(down, down2);
      power *= q_ * q_;
      weight *= -power;
    }
    return sum;
  }

  /// Returns theta_1 and theta_2 over 2 q^(1/4), theta_3 and theta_4 of a real argument with this cosine and sine.
  /// The factors 2 q^(1/4) cancel in the ratios of jacobi().
  std::array<Real, 4> realSeries(const Real& c, const Real& s) const {
    const Complex step{c * c - s * s, 2 * c * s};
    Complex odd{c, s}, even = step;
    std::array<Real, 4> sum{s, c, 1, 1};
    Real power = 1, square = 1;  // q^n, q^(n^2)
    for (int sign = -1; square > kNegligible; sign = -sign) {
      square *= power * power * q_;
      power *= q_;
      odd = product(odd, step);
      const Real weight = square * power;  // q^(n(n+1))
      sum[0] += sign * weight * odd.im;
      sum[1] += weight * odd.re;
      sum[2] += 2 * square * even.re;
      sum[3] += sign * 2 * square * even.re;
      even = product(even, step);
    }
    return sum;
  }

  Real q_;
};

}  // namespace poinsot::physics
