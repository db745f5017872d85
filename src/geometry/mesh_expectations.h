// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/expect.h"
#include "geometry/mesh.h"

namespace poinsot::geometry {

inline void expectIndicesInRange(const Mesh& mesh) {
  const std::size_t vertices = mesh.vertices_M.size();
  for (const auto& [a, b, c] : mesh.triangles) POINSOT_EXPECT(a < vertices && b < vertices && c < vertices);
}

inline void expectFinite(const Mesh& mesh) {
  for (const Eigen::Vector3d& vertex_M : mesh.vertices_M) POINSOT_EXPECT(vertex_M.allFinite());
}

}  // namespace poinsot::geometry
