// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <glm/vec4.hpp>
#include <vector>

#include "render/pixel_marks.h"
#include "render/screen_mesh.h"

namespace poinsot::render {

/// One pixel of the meshes as mesh_pixel.vert takes it: up to four directions of surface, each with its share.
struct ResolvedPixel {
  static constexpr std::size_t kFacets = 4;

  glm::vec4 place{0};                          ///< centre in pixels, coverage, distance along the view
  std::array<glm::vec4, kFacets> normals_C{};  ///< unit; w: share of what is covered (0: none)
  std::array<glm::vec4, kFacets> materials{};  ///< colour, gloss
  float solid = 0;                             ///< number of the mesh among those resolved
};

/// The marked pixels, exact: partly covered ones, and those that are filled.
struct ResolvedPixels {
  std::vector<ResolvedPixel> partial, full;
};

/// Works out what of each marked pixel the meshes cover. Areas are exact where surfaces lie side by side, as they
/// do along an outline or a crease; where one hides another the hidden share is found by 64 samples of depth. A
/// near surface before a far one gives two results, so that sheets and lines between them compose.
ResolvedPixels resolveMeshes(const std::vector<ScreenMesh>& meshes, const PixelMarks& marks,
                             const draw::Camera& camera);

}  // namespace poinsot::render
