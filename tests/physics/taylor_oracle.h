// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "physics/rigid_body_state.h"

namespace poinsot::physics {

/// Number of 60 decimal digits, enough where the motion amplifies the rounding of the oracle (near the separatrix
/// by 1/sqrt(mc) at each flip).
using Real60 =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<60>, boost::multiprecision::et_off>;

/// Integrator that shares nothing with the code under test. Uses Taylor series of high order in time of
///   I omega' = (I omega) × omega (lecture, eq 24 to 26, no torque),    q' = q (0, omega)/2
/// with omega in body axes, in the arithmetic of Real, without elliptic functions or invariants.
/// Order and step as in Jorba & Zou, Exp. Math. 14 (2005) 99: the step is the radius of convergence over e^2.
template <typename Real>
class TaylorOracle {
 public:
  struct State {
    std::array<Real, 3> omega;
    std::array<Real, 4> q;  // w, x, y, z
  };

  TaylorOracle(const Eigen::Vector3d& I, const Eigen::Vector3d& omega0, const Eigen::Quaterniond& q0) {
    for (std::size_t i = 0; i < 3; ++i) I_[i] = I[static_cast<int>(i)];
    start_.omega = {Real(omega0[0]), Real(omega0[1]), Real(omega0[2])};
    start_.q = unit({Real(q0.w()), Real(q0.x()), Real(q0.y()), Real(q0.z())});
    const double digits = -std::log(static_cast<double>(std::numeric_limits<Real>::epsilon()));
    order_ = static_cast<std::size_t>(digits / 2) + 3;
  }

  const State& start() const { return start_; }

  State at(const Real& t) const { return advanced(start_, t); }

  State advanced(State state, Real rest) const {
    while (rest != 0) {
      const Series series = expand(state);
      const Real longest = Real(series.radius * 0.1353);  // e^-2
      const Real h = abs_(rest) <= longest ? rest : (rest < 0 ? Real(-longest) : longest);
      state = evaluate(series, h);
      rest -= h;
    }
    state.q = unit(state.q);
    return state;
  }

  /// Returns omega' at a state.
  std::array<Real, 3> derivative(const State& s) const {
    return {(I_[1] - I_[2]) / I_[0] * s.omega[1] * s.omega[2], (I_[2] - I_[0]) / I_[1] * s.omega[2] * s.omega[0],
            (I_[0] - I_[1]) / I_[2] * s.omega[0] * s.omega[1]};
  }

  static std::array<Real, 4> product(const std::array<Real, 4>& p, const std::array<Real, 4>& q) {
    return {p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
            p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
            p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
            p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]};
  }

  static std::array<Real, 4> unit(const std::array<Real, 4>& q) {
    using std::sqrt;
    const Real norm = sqrt(Real(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]));
    return {q[0] / norm, q[1] / norm, q[2] / norm, q[3] / norm};
  }

  /// Returns the angle in rad between the attitude q and the tested attitude, without the rounding of a
  /// subtraction.
  static double angle(const std::array<Real, 4>& q, const Eigen::Quaterniond& tested) {
    const std::array<Real, 4> inverse =
        unit({Real(tested.w()), Real(-tested.x()), Real(-tested.y()), Real(-tested.z())});
    const auto d = product(inverse, q);
    const double sine = std::sqrt(static_cast<double>(Real(d[1] * d[1] + d[2] * d[2] + d[3] * d[3])));
    return 2 * std::atan2(sine, std::abs(static_cast<double>(d[0])));
  }

  static double distance(const std::array<Real, 3>& omega, const Eigen::Vector3d& tested) {
    double square = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double d = static_cast<double>(Real(omega[i] - Real(tested[static_cast<int>(i)])));
      square += d * d;
    }
    return std::sqrt(square);
  }

 private:
  struct Series {
    std::array<std::vector<Real>, 7> c;  // omega, then q
    double radius = 0;
  };

  static Real abs_(const Real& x) { return x < 0 ? Real(-x) : x; }

  static Real convolved(const std::vector<Real>& a, const std::vector<Real>& b, std::size_t n) {
    Real sum = 0;
    for (std::size_t i = 0; i <= n; ++i) sum += a[i] * b[n - i];
    return sum;
  }

  Series expand(const State& s) const {
    Series series;
    auto& c = series.c;
    for (std::size_t i = 0; i < 7; ++i) c[i] = {i < 3 ? s.omega[i] : s.q[i - 3]};
    for (std::size_t n = 0; n < order_; ++n) {
      const Real next = Real(static_cast<double>(n + 1)), twice = 2 * next;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        c[i].push_back((I_[j] - I_[k]) / I_[i] * convolved(c[j], c[k], n) / next);
      }
      const auto term = [&](std::size_t q, std::size_t w) { return convolved(c[3 + q], c[w - 1], n); };
      const Real dw = -term(1, 1) - term(2, 2) - term(3, 3), dx = term(0, 1) + term(2, 3) - term(3, 2);
      const Real dy = term(0, 2) + term(3, 1) - term(1, 3), dz = term(0, 3) + term(1, 2) - term(2, 1);
      c[3].push_back(dw / twice);
      c[4].push_back(dx / twice);
      c[5].push_back(dy / twice);
      c[6].push_back(dz / twice);
    }
    series.radius = std::min(radiusFrom(c, 0, 3), radiusFrom(c, 3, 7));
    return series;
  }

  /// Returns the lesser |c_0/c_n|^(1/n) of the last two orders n, for the components [from, to) together.
  double radiusFrom(const std::array<std::vector<Real>, 7>& c, std::size_t from, std::size_t to) const {
    const auto largest = [&](std::size_t n) {
      double size = 1e-300;
      for (std::size_t i = from; i < to; ++i) size = std::max(size, static_cast<double>(abs_(c[i][n])));
      return size;
    };
    const auto root = [&](std::size_t n) {
      return std::pow(largest(0) / largest(n), 1.0 / static_cast<double>(n));
    };
    return std::min(root(order_), root(order_ - 1));
  }

  State evaluate(const Series& series, const Real& h) const {
    std::array<Real, 7> sum;
    for (std::size_t i = 0; i < 7; ++i) {
      sum[i] = series.c[i][order_];
      for (std::size_t n = order_; n-- > 0;) sum[i] = sum[i] * h + series.c[i][n];
    }
    return {{sum[0], sum[1], sum[2]}, {sum[3], sum[4], sum[5], sum[6]}};
  }

  std::array<Real, 3> I_;
  State start_;
  std::size_t order_ = 0;
};

}  // namespace poinsot::physics
