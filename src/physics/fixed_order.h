// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace poinsot::physics {

// These sums are written out, because the order of Eigen's sums, and so the last bit, depends on the vector unit.

inline double dotProduct(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Eigen::Vector3d crossProduct(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace poinsot::physics
