// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <vector>

#include "render/screen_outline.h"

namespace poinsot::render {

/// The side of a cell. Smaller ones cost more to draw than they save as pixels.
inline constexpr float kCell_px = 16;
/// The side of a tile, which is llvmpipe's own.
inline constexpr int kTile_px = 64;

/// Some pixels, drawn as one point: llvmpipe shades blocks of four pixels that a triangle's edge runs through once
/// for each triangle, and compiles no set-up for points. As squares.vert takes it.
struct Square {
  glm::vec2 centre_px;
  float side_px;

  PixelBounds bounds() const;
};

/// The pixels of a convex outline cut into cells. The passes that look for edges draw `edge` only: in llvmpipe a
/// pixel that is shaded and then discarded costs as much as one that is kept.
struct Cells {
  std::vector<Square> edge;  ///< that the outline may pass through
  std::vector<Square> full;  ///< wholly inside
};

/// They lie in the picture as squared paper does, cut to the bounds, which are of whole pixels: beyond them a
/// shader may see what is not there. `inside` tells whether a point of the picture is inside the outline, which
/// must be convex.
Cells cutIntoCells(const PixelBounds& clipped, const std::function<bool(glm::vec2)>& inside);

/// The fewest squares of 1 to 64 pixels, aligned to their sides, that make up a rectangle of whole pixels.
void addSquares(std::vector<Square>& squares, const PixelBounds& rectangle);

}  // namespace poinsot::render
