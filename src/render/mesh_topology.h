// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "draw/draw_list.h"

namespace poinsot::render {

/// Stands for the missing face beyond the border of an open mesh.
inline constexpr std::uint32_t kNoFace = 0xffffffff;

/// Edge between two faces, given by the indices of its vertices and faces. An edge is sharp if its faces meet at
/// more than the crease angle.
struct MeshEdge {
  std::uint32_t from = 0, to = 0;
  std::uint32_t left = kNoFace, right = kNoFace;
  bool sharp = false;
};

/// Chain of sharp edges: edges[i] joins vertices[i] and vertices[i + 1].
struct EdgeChain {
  std::vector<std::uint32_t> vertices, edges;
};

/// Vertex of one smooth patch of faces.
struct MeshCorner {
  glm::vec3 position_M{0};
  glm::vec3 normal_M{0};  ///< unit normal of the patch; 0 if all its faces are degenerate
};

/// Edges, creases and normals of a mesh, which do not change from frame to frame.
struct MeshTopology {
  std::vector<MeshEdge> edges;
  std::vector<bool> rough;  ///< by face: whether a corner's normal differs from the face's by more than 0.1 rad
  std::vector<EdgeChain> chains;
  std::vector<MeshCorner> corners;                      ///< one per vertex and patch
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< faces of the mesh, as indices of corners
};

/// Finds the edges, creases and normals of a mesh. A vertex normal is the mean over the faces of its patch, with
/// the weights of N. Max, Weights for computing vertex normals from facet normals, Journal of Graphics Tools 4
/// (1999). These are right for any vertices on a sphere and need no angles.
/// @pre every index names a vertex.
MeshTopology meshTopology(const draw::TriangleMesh& mesh, float crease_rad);

}  // namespace poinsot::render
