// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "draw/draw_list.h"
#include "render/screen_outline.h"

namespace poinsot::render {

/// Vertex of a strip. The file curve.vert documents its components.
struct StripVertex {
  glm::vec2 position_px;
  glm::vec4 across;
  glm::vec4 tangent_C;
};

struct CurveStrip {
  std::vector<StripVertex> triangles;  ///< three vertices per triangle
  PixelBounds bounds;
};

/// Widens a curve to its width in pixels, with mitres at bends. Leaves out parts behind the camera. Leaves out
/// points that are at most 1/50 pixel (1/20 pixel along the view) off the line between their neighbours.
CurveStrip makeCurveStrip(const draw::Camera& camera, const draw::Curve& curve);

}  // namespace poinsot::render
