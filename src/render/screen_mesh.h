// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "draw/draw_list.h"
#include "render/mesh_topology.h"
#include "render/screen_outline.h"

namespace poinsot::render {

/// Mesh as projected into one picture. At a silhouette edge, only one of two faces faces the eye.
struct ScreenMesh {
  const draw::Mesh* mesh = nullptr;
  const MeshTopology* topology = nullptr;
  std::vector<glm::dvec3> vertices;  ///< x and y in pixels (y down), and the distance along the view
  std::vector<char> front;           ///< for each face: 1 if the face faces the eye, otherwise 0
  glm::mat3 axes_C{1};
  glm::vec3 origin_C{0};
  glm::mat3 normals_C{1};  ///< matrix that transforms normals from M to C, without normalising them
  PixelBounds bounds;  ///< empty if the mesh is not completely in front of the camera and is therefore not drawn

  std::array<glm::dvec3, 3> triangle(std::size_t face) const;
  bool isFront(std::uint32_t face) const { return face != kNoFace && front[face] != 0; }
  bool isSilhouette(const MeshEdge& e) const { return isFront(e.left) != isFront(e.right); }
  bool isFront(const MeshEdge& e) const { return isFront(e.left) || isFront(e.right); }
};

/// Returns the side of a pixel as a length in space, at a distance along the view.
double pixelSize(const draw::Camera& camera, double depth);

/// Returns the area of a triangle in the picture. It is negative if the triangle faces the eye (y is down).
double signedArea(const std::array<glm::dvec3, 3>& triangle);

/// Projects a mesh into the picture.
/// @pre mesh.mesh is not null, `topology` was made from it, mesh.axes_V is right-handed; both outlive the result.
ScreenMesh screenMesh(const draw::Camera& camera, const draw::Mesh& mesh, const MeshTopology& topology);

}  // namespace poinsot::render
