// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "draw/draw_list.h"

namespace poinsot::figure {

/// Piece of a flat curve that no solid hides, in one colour.
struct SeenLine {
  std::vector<glm::dvec2> points_px;  ///< points of the piece, from the picture's top left corner, y down
  bool closed = false;
  double width_px = 1;
  draw::Color color{0};  ///< opaque linear light, as dimmed and tinted by the sheets in front
};

/// Returns the visible pieces of a list's flat curves (radius_V = 0), for painting over the rendered surfaces.
/// Where pieces of different colour meet, the farther piece comes first. Ends at silhouettes are exact to 0.1 px
/// and colours to 2/255 in sRGB. Points that change the line by less than 0.05 px are left out.
std::vector<SeenLine> seenLines(const draw::DrawList& list);

}  // namespace poinsot::figure
