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

/// A mesh as one picture shows it.
struct ScreenMesh {
  const draw::Mesh* mesh = nullptr;
  const MeshTopology* topology = nullptr;
  std::vector<glm::dvec3> vertices;  ///< x and y in pixels, y down; distance along the view
  std::vector<char> front;           ///< by face: 1 when it looks at the eye
  glm::mat3 axes_C{1};
  glm::vec3 origin_C{0};
  glm::mat3 normals_C{1};  ///< takes normals from M to C; not unit
  PixelBounds bounds;      ///< empty when the mesh is not wholly in front of the camera: it is not drawn then

  std::array<glm::dvec3, 3> triangle(std::size_t face) const;
  bool isFront(std::uint32_t face) const { return face != kNoFace && front[face] != 0; }
  /// Whether one of the edge's faces looks at the eye and the other does not.
  bool isSilhouette(const MeshEdge& e) const { return isFront(e.left) != isFront(e.right); }
  /// Whether the edge could be seen, were nothing before it.
  bool isFront(const MeshEdge& e) const { return isFront(e.left) || isFront(e.right); }
};

/// Length of a pixel's side at a distance along the view.
double pixelSize(const draw::Camera& camera, double depth);

/// Of a triangle in the picture: negative when it looks at the eye, as y counts downwards.
double signedArea(const std::array<glm::dvec3, 3>& triangle);

/// @pre mesh.mesh is not null, `topology` is its own, mesh.axes_V is right-handed; both outlive the result.
ScreenMesh screenMesh(const draw::Camera& camera, const draw::Mesh& mesh, const MeshTopology& topology);

}  // namespace poinsot::render
