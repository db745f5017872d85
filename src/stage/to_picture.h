// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace poinsot::stage {

/// Converts doubles to the floats of a draw list. This header is the only place that does so.
inline glm::vec3 toPicture(const Eigen::Vector3d& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

inline glm::mat3 toPicture(const Eigen::Matrix3d& m) {
  return {toPicture(Eigen::Vector3d(m.col(0))), toPicture(Eigen::Vector3d(m.col(1))),
          toPicture(Eigen::Vector3d(m.col(2)))};
}

/// Converts vectors of the picture back to doubles, for example those of a draw list's camera.
inline Eigen::Vector3d fromPicture(const glm::vec3& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

}  // namespace poinsot::stage
