// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "physics/double_double.h"
#include "physics/unaligned_types.h"

namespace poinsot::physics {

/// Rotation as a quaternion w + x i + y j + z k, with components of type double or DoubleDouble. It replaces
/// Eigen's quaternion, whose order of additions depends on the CPU's vector unit, and with it the last bit.
template <typename T>
struct Rotor {
  T w = T(1), x = T(0), y = T(0), z = T(0);
};

template <typename T>
Rotor<T> operator*(const Rotor<T>& p, const Rotor<T>& q) {
  return {p.w * q.w - p.x * q.x - p.y * q.y - p.z * q.z, p.w * q.x + p.x * q.w + p.y * q.z - p.z * q.y,
          p.w * q.y - p.x * q.z + p.y * q.w + p.z * q.x, p.w * q.z + p.x * q.y - p.y * q.x + p.z * q.w};
}

template <typename T>
Rotor<T> conjugate(const Rotor<T>& q) {
  return {q.w, -q.x, -q.y, -q.z};
}

template <typename T>
Rotor<T> normalized(const Rotor<T>& q) {
  using std::sqrt;
  const T norm = sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {q.w / norm, q.x / norm, q.y / norm, q.z / norm};
}

/// Returns the rotated vector q v q^-1. @pre q is of unit length.
template <typename T>
std::array<T, 3> rotated(const Rotor<T>& q, const std::array<T, 3>& v) {
  const T two(2);
  const T tx = two * (q.y * v[2] - q.z * v[1]), ty = two * (q.z * v[0] - q.x * v[2]),
          tz = two * (q.x * v[1] - q.y * v[0]);
  return {v[0] + q.w * tx + (q.y * tz - q.z * ty), v[1] + q.w * ty + (q.z * tx - q.x * tz),
          v[2] + q.w * tz + (q.x * ty - q.y * tx)};
}

/// Rotates an Eigen vector with a fixed order of additions. In Eigen's own rotation, the order depends on the
/// vector unit.
inline Eigen::Vector3d rotated(const Quaternion& q, const Eigen::Vector3d& v) {
  const auto r = rotated(Rotor<double>{q.w(), q.x(), q.y(), q.z()}, std::array{v[0], v[1], v[2]});
  return {r[0], r[1], r[2]};
}

inline Rotor<double> toDouble(const Rotor<DoubleDouble>& q) {
  return {toDouble(q.w), toDouble(q.x), toDouble(q.y), toDouble(q.z)};
}

/// Returns the cosine and the sine of half an angle, given the cosine and the sine of the angle. The returned
/// cosine is not negative.
template <typename T>
std::array<T, 2> halfAngle(const T& cosine, const T& sine) {
  using std::sqrt;
  const T half(0.5);
  if (!(cosine < T(0))) {
    const T c = sqrt((T(1) + cosine) * half);
    return {c, sine * half / c};
  }
  const T s = sqrt((T(1) - cosine) * half);
  return sine < T(0) ? std::array<T, 2>{-(sine * half / s), -s} : std::array<T, 2>{sine * half / s, s};
}

/// Returns the node frame of m: the rotation Rz(psi) Rx(theta) that takes z to m/|m| and x to the node line z × m.
/// m must not be parallel to z.
template <typename T>
Rotor<T> nodeFrame(const T& mx, const T& my, const T& mz) {
  using std::sqrt;
  const T h = sqrt(mx * mx + my * my), norm = sqrt(mx * mx + my * my + mz * mz);
  const auto [cosPsi, sinPsi] = halfAngle<T>(-my / h, mx / h);
  const auto [cosTheta, sinTheta] = halfAngle<T>(mz / norm, h / norm);
  return {cosPsi * cosTheta, cosPsi * sinTheta, sinPsi * sinTheta, sinPsi * cosTheta};
}

}  // namespace poinsot::physics
