// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/abi.h"

namespace poinsot::geometry {

/// Position in a file: a line number in a text file (from 1), or a byte number in a binary file (from 0).
struct FilePlace {
  std::uint64_t isLine : 1 = 0;
  std::uint64_t number : 63 = 0;
};

constexpr FilePlace atLine(std::uint64_t number) { return {1, number & (~std::uint64_t{0} >> 1)}; }
constexpr FilePlace atByte(std::uint64_t number) { return {0, number & (~std::uint64_t{0} >> 1)}; }

/// Returns a text such as "line 12" or "byte 684".
std::string toString(const FilePlace& place);

/// Surface of triangles, whose corners run counter-clockwise when seen from outside. Lengths are in m, along the
/// mesh's axes M.
struct Mesh {
  using Triangle = std::array<std::uint32_t, 3>;  ///< indices into `vertices_M`

  std::vector<Eigen::Vector3d> vertices_M;
  std::vector<Triangle> triangles;
  std::vector<FilePlace> places = {};  ///< position of each triangle in its file; empty if not read from a file
};

/// Axis-aligned bounding box of a mesh.
struct Bounds {
  Eigen::Vector3d low_M, high_M;

  Eigen::Vector3d size_m() const { return high_M - low_M; }
  Eigen::Vector3d centre_M() const;
};

/// Returns the bounding box of all vertices. @pre at least one vertex.
Bounds boundsOf(const Mesh& mesh);

/// Returns the same surface turned inside out.
Mesh flipped(Mesh mesh);

/// Returns both surfaces as one mesh, without file positions. To make a cavity, join a body and a flipped() mesh
/// inside it.
Mesh joined(Mesh a, const Mesh& b);

/// Returns the mesh with each vertex v replaced by A v + offset.
/// @pre det A > 0, because a reflection would turn the surface inside out.
Mesh transformed(Mesh mesh, const Eigen::Matrix3d& A, const Eigen::Vector3d& offset_M = Eigen::Vector3d::Zero());

/// Merges vertices at exactly the same position into one, in the order of first occurrence. Removes unused
/// vertices. A surface is closed only if its triangles share vertices, but files repeat a corner for every
/// triangle (STL) or for every normal (PLY).
/// @pre finite; indices in range.
Mesh welded(const Mesh& mesh);

/// Replaces each vertex i by vertex target[i], and removes the vertices that then belong to no triangle. Keeps the
/// order of vertices and triangles.
/// @pre as many targets as vertices; target[target[i]] == target[i] for every vertex; indices in range.
Mesh merged(const Mesh& mesh, const std::vector<std::uint32_t>& target);

static_assert(core::laidOut<Bounds, 48>());

}  // namespace poinsot::geometry
