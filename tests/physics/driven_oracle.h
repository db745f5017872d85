// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "physics/forcing.h"
#include "physics/taylor_oracle.h"

namespace poinsot::physics {

/// Integrator that shares nothing with the code under test. Integrates the equations in principal axes by Taylor
/// series of high order in time, in the arithmetic of Real, without splitting, exact flows or invariants:
///   m' = -Omega × m + N - d m,   q' = q (0, Omega)/2,   Omega = I^-1 m + alpha m × (I^-1 m)
/// with N = g × R^-1(0,0,-1) + N_P + R^-1 N_W + sum of r × (F_B + R^-1 F_W), both torques linear in time. For a
/// torque table or for windows of the forces, the test advances the integrator from knot to knot.
template <typename Real>
class DrivenOracle {
 public:
  using Vector = std::array<Real, 3>;
  struct State {
    Real t = 0;
    std::array<Real, 4> q;  // w, x, y, z of q_WP
    Vector m;
    Vector impulse{}, shift{};  // integral and double integral over t of the forces at points, in W
  };

  /// Torques linear in time, 0 at t = 0, added to the constant torques of the forcing. Its tables are ignored.
  struct Slopes {
    Eigen::Vector3d torque_P = Eigen::Vector3d::Zero(), torque_W = Eigen::Vector3d::Zero();
  };

  DrivenOracle(const Eigen::Vector3d& I, const Forcing& forcing, const Slopes& slopes = Slopes())
      : I_(vector(I)),
        gravity_(vector(forcing.gravity_B)),
        drag_(vector(forcing.dragRate_P)),
        alpha_(forcing.dissipation),
        torque_P_{vector(forcing.torque_B), vector(slopes.torque_P)},
        torque_W_{vector(forcing.torque_W), vector(slopes.torque_W)} {
    for (const PointForce& f : forcing.forces)
      forces_.push_back({vector(f.lever_B), vector(f.force_B), vector(f.force_W)});
    order_ = static_cast<std::size_t>(-std::log(static_cast<double>(epsilon())) / 2) + 3;
  }

  State start(const Eigen::Vector3d& omega0, const Eigen::Quaterniond& q0) const {
    State s;
    s.q = TaylorOracle<Real>::unit({Real(q0.w()), Real(q0.x()), Real(q0.y()), Real(q0.z())});
    for (std::size_t i = 0; i < 3; ++i) s.m[i] = I_[i] * Real(omega0[static_cast<int>(i)]);
    return s;
  }

  State advanced(State s, const Real& t) const {
    while (s.t != t) {
      const Series series = expand(s);
      const Real rest = t - s.t, longest = Real(stepOf(series));
      const Real h = size(rest) <= longest ? rest : (rest < 0 ? Real(-longest) : longest);
      const bool last = h == rest;
      evaluate(series, h, s);
      s.t = last ? t : Real(s.t + h);
      s.q = TaylorOracle<Real>::unit(s.q);
    }
    return s;
  }

  static Vector momentum_W(const State& s) {
    const auto p = TaylorOracle<Real>::product(s.q, {Real(0), s.m[0], s.m[1], s.m[2]});
    const auto v = TaylorOracle<Real>::product(p, {s.q[0], -s.q[1], -s.q[2], -s.q[3]});
    return {v[1], v[2], v[3]};
  }

  Vector omega(const State& s) const { return {s.m[0] / I_[0], s.m[1] / I_[1], s.m[2] / I_[2]}; }

 private:
  using Terms = std::vector<Real>;
  using VectorTerms = std::array<Terms, 3>;
  struct Linear {
    Vector value, slope;
  };
  struct Push {
    Vector lever, body, space;
  };
  struct Series {
    std::array<Terms, 4> q;
    VectorTerms m, omega, turn;  // turn: Omega
    VectorTerms force;           // sum of the forces at points, in W
  };

  static Real epsilon() { return std::numeric_limits<Real>::epsilon(); }
  static Real size(const Real& x) { return x < 0 ? Real(-x) : x; }
  static Vector vector(const Eigen::Vector3d& v) { return {Real(v[0]), Real(v[1]), Real(v[2])}; }

  static Real conv(const Terms& a, const Terms& b, std::size_t n) {
    Real sum = 0;
    for (std::size_t i = 0; i <= n; ++i) sum += a[i] * b[n - i];
    return sum;
  }

  static Vector cross(const VectorTerms& a, const VectorTerms& b, std::size_t n) {
    return {conv(a[1], b[2], n) - conv(a[2], b[1], n), conv(a[2], b[0], n) - conv(a[0], b[2], n),
            conv(a[0], b[1], n) - conv(a[1], b[0], n)};
  }

  /// Returns term n of the rows of R. Row i belongs to W, column j to the body.
  std::array<Vector, 3> rotation(const Series& s, std::size_t n) const {
    const auto p = [&](std::size_t i, std::size_t j) { return conv(s.q[i], s.q[j], n); };
    const Real ww = p(0, 0), xx = p(1, 1), yy = p(2, 2), zz = p(3, 3);
    const Real wx = p(0, 1), wy = p(0, 2), wz = p(0, 3), xy = p(1, 2), xz = p(1, 3), yz = p(2, 3);
    return {{{ww + xx - yy - zz, 2 * (xy - wz), 2 * (xz + wy)},
             {2 * (xy + wz), ww - xx + yy - zz, 2 * (yz - wx)},
             {2 * (xz - wy), 2 * (yz + wx), ww - xx - yy + zz}}};
  }

