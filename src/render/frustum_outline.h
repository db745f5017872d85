// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "draw/draw_list.h"
#include "render/screen_outline.h"

namespace poinsot::render {

/// Outline of a frustum in the picture: the convex hull of its two end discs, and other inputs of frustum.frag.
struct FrustumOutline {
  glm::vec3 from_C{0}, axis_C{0, 0, 1};
  float height = 0;
  ScreenEllipse first, second;
  /// edges of the strip between the two discs; edges 0 and 2 are the silhouette
  std::array<glm::vec3, 4> sides{};
  int visibleCap = 0;  ///< disc that faces the eye: 1 for the first, 2 for the second, 0 for neither
  PixelBounds bounds;  ///< empty if the frustum is not completely in front of the camera

  bool inside(glm::vec2 p_px) const;
};

FrustumOutline frustumOutline(const draw::Camera& camera, const draw::Frustum& frustum);

}  // namespace poinsot::render
