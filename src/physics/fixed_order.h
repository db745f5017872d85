// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace poinsot::physics {

// These functions are used instead of Eigen's, whose order of additions depends on the CPU's vector unit. The
// order changes the last bit of a sum.

inline double dotProduct(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Eigen::Vector3d crossProduct(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace poinsot::physics
