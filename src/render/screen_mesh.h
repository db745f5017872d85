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

/// Mesh, projected into one picture. A face is `front` if it faces the eye; a silhouette edge has one front face.
struct ScreenMesh {
  const draw::Mesh* mesh = nullptr;
  const MeshTopology* topology = nullptr;
  std::vector<glm::dvec3> vertices;  ///< x and y in pixels, y down; distance along the view
  std::vector<char> front;           ///< by face: 1 if the face faces the eye
  glm::mat3 axes_C{1};
  glm::vec3 origin_C{0};
  glm::mat3 normals_C{1};  ///< takes normals from M to C; the results are not unit vectors
  PixelBounds bounds;      ///< empty if the mesh is not wholly in front of the camera, and thus not drawn

  std::array<glm::dvec3, 3> triangle(std::size_t face) const;
  bool isFront(std::uint32_t face) const { return face != kNoFace && front[face] != 0; }
  bool isSilhouette(const MeshEdge& e) const { return isFront(e.left) != isFront(e.right); }
  bool isFront(const MeshEdge& e) const { return isFront(e.left) || isFront(e.right); }
};

/// Returns the length of a pixel's side at a distance along the view.
double pixelSize(const draw::Camera& camera, double depth);

/// Returns the area of a triangle in the picture. It is negative if the triangle faces the eye, because y counts
/// downwards.
double signedArea(const std::array<glm::dvec3, 3>& triangle);

/// Projects a mesh into the picture.
/// @pre mesh.mesh is not null, `topology` is its own, mesh.axes_V is right-handed; both outlive the result.
ScreenMesh screenMesh(const draw::Camera& camera, const draw::Mesh& mesh, const MeshTopology& topology);

}  // namespace poinsot::render
