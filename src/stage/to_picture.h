// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace poinsot::stage {

/// Converts a vector of doubles to the floats of a draw list. Only this header makes this conversion.
inline glm::vec3 toPicture(const Eigen::Vector3d& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

inline glm::mat3 toPicture(const Eigen::Matrix3d& m) {
  return {toPicture(Eigen::Vector3d(m.col(0))), toPicture(Eigen::Vector3d(m.col(1))),
          toPicture(Eigen::Vector3d(m.col(2)))};
}

/// Converts a vector of a draw list back to doubles, for example the position of a camera.
inline Eigen::Vector3d fromPicture(const glm::vec3& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

}  // namespace poinsot::stage
