// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "draw/draw_list.h"

namespace poinsot::figure {

/// A piece of a flat curve as the eye sees it: nothing opaque in front of it, one colour.
struct SeenLine {
  std::vector<glm::dvec2> points_px;  ///< from the picture's top left corner, y down
  bool closed = false;
  double width_px = 1;
  draw::Color color{0};  ///< linear light, dimmed and tinted by the sheets in front; opaque
};

/// The flat curves (radius_V = 0) of a list, farther ones first wherever two of different colour meet: painted in
/// this order over the rendered surfaces they make the picture. Ends at silhouettes are found to 0.1 px, points
/// that lie within 0.05 px of the line without them are left out, and a colour is right to 2/255 in sRGB.
std::vector<SeenLine> seenLines(const draw::DrawList& list);

}  // namespace poinsot::figure
