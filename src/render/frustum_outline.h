// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "draw/draw_list.h"
#include "render/screen_outline.h"

namespace poinsot::render {

/// Picture of a frustum: the hull of its two end discs, and the values that frustum.frag needs to shade it.
struct FrustumOutline {
  glm::vec3 from_C{0}, axis_C{0, 0, 1};
  float height = 0;
  ScreenEllipse first, second;
  std::array<glm::vec3, 4> sides{};  ///< edges of the strip between the tangents; 0 and 2 are the silhouette
  int visibleCap = 0;                ///< disc that faces the eye: 1 the first, 2 the second, 0 none
  PixelBounds bounds;                ///< empty if the frustum is not wholly in front of the camera

  bool inside(glm::vec2 p_px) const;
};

FrustumOutline frustumOutline(const draw::Camera& camera, const draw::Frustum& frustum);

}  // namespace poinsot::render
