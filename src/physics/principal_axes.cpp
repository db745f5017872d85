// SPDX-License-Identifier: Apache-2.0
#include "physics/principal_axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/expect.h"
#include "physics/inertia_tensor.h"
#include "physics/rotor.h"
#include "physics/symmetric_eigen.h"

namespace poinsot::physics {
namespace {

using Vector = std::array<DoubleDouble, 3>;

/// Sets components to 0 that are only rounding errors of a turn there and back. A spin along a principal axis then
/// stays exactly steady; about the middle axis, a rounding error would grow into a flip. The limit is 8 units in
/// the last place of the largest component. In 2e7 random turns, the errors were at most 5.4 units.
Eigen::Vector3d withoutRounding(const Eigen::Vector3d& v) {
  const double rounding = 8 * std::numeric_limits<double>::epsilon() * v.cwiseAbs().maxCoeff();
  return v.unaryExpr([&](double component) { return std::abs(component) <= rounding ? 0.0 : component; });
}

Quaternion toQuaternion(const Rotor<DoubleDouble>& rotor) {
  const Rotor<double> q = toDouble(normalized(rotor));
  return {q.w, q.x, q.y, q.z};
}

Vector operator-(const Vector& v) { return {-v[0], -v[1], -v[2]}; }

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double offDiagonal(const Eigen::Matrix3d& I) {
  return std::max({std::fabs(I(1, 0)), std::fabs(I(2, 0)), std::fabs(I(2, 1))});
}

struct Sorted {
  std::array<double, 3> moments;
  std::array<Vector, 3> axes_B;
};

Sorted sorted(const SymmetricEigen& eigen) {
  std::array<std::size_t, 3> order{0, 1, 2};
  std::ranges::stable_sort(order, [&](std::size_t i, std::size_t j) { return eigen.values[i] < eigen.values[j]; });
  Sorted result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.moments[i] = toDouble(eigen.values[order[i]]);
    result.axes_B[i] = eigen.vectors[order[i]];
  }
  return result;
}

/// Makes two or three moments equal if they differ by no more than the rounding error of an inertia tensor.
/// @param moments  ascending
void equalize(std::array<double, 3>& moments) {
  auto& [a, b, c] = moments;
  const bool low = b - a <= kTensorRounding * c, high = c - b <= kTensorRounding * c;
  if (low && high)
    a = b = c = a + ((b - a) + (c - a)) / 3;
  else if (low)
    a = b = a + (b - a) / 2;
  else if (high)
    b = c = b + (c - b) / 2;
}

/// Returns the rotation to the axes of three different moments. Four rotations are possible, which differ in the
/// signs of the axes. The result is the one with the smallest turn from B, which has the largest trace.
Quaternion nearestOfFour(std::array<Vector, 3> axes_B) {
  axes_B[2] = cross(axes_B[0], axes_B[1]);
  const auto traceWith = [&](std::size_t kept) {  // reverses the axes other than `kept`; 3 reverses none
    DoubleDouble trace;
    for (std::size_t i = 0; i < 3; ++i) trace += kept == 3 || kept == i ? axes_B[i][i] : -axes_B[i][i];
    return trace;
  };
  std::size_t best = 3;
  for (std::size_t kept = 0; kept < 3; ++kept)
    if (traceWith(kept) > traceWith(best)) best = kept;
  for (std::size_t i = 0; i < 3; ++i)
    if (best != 3 && best != i) axes_B[i] = -axes_B[i];
  const auto& [x, y, z] = axes_B;
  const DoubleDouble w = sqrt(1 + x[0] + y[1] + z[2]) / 2, fourW = 4 * w;
  return toQuaternion({w, (y[2] - z[1]) / fourW, (z[0] - x[2]) / fourW, (x[1] - y[0]) / fourW});
}

/// Returns the shortest turn that brings axis number `which` of B onto the line of axis_B. Used for symmetric
/// bodies, whose other two axes are arbitrary.
Quaternion shortestTurn(std::size_t which, Vector axis_B) {
  if (axis_B[which].hi < 0) axis_B = -axis_B;
  Vector from{0, 0, 0};
  from[which] = 1;
  const Vector sine = cross(from, axis_B);
  return toQuaternion({1 + axis_B[which], sine[0], sine[1], sine[2]});
}

PrincipalMoments momentsOf(const std::array<double, 3>& moments) {
  return PrincipalMoments({moments[0], moments[1], moments[2]});
}

/// Rejects a smallest moment that should be 0 and is only a rounding error, as in the rotated tensor of a thin
/// rod.
/// @param moments  ascending
void requireThickness(const std::array<double, 3>& moments) {
  const auto& [low, middle, high] = moments;
  if (low > 0 && low <= kTensorRounding * high)
    throw core::physicsError(fmt::format(
        "principal moments must be positive; the least of ({}, {}, {}) kg·m² is only a rounding error: matter on "
        "one line has no moment about that line; add another part, or give the body an extent",
        low, middle, high));
}

/// Returns the moments of a tensor that is diagonal in B up to rounding, in the order of B's axes.
PrincipalMoments keptMoments(const Eigen::Matrix3d& inertia_B) {
  const std::array<double, 3> diagonal{inertia_B(0, 0), inertia_B(1, 1), inertia_B(2, 2)};
  if (offDiagonal(inertia_B) == 0) return momentsOf(diagonal);
  std::array<std::size_t, 3> order{0, 1, 2};
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return diagonal[i]; });
  std::array<double, 3> ascending{diagonal[order[0]], diagonal[order[1]], diagonal[order[2]]};
  requireThickness(ascending);
  equalize(ascending);
  std::array<double, 3> kept{};
  for (std::size_t i = 0; i < 3; ++i) kept[order[i]] = ascending[i];
  return momentsOf(kept);
}

