// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "draw/draw_list.h"
#include "render/screen_outline.h"

namespace poinsot::render {

/// The faces of a box that look at the eye; three entries always, a missing one has nothing inside its edges.
struct BoxOutline {
  std::array<std::array<glm::vec3, 4>, 3> edges;
  std::array<glm::vec3, 3> normals_C, points_C;
  PixelBounds bounds;  ///< empty when the box is not wholly in front of the camera

  bool inside(glm::vec2 p_px) const;
};

BoxOutline boxOutline(const draw::Camera& camera, const draw::Box& box);

}  // namespace poinsot::render
