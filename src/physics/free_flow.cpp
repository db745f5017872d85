// SPDX-License-Identifier: Apache-2.0
#include "physics/free_flow.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/transcendental.h"

// Free rotation over a short time h, as a Taylor series. n = m/|m| is the direction of the angular momentum in the
// body, and n0 is n at the start. gamma_i = |L| h / I_i is the angle turned per unit of n_i. With time from 0 to
// 1:
//
//   n' = n × (gamma n)                                                  (eq 24 to 26, no torque)
//   R(t) = R0 Rot(n0, phi) M(n),      M(n) the shortest turn that takes n to n0
//   phi' = (gamma n)·(n + n0)/(1 + n·n0)
//
// For every phi, R n = R0 n0, so that the angular momentum stays fixed in space. M turns about an axis normal to n
// + n0. Its angular velocity in the body therefore has no part along n + n0, which gives phi'. The constant
// phi'(0) = sum gamma n0^2 is split off; the rest, g, starts at 0 and changes as slowly as n.
// This method needs four series, for n and g, and M is exact. Series for n and a quaternion would be seven.
// Nothing is singular while n turns by less than half a turn. Longer steps are divided.

namespace poinsot::physics {
namespace {

constexpr std::size_t kMaxOrder = 40;
// Largest |omega| h of one series. n moves at a rate of at most 2 |omega|, and the series converges up to pi/2
// divided by this rate. The terms therefore fall at least like 0.32^n.
constexpr double kLongestStep = 0.25;
// Largest number of parts of a step. A step of more parts is tried only if the torque is far too strong for it,
// and is then rejected.
constexpr double kMostParts = 1e4;
// Terms below this fraction of the first term are omitted, because they are smaller than the rounding of the sum.
constexpr double kNegligible = 0x1p-56;

/// Terms of one order k in the series of n, of n0·n (`along`) and of g.
struct Term {
  std::array<double, 3> n{};
  double along = 0;
  double g = 0;
};

struct Series {
  std::array<Term, kMaxOrder + 1> terms;
  std::size_t order = 0;
};

constexpr std::array<double, kMaxOrder + 2> inverses() {
  std::array<double, kMaxOrder + 2> values{};
  for (std::size_t k = 1; k < values.size(); ++k) values[k] = 1 / static_cast<double>(k);
  return values;
}
constexpr auto kInverse = inverses();

double largest(const std::array<double, 3>& v) {
  return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
}

/// Returns terms of two Cauchy products: of n with itself (order k - 1), and of n0·n with g (order k).
Term products(const Series& s, std::size_t k) {
  const auto& t = s.terms;
  Term sum{{t[0].n[1] * t[k - 1].n[2], t[0].n[2] * t[k - 1].n[0], t[0].n[0] * t[k - 1].n[1]}, 0, 0};
  for (std::size_t i = 1; i < k; ++i) {
    const Term &a = t[i], &b = t[k - 1 - i];
    sum.n[0] += a.n[1] * b.n[2];
    sum.n[1] += a.n[2] * b.n[0];
    sum.n[2] += a.n[0] * b.n[1];
    sum.g += a.along * t[k - i].g;
  }
  return sum;
}

/// Computes the series of n and g, until two successive terms of n are negligible:
///   n_i' = (gamma_k - gamma_j) n_j n_k,     (1 + n·n0) g = sum (gamma_i - mean) n0_i n_i
Series expanded(const std::array<double, 3>& n0, const std::array<double, 3>& gamma,
                const std::array<double, 3>& rate, double mean) {
  const std::array<double, 3> excess = {(gamma[0] - mean) * n0[0], (gamma[1] - mean) * n0[1],
                                        (gamma[2] - mean) * n0[2]};
  Series s;
  s.terms[0].n = n0;
  for (std::size_t k = 1, small = 0; k <= kMaxOrder && small < 2; ++k) {
    const Term sum = products(s, k);
    Term& t = s.terms[k];
    for (std::size_t i = 0; i < 3; ++i) t.n[i] = rate[i] * sum.n[i] * kInverse[k];
    t.along = n0[0] * t.n[0] + n0[1] * t.n[1] + n0[2] * t.n[2];
    t.g = 0.5 * (excess[0] * t.n[0] + excess[1] * t.n[1] + excess[2] * t.n[2] - sum.g);
    s.order = k;
    small = largest(t.n) <= kNegligible * largest(s.terms[1].n) ? small + 1 : 0;
  }
  return s;
}

/// Changes over a step: n(1) - n(0), and the part of phi that exceeds its mean rate. Both are summed from the
/// smallest terms up.
struct Gain {
  std::array<double, 3> n{};
  double phi = 0;
};
Gain gain(const Series& s) {
  Gain sum;
  for (std::size_t k = s.order; k > 0; --k) {
    for (std::size_t i = 0; i < 3; ++i) sum.n[i] += s.terms[k].n[i];
    sum.phi += s.terms[k].g * kInverse[k + 1];
  }
  return sum;
}

}  // namespace

double norm(const std::array<double, 3>& v) {
  const double size = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
  if (size > 0x1p-400 && size < 0x1p400) return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  if (size == 0 || !std::isfinite(size)) return size;
  int exponent = 0;
  std::frexp(size, &exponent);
  const double x = std::ldexp(v[0], -exponent), y = std::ldexp(v[1], -exponent), z = std::ldexp(v[2], -exponent);
  return std::ldexp(std::sqrt(x * x + y * y + z * z), exponent);
}

TurnLessOne turnKeeping(const std::array<double, 3>& m0, const std::array<double, 3>& change, double phi) {
  // Quaternion of M: (1 + c + change × m0)/sqrt(2 (1 + c)), with c = m·m0 = 1 - |change|^2/2.
  const auto& d = change;
  // Cosine of half the angle of M.
  const double cosine = std::sqrt(1 - 0.25 * (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]));
  const double scale = 0.5 / cosine;
  const std::array<double, 3> u = {scale * (d[1] * m0[2] - d[2] * m0[1]), scale * (d[2] * m0[0] - d[0] * m0[2]),
                                   scale * (d[0] * m0[1] - d[1] * m0[0])};
  const SineCosine half = sineCosine(0.5 * phi);
  const double c = half.cosine, s = half.sine, sw = half.sine * cosine;
  const double w = c * cosine;
  const double x = c * u[0] + sw * m0[0] + s * (m0[1] * u[2] - m0[2] * u[1]);
  const double y = c * u[1] + sw * m0[1] + s * (m0[2] * u[0] - m0[0] * u[2]);
  const double z = c * u[2] + sw * m0[2] + s * (m0[0] * u[1] - m0[1] * u[0]);
  // For w > 0, this form of w - 1 avoids cancellation.
  return {{w > 0 ? -(x * x + y * y + z * z) / (1 + w) : w - 1, x, y, z}};
}

