// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "draw/draw_list.h"

namespace poinsot::figure {

/// Visible piece of a flat curve, in one colour, with nothing opaque in front.
struct SeenLine {
  std::vector<glm::dvec2> points_px;  ///< from the picture's top left corner, y down
  bool closed = false;
  double width_px = 1;
  draw::Color color{0};  ///< linear light, dimmed and tinted by the sheets in front; opaque
};

/// Returns the visible pieces of a list's flat curves (radius_V = 0), in the order for painting over the rendered
/// surfaces: where pieces of different colour meet, the farther one comes first. Ends at silhouettes are found to
/// 0.1 px, and a colour is right to 2/255 in sRGB. Points within 0.05 px of the line without them are left out.
std::vector<SeenLine> seenLines(const draw::DrawList& list);

}  // namespace poinsot::figure
