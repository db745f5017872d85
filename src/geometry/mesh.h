// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace poinsot::geometry {

/// Triangles in space, each counter-clockwise when seen from outside. Lengths in m, axes M.
struct Mesh {
  using Triangle = std::array<std::uint32_t, 3>;  ///< indices into `vertices_M`

  std::vector<Eigen::Vector3d> vertices_M;
  std::vector<Triangle> triangles;
};

}  // namespace poinsot::geometry
