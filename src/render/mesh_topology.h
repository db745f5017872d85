// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "draw/draw_list.h"

namespace poinsot::render {

/// In place of a face, beyond the border of a mesh that is not closed.
inline constexpr std::uint32_t kNoFace = 0xffffffff;

/// An edge between two faces. Sharp: its faces meet at more than the crease angle.
struct MeshEdge {
  std::uint32_t from = 0, to = 0;                 ///< vertices
  std::uint32_t left = kNoFace, right = kNoFace;  ///< faces
  bool sharp = false;
};

/// Sharp edges in a row, as the vertices they join: vertices[i] to vertices[i + 1] is edges[i].
struct EdgeChain {
  std::vector<std::uint32_t> vertices, edges;
};

/// A vertex as the faces of one smooth patch see it.
struct MeshCorner {
  glm::vec3 position_M{0};
  glm::vec3 normal_M{0};  ///< unit; 0 where all faces are degenerate
};

/// What drawing needs to know of a mesh and does not change from frame to frame.
struct MeshTopology {
  std::vector<MeshEdge> edges;
  std::vector<bool> rough;          ///< by face: its corners' normals differ from its own by more than a tenth
  std::vector<EdgeChain> chains;    ///< of all sharp edges
  std::vector<MeshCorner> corners;  ///< one for each patch that a vertex belongs to
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< of the mesh, by corners
};

/// Finds edges, creases and normals. A vertex normal is the mean of its patch's faces with the weights of N. Max,
/// Weights for computing vertex normals from facet normals, Journal of Graphics Tools 4 (1999), which are right
/// for any vertices on a sphere and need no angles.
/// @pre every index names a vertex.
MeshTopology meshTopology(const draw::TriangleMesh& mesh, float crease_rad);

}  // namespace poinsot::render
