// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/abi.h"

namespace poinsot::geometry {

/// Place in a file: a line of a text (counted from 1), or a byte of a binary file (counted from 0).
struct FilePlace {
  std::uint64_t isLine : 1 = 0;
  std::uint64_t number : 63 = 0;
};

constexpr FilePlace atLine(std::uint64_t number) { return {1, number & (~std::uint64_t{0} >> 1)}; }
constexpr FilePlace atByte(std::uint64_t number) { return {0, number & (~std::uint64_t{0} >> 1)}; }

/// Returns "line 12" or "byte 684".
std::string toString(const FilePlace& place);

/// Triangles in space, counter-clockwise when seen from outside. Lengths in m, axes M.
struct Mesh {
  using Triangle = std::array<std::uint32_t, 3>;  ///< indices into `vertices_M`

  std::vector<Eigen::Vector3d> vertices_M;
  std::vector<Triangle> triangles;
  std::vector<FilePlace> places = {};  ///< each triangle's place in its file; empty for a mesh that was not read
};

/// Axis-aligned bounding box of a mesh.
struct Bounds {
  Eigen::Vector3d low_M, high_M;

  Eigen::Vector3d size_m() const { return high_M - low_M; }
  Eigen::Vector3d centre_M() const;
};

/// @pre at least one vertex.
Bounds boundsOf(const Mesh& mesh);

/// Returns the same surface turned inside out.
Mesh flipped(Mesh mesh);

/// Returns both surfaces as one mesh, without their places. A cavity is a flipped mesh within another.
Mesh joined(Mesh a, const Mesh& b);

/// Returns the mesh with each vertex v replaced by A v + offset. @pre det A > 0, or outside becomes inside.
Mesh transformed(Mesh mesh, const Eigen::Matrix3d& A, const Eigen::Vector3d& offset_M = Eigen::Vector3d::Zero());

/// Returns the mesh with vertices at exactly the same place merged into one, in the order of first occurrence, and
/// without unused vertices. Files repeat a corner for every triangle (STL) or for every normal (PLY), but a
/// surface closes only along shared vertices.
/// @pre finite; indices in range.
Mesh welded(const Mesh& mesh);

/// Replaces each vertex i by vertex target[i], and removes the vertices that belong to no triangle. The order of
/// vertices and triangles stays.
/// @pre as many targets as vertices; target[target[i]] == target[i] for every vertex; indices in range.
Mesh merged(const Mesh& mesh, const std::vector<std::uint32_t>& target);

static_assert(core::laidOut<Bounds, 48>());

}  // namespace poinsot::geometry