  Series expand(const State& state) const {
    Series s;
    std::vector<std::array<Vector, 3>> R;
    for (std::size_t i = 0; i < 4; ++i) s.q[i] = {state.q[i]};
    for (std::size_t i = 0; i < 3; ++i) s.m[i] = {state.m[i]};
    for (std::size_t n = 0; n < order_; ++n) {
      const Real next = Real(static_cast<double>(n + 1));
      for (std::size_t i = 0; i < 3; ++i) s.omega[i].push_back(s.m[i][n] / I_[i]);
      const Vector bent = cross(s.m, s.omega, n);
      for (std::size_t i = 0; i < 3; ++i) s.turn[i].push_back(s.omega[i][n] + alpha_ * bent[i]);
      R.push_back(rotation(s, n));
      for (std::size_t i = 0; i < 3; ++i) s.force[i].push_back(forceTerm(R[n], n, i));
      const Vector torque = torqueTerm(R, n, state.t), carried = cross(s.m, s.turn, n);
      for (std::size_t i = 0; i < 3; ++i) s.m[i].push_back((carried[i] + torque[i] - drag_[i] * s.m[i][n]) / next);
      const auto term = [&](std::size_t a, std::size_t b) { return conv(s.q[a], s.turn[b - 1], n); };
      s.q[0].push_back(-(term(1, 1) + term(2, 2) + term(3, 3)) / (2 * next));
      s.q[1].push_back((term(0, 1) + term(2, 3) - term(3, 2)) / (2 * next));
      s.q[2].push_back((term(0, 2) + term(3, 1) - term(1, 3)) / (2 * next));
      s.q[3].push_back((term(0, 3) + term(1, 2) - term(2, 1)) / (2 * next));
    }
    return s;
  }

  /// Returns term n of N. Slopes enter with term n - 1 of the rotation.
  Vector torqueTerm(const std::vector<std::array<Vector, 3>>& R, std::size_t n, const Real& t) const {
    const Vector up = R[n][2];  // R^-1 z
    Vector N = {-(gravity_[1] * up[2] - gravity_[2] * up[1]), -(gravity_[2] * up[0] - gravity_[0] * up[2]),
                -(gravity_[0] * up[1] - gravity_[1] * up[0])};
    for (std::size_t j = 0; j < 3; ++j) {
      if (n == 0) N[j] += torque_P_.value[j] + t * torque_P_.slope[j];
      if (n == 1) N[j] += torque_P_.slope[j];
      for (std::size_t i = 0; i < 3; ++i) {
        N[j] += R[n][i][j] * (torque_W_.value[i] + t * torque_W_.slope[i]);
        if (n > 0) N[j] += R[n - 1][i][j] * torque_W_.slope[i];
      }
    }
    for (const Push& push : forces_) {
      Vector F;  // in the body
      for (std::size_t j = 0; j < 3; ++j) {
        F[j] = n == 0 ? push.body[j] : Real(0);
        for (std::size_t i = 0; i < 3; ++i) F[j] += R[n][i][j] * push.space[i];
      }
      const Vector& r = push.lever;
      N[0] += r[1] * F[2] - r[2] * F[1];
      N[1] += r[2] * F[0] - r[0] * F[2];
      N[2] += r[0] * F[1] - r[1] * F[0];
    }
    return N;
  }

  /// Returns term n of component i of the sum of the forces, in W.
  Real forceTerm(const std::array<Vector, 3>& R, std::size_t n, std::size_t i) const {
    Real sum = 0;
    for (const Push& push : forces_) {
      if (n == 0) sum += push.space[i];
      for (std::size_t j = 0; j < 3; ++j) sum += R[i][j] * push.body[j];
    }
    return sum;
  }

  /// Returns the step at which the last two terms are roundings of the largest value (Jorba & Zou, Exp. Math. 14
  /// (2005) 99).
  double stepOf(const Series& s) const {
    const auto largest = [&](std::size_t n) {
      double value = 1e-300;
      for (const Terms& q : s.q) value = std::max(value, static_cast<double>(size(q[n])));
      for (const Terms& m : s.m) value = std::max(value, static_cast<double>(size(m[n])));
      return value;
    };
    const auto root = [&](std::size_t n) { return std::pow(1 / largest(n), 1.0 / static_cast<double>(n)); };
    return 0.1353 * std::min(root(order_), root(order_ - 1));  // e^-2
  }

  void evaluate(const Series& s, const Real& h, State& state) const {
    const auto sum = [&](const Terms& c) {
      Real total = c[order_];
      for (std::size_t n = order_; n-- > 0;) total = total * h + c[n];
      return total;
    };
    for (std::size_t i = 0; i < 3; ++i) {
      Real once = 0, twice = 0;
      for (std::size_t n = order_; n-- > 0;) {
        const Real k = Real(static_cast<double>(n + 1));
        once = once * h + s.force[i][n] / k;
        twice = twice * h + s.force[i][n] / (k * (k + 1));
      }
      state.shift[i] += h * (state.impulse[i] + h * twice);
      state.impulse[i] += h * once;
    }
    for (std::size_t i = 0; i < 4; ++i) state.q[i] = sum(s.q[i]);
    for (std::size_t i = 0; i < 3; ++i) state.m[i] = sum(s.m[i]);
  }

  Vector I_, gravity_, drag_;
  Real alpha_;
  Linear torque_P_, torque_W_;
  std::vector<Push> forces_;
  std::size_t order_ = 0;
};

}  // namespace poinsot::physics
