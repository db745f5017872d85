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

/// The least box along the axes that holds a mesh.
struct Bounds {
  Eigen::Vector3d low_M, high_M;

  Eigen::Vector3d size_m() const { return high_M - low_M; }
  Eigen::Vector3d centre_M() const { return low_M + size_m() / 2; }
};

/// @pre at least one vertex.
Bounds boundsOf(const Mesh& mesh);

/// The same surface with its inside out.
Mesh flipped(Mesh mesh);

/// Both surfaces; a cavity is a flipped mesh within another.
Mesh joined(Mesh a, const Mesh& b);

/// Every vertex v becomes A v + offset. @pre det A > 0, or outside becomes inside.
Mesh transformed(Mesh mesh, const Eigen::Matrix3d& A, const Eigen::Vector3d& offset_M = Eigen::Vector3d::Zero());

/// Vertices at exactly the same place become one, in the order of their first; those of no triangle go. Files
/// repeat a corner for every triangle (STL) or for every normal (PLY), and a surface closes only along shared
/// ones.
/// @pre finite.
Mesh welded(const Mesh& mesh);

}  // namespace poinsot::geometry
