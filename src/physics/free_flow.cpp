// SPDX-License-Identifier: Apache-2.0
#include "physics/free_flow.h"

#include <algorithm>
#include <cmath>

#include "physics/transcendental.h"

// Taylor series of the rotation in a frame that suits a short time. With n = m/|m| in body components, n0 its
// start and gamma_i = |L| h / I_i (the angle turned per unit of n_i), time running from 0 to 1:
//
//   n' = n × (gamma n)                                                  (eq 24 to 26, no torque)
//   R(t) = R0 Rot(n0, phi) M(n),      M(n) the shortest turn that takes n to n0
//   phi' = (gamma n)·(n + n0)/(1 + n·n0)
//
// R n = R0 n0 for every phi: the angular momentum stays where it is. M turns about an axis normal to n + n0 (its
// angular velocity in body components has no part along n + n0), hence phi'. Split off phi'(0) = sum gamma n0^2;
// what is left, g, starts at 0 and is as slow as n. Four series instead of the seven of n and a quaternion, and an
// exact M: nothing is singular while n turns by less than half a turn, which the step is cut to.

namespace poinsot::physics {
namespace {

constexpr std::size_t kMaxOrder = 40;
// Terms fall at least like (2/pi)^n times this one's power; 0.5^40 is below the rounding.
constexpr double kLongestStep = 0.5;
// Of the first term: what is left out is below the rounding of the change.
constexpr double kNegligible = 0x1p-56;

using Terms = std::array<double, kMaxOrder + 1>;

struct Series {
  std::array<Terms, 3> n;
  Terms g;  // of phi' - phi'(0)
  std::size_t order = 0;
};

double product(const Terms& a, const Terms& b, std::size_t order) {
  double sum = 0;
  for (std::size_t i = 0; i <= order; ++i) sum += a[i] * b[order - i];
  return sum;
}

double largest(const Series& s, std::size_t order) {
  return std::max({std::abs(s.n[0][order]), std::abs(s.n[1][order]), std::abs(s.n[2][order])});
}

/// n to the order at which two terms in a row are negligible.
void expandMomentum(Series& s, const std::array<double, 3>& gamma) {
  const std::array<double, 3> rate = {gamma[2] - gamma[1], gamma[0] - gamma[2], gamma[1] - gamma[0]};
  for (std::size_t k = 1, small = 0; k <= kMaxOrder && small < 2; ++k) {
    for (std::size_t i = 0; i < 3; ++i)
      s.n[i][k] = rate[i] * product(s.n[(i + 1) % 3], s.n[(i + 2) % 3], k - 1) / static_cast<double>(k);
    s.order = k;
    small = largest(s, k) <= kNegligible * largest(s, 1) ? small + 1 : 0;
  }
}

/// (1 + n·n0) g = sum (gamma_i - mean) n0_i n_i, term by term.
void expandAngle(Series& s, const std::array<double, 3>& gamma, double mean) {
  const std::array<double, 3> n0 = {s.n[0][0], s.n[1][0], s.n[2][0]};
  Terms along{};
  s.g[0] = 0;
  for (std::size_t k = 1; k <= s.order; ++k) {
    const std::array<double, 3> part = {n0[0] * s.n[0][k], n0[1] * s.n[1][k], n0[2] * s.n[2][k]};
    along[k] = part[0] + part[1] + part[2];
    double sum = (gamma[0] - mean) * part[0] + (gamma[1] - mean) * part[1] + (gamma[2] - mean) * part[2];
    for (std::size_t i = 1; i < k; ++i) sum -= along[i] * s.g[k - i];
    s.g[k] = 0.5 * sum;
  }
}

/// n(1) - n(0), smallest terms first.
std::array<double, 3> change(const Series& s) {
  std::array<double, 3> sum{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = s.order; k > 0; --k) sum[i] += s.n[i][k];
  return sum;
}

double angle(const Series& s, double mean) {
  double sum = 0;
  for (std::size_t k = s.order; k > 0; --k) sum += s.g[k] / static_cast<double>(k + 1);
  return mean + sum;
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
  // M = (1 + c + change × m0)/sqrt(2 (1 + c)), c = m·m0 = 1 - |change|^2/2.
  const auto& d = change;
  const double cosine = std::sqrt(1 - 0.25 * (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]));  // of half M's angle
  const double scale = 0.5 / cosine;
  const std::array<double, 3> u = {scale * (d[1] * m0[2] - d[2] * m0[1]), scale * (d[2] * m0[0] - d[0] * m0[2]),
                                   scale * (d[0] * m0[1] - d[1] * m0[0])};
  const SineCosine half = sineCosine(0.5 * phi);
  const double c = half.cosine, s = half.sine, sw = half.sine * cosine;
  const double w = c * cosine;
  const double x = c * u[0] + sw * m0[0] + s * (m0[1] * u[2] - m0[2] * u[1]);
  const double y = c * u[1] + sw * m0[1] + s * (m0[2] * u[0] - m0[0] * u[2]);
  const double z = c * u[2] + sw * m0[2] + s * (m0[0] * u[1] - m0[1] * u[0]);
  // w - 1 without cancellation, where there would be one.
  return {{w > 0 ? -(x * x + y * y + z * z) / (1 + w) : w - 1, x, y, z}};
}

TurnLessOne FreeFlow::turnOver(const std::array<double, 3>& m, double h) const {
  const double L = norm(m);
  if (L == 0) return {};
  const std::array<double, 3> n0 = {m[0] / L, m[1] / L, m[2] / L};
  const std::array<double, 3> gamma = {L / I_[0] * h, L / I_[1] * h, L / I_[2] * h};
  const double square = n0[0] * n0[0] + n0[1] * n0[1] + n0[2] * n0[2];
  const double mean = (gamma[0] * n0[0] * n0[0] + gamma[1] * n0[1] * n0[1] + gamma[2] * n0[2] * n0[2]) / square;
  Series series;
  for (std::size_t i = 0; i < 3; ++i) series.n[i][0] = n0[i];
  expandMomentum(series, gamma);
  expandAngle(series, gamma, mean);
  return turnKeeping(n0, change(series), angle(series, mean));
}

void FreeFlow::apply(DrivenState& state, double h) const {
  const std::array<double, 3> m = state.momentum_P();
  const auto [least, most] = std::minmax({I_[0], I_[1], I_[2]});
  const double turned = norm(m) * std::abs(h) * (1 / least - 1 / most);
  if (turned <= kLongestStep) return state.turn(turnOver(m, h));
  const double parts = std::ceil(turned / kLongestStep);
  for (double i = 0; i < parts; ++i) state.turn(turnOver(state.momentum_P(), h / parts));
}

}  // namespace poinsot::physics
