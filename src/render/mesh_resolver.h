// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <glm/vec4.hpp>
#include <vector>

#include "render/pixel_marks.h"
#include "render/screen_mesh.h"

namespace poinsot::render {

/// Pixel of the meshes, as a vertex of mesh_pixel.vert: up to four surface directions, each with its share.
struct ResolvedPixel {
  static constexpr std::size_t kFacets = 4;

  glm::vec4 place{0};  ///< x and y of the centre in pixels, coverage, distance along the view
  std::array<glm::vec4, kFacets> normals_C{};  ///< unit normal; w: share of the covered area (0: unused)
  std::array<glm::vec4, kFacets> materials{};  ///< colour, gloss
  float solid = 0;                             ///< index of the mesh among the resolved meshes
};

struct ResolvedPixels {
  std::vector<ResolvedPixel> partial, full;
};

/// Computes how the meshes cover each marked pixel. Areas are exact where surfaces lie side by side, as along an
/// outline or a crease; where one surface hides another, 64 samples of depth estimate the hidden share. A near
/// surface in front of a far one gives two results, so that sheets and lines between them are composed correctly.
ResolvedPixels resolveMeshes(const std::vector<ScreenMesh>& meshes, const PixelMarks& marks,
                             const draw::Camera& camera);

}  // namespace poinsot::render