TurnLessOne FreeFlow::turnOver(const std::array<double, 3>& m, double h) const {
  const double L = norm(m);
  if (L == 0) return {};
  const std::array<double, 3> n0 = {m[0] / L, m[1] / L, m[2] / L};
  const std::array<double, 3> gamma = {L / I_[0] * h, L / I_[1] * h, L / I_[2] * h};
  // Differences gamma_k - gamma_j, computed from the differences of the moments. For a rod, these are small, and
  // subtracting the gammas would lose digits.
  const std::array<double, 3> rate = {L * h * ((I_[1] - I_[2]) / I_[1] / I_[2]),
                                      L * h * ((I_[2] - I_[0]) / I_[2] / I_[0]),
                                      L * h * ((I_[0] - I_[1]) / I_[0] / I_[1])};
  const double square = n0[0] * n0[0] + n0[1] * n0[1] + n0[2] * n0[2];
  const double mean = (gamma[0] * n0[0] * n0[0] + gamma[1] * n0[1] * n0[1] + gamma[2] * n0[2] * n0[2]) / square;
  const Gain change = gain(expanded(n0, gamma, rate, mean));
  return turnKeeping(n0, change.n, mean + change.phi);
}

void FreeFlow::apply(DrivenState& state, double h) const {
  const std::array<double, 3> m = state.momentum_P();
  const double turned = norm({m[0] / I_[0], m[1] / I_[1], m[2] / I_[2]}) * std::abs(h);
  if (turned <= kLongestStep) return state.turn(turnOver(m, h));
  const double parts = std::ceil(turned / kLongestStep);
  if (!(parts <= kMostParts)) return state.turn({{std::numeric_limits<double>::quiet_NaN(), 0, 0, 0}});
  for (double i = 0; i < parts; ++i) state.turn(turnOver(state.momentum_P(), h / parts));
}

}  // namespace poinsot::physics
