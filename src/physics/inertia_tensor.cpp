// SPDX-License-Identifier: Apache-2.0
#include "physics/inertia_tensor.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/error.h"
#include "physics/double_double.h"
#include "physics/rotor.h"

namespace poinsot::physics {
namespace {

using Matrix = std::array<std::array<DoubleDouble, 3>, 3>;

/// Returns the rotation matrix of a rotor of unit length. The form of the diagonal gives exact zeros for a quarter
/// turn.
Matrix rotationMatrix(const Rotor<DoubleDouble>& q) {
  const DoubleDouble ww = q.w * q.w, xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
  const DoubleDouble xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z;
  const DoubleDouble wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
  return {{{(ww - yy) + (xx - zz), 2 * (xy - wz), 2 * (xz + wy)},
           {2 * (xy + wz), (ww - xx) + (yy - zz), 2 * (yz - wx)},
           {2 * (xz - wy), 2 * (yz + wx), (ww - xx) + (zz - yy)}}};
}

Matrix rotationMatrix(const Quaternion& q) {
  if (!q.coeffs().allFinite() || q.coeffs().isZero(0))
    throw core::physicsError(fmt::format("a rotation must be a nonzero, finite quaternion, got ({}, {}, {}, {})",
                                         q.w(), q.x(), q.y(), q.z()));
  // Scales the quaternion, because squares of components beyond 1e±154 leave the range of a double.
  const int exponent = -exponentOf(q.coeffs().cwiseAbs().maxCoeff());
  const auto part = [exponent](double x) { return DoubleDouble(std::ldexp(x, exponent)); };
  return rotationMatrix(normalized(Rotor<DoubleDouble>{part(q.w()), part(q.x()), part(q.y()), part(q.z())}));
}

std::array<DoubleDouble, 3> product(const Matrix& R, const std::array<DoubleDouble, 3>& v) {
  std::array<DoubleDouble, 3> result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = R[i][0] * v[0] + R[i][1] * v[1] + R[i][2] * v[2];
  return result;
}

}  // namespace

Eigen::Matrix3d symmetricTensor(const Eigen::Matrix3d& inertia) {
  constexpr std::array kAxes{'x', 'y', 'z'};
  const auto refuse = [](const std::string& message) { throw core::physicsError(message); };
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (!std::isfinite(inertia(i, j)))
        refuse(fmt::format("inertia tensor must be finite, got I_{}{} = {} kg·m²", kAxes[i], kAxes[j],
                           inertia(i, j)));
  const double largest = inertia.cwiseAbs().maxCoeff();
  Eigen::Matrix3d result = inertia;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < i; ++j) {
      if (std::fabs(inertia(i, j) - inertia(j, i)) > kTensorSlack * largest)
        refuse(fmt::format("inertia tensor must be symmetric, got I_{0}{1} = {2} and I_{1}{0} = {3} kg·m²",
                           kAxes[j], kAxes[i], inertia(j, i), inertia(i, j)));
      result(i, j) = result(j, i) = inertia(j, i) + (inertia(i, j) - inertia(j, i)) / 2;
    }
  return result;
}

Eigen::Matrix3d turnedTensor(const Quaternion& q, const Eigen::Matrix3d& inertia) {
  const Matrix R = rotationMatrix(q);
  Matrix RI;  // (R I)ᵀ: row j is R times column j of I
  for (std::size_t j = 0; j < 3; ++j) {
    const int column = static_cast<int>(j);
    RI[j] = product(R, {inertia(0, column), inertia(1, column), inertia(2, column)});
  }
  Eigen::Matrix3d result;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto row = product(R, {RI[0][i], RI[1][i], RI[2][i]});
    for (std::size_t j = 0; j <= i; ++j) {
      const int m = static_cast<int>(i), n = static_cast<int>(j);
      result(m, n) = result(n, m) = toDouble(row[j]);
    }
  }
  return result;
}

Eigen::Vector3d turnedVector(const Quaternion& q, const Eigen::Vector3d& v) {
  const auto turned = product(rotationMatrix(q), {v[0], v[1], v[2]});
  return {toDouble(turned[0]), toDouble(turned[1]), toDouble(turned[2])};
}

}  // namespace poinsot::physics
