// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <glm/vec4.hpp>
#include <vector>

#include "render/pixel_marks.h"
#include "render/screen_mesh.h"

namespace poinsot::render {

/// Pixel of a mesh as the CPU computed it: up to four surface directions, each with the fraction of the covered
/// area that it takes. The layout is a vertex of mesh_pixel.vert.
struct ResolvedPixel {
  static constexpr std::size_t kFacets = 4;

  glm::vec4 place{0};  ///< x and y of the pixel's centre, coverage, distance along the view
  std::array<glm::vec4, kFacets> normals_C{};  ///< unit normal; w: fraction of the covered area, 0 if unused
  std::array<glm::vec4, kFacets> materials{};  ///< colour, gloss
  float solid = 0;                             ///< index of the mesh in the list of resolved meshes
};

struct ResolvedPixels {
  std::vector<ResolvedPixel> partial, full;
};

/// Computes how the meshes cover each marked pixel. Areas are exact where surfaces are side by side, as along an
/// outline or a crease. Where one surface hides another, 64 depth samples estimate the hidden fraction. If a near
/// surface covers part of a far surface, the pixel gets two results, so that sheets and lines between the surfaces
/// are drawn in the right order.
ResolvedPixels resolveMeshes(const std::vector<ScreenMesh>& meshes, const PixelMarks& marks,
                             const draw::Camera& camera);

}  // namespace poinsot::render