PrincipalAxes turnedAxes(const Eigen::Matrix3d& inertia_B) {
  const Sorted system = sorted(symmetricEigen(inertia_B));
  std::array<double, 3> moments = system.moments;
  requireThickness(moments);
  equalize(moments);
  const PrincipalMoments checked = momentsOf(moments);
  const bool low = moments[0] == moments[1], high = moments[1] == moments[2];
  if (low && high) return checked;
  if (low) return {checked, shortestTurn(2, system.axes_B[2])};
  if (high) return {checked, shortestTurn(0, system.axes_B[0])};
  return {checked, nearestOfFour(system.axes_B)};
}

PrincipalAxes axesOf(const Eigen::Matrix3d& given_B) {
  const Eigen::Matrix3d inertia_B = symmetricTensor(given_B);
  const bool diagonal = offDiagonal(inertia_B) <= kTensorRounding * inertia_B.cwiseAbs().maxCoeff();
  return diagonal ? PrincipalAxes(keptMoments(inertia_B)) : turnedAxes(inertia_B);
}

}  // namespace

PrincipalAxes::PrincipalAxes(const PrincipalMoments& moments, const Quaternion& q_BP)
    : moments_(moments), q_BP_(q_BP), aligned_(q_BP.vec().isZero(0)) {
  POINSOT_EXPECT(std::fabs(q_BP.squaredNorm() - 1) < 1e-12);
}

PrincipalAxes::PrincipalAxes(const Eigen::Matrix3d& inertia_B) : PrincipalAxes(axesOf(inertia_B)) {}

Eigen::Vector3d PrincipalAxes::toP(const Eigen::Vector3d& v_B) const {
  return aligned_ ? v_B : withoutRounding(rotated(q_BP_.conjugate(), v_B));
}

Eigen::Vector3d PrincipalAxes::toB(const Eigen::Vector3d& v_P) const {
  return aligned_ ? v_P : rotated(q_BP_, v_P);
}

Eigen::Vector3d PrincipalAxes::angularMomentum(const Eigen::Vector3d& omega_B) const {
  return toB(moments_.angularMomentum(toP(omega_B)));
}

Eigen::Vector3d PrincipalAxes::angularVelocity(const Eigen::Vector3d& m_B) const {
  return toB(toP(m_B).cwiseQuotient(moments_.values()));
}

Eigen::Matrix3d PrincipalAxes::inertia_B() const {
  return turnedTensor(q_BP_, moments_.values().asDiagonal().toDenseMatrix());
}

}  // namespace poinsot::physics
