// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "draw/draw_list.h"

namespace poinsot::render {

/// Index of a missing face, beyond the border of an open mesh.
inline constexpr std::uint32_t kNoFace = 0xffffffff;

/// Edge between two faces, stored as indices of vertices and faces. An edge is sharp if the angle between its
/// faces exceeds the crease angle, or if the edge is a border of the mesh.
struct MeshEdge {
  std::uint32_t from = 0, to = 0;
  std::uint32_t left = kNoFace, right = kNoFace;
  bool sharp = false;
};

/// Chain of sharp edges. edges[i] joins vertices[i] and vertices[i + 1].
struct EdgeChain {
  std::vector<std::uint32_t> vertices, edges;
};

/// Vertex as part of one smooth patch of faces. A vertex on a sharp edge belongs to several patches.
struct MeshCorner {
  glm::vec3 position_M{0};
  glm::vec3 normal_M{0};  ///< unit normal of the patch; 0 if all its faces have no area
};

/// Edges, creases and normals of a mesh, which do not change from frame to frame.
struct MeshTopology {
  std::vector<MeshEdge> edges;
  /// For each face: whether the normal at one of its corners differs from the face's own by more than 0.1 rad
  std::vector<bool> rough;
  std::vector<EdgeChain> chains;
  std::vector<MeshCorner> corners;                      ///< one for each vertex of each smooth patch
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< faces of the mesh, as indices of corners
};

/// Finds the edges, creases and vertex normals of a mesh. The normal at a vertex is a weighted mean over the faces
/// of its smooth patch. The weights need no angles and give exact normals for vertices on a sphere. Source: N.
/// Max, Weights for computing vertex normals from facet normals, Journal of Graphics Tools 4 (1999).
/// @pre every index names a vertex.
MeshTopology meshTopology(const draw::TriangleMesh& mesh, float crease_rad);

}  // namespace poinsot::render
