// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "draw/draw_list.h"
#include "render/screen_outline.h"

namespace poinsot::render {

/// One vertex of curve.vert; the comments there say what each component is.
struct StripVertex {
  glm::vec2 position_px;
  glm::vec4 across;
  glm::vec4 tangent_C;
};

/// A curve as triangles in the picture.
struct CurveStrip {
  std::vector<StripVertex> triangles;  ///< three to a triangle
  PixelBounds bounds;
};

/// Widens a curve to its width in pixels, mitred at bends; parts behind the camera are left out, and points
/// within a fiftieth of a pixel of the line between others, along the view a twentieth.
CurveStrip makeCurveStrip(const draw::Camera& camera, const draw::Curve& curve);

}  // namespace poinsot::render
