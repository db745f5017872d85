// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <vector>

#include "render/screen_outline.h"

namespace poinsot::render {

/// Side of a cell, in pixels. Smaller cells would cost more to draw than the skipped pixels save.
inline constexpr float kCell_px = 16;
/// Side of a tile, in pixels. llvmpipe's own tiles have this size.
inline constexpr int kTile_px = 64;

/// Square of pixels that is drawn as one OpenGL point (squares.vert). For triangles, llvmpipe shades the 2 x 2
/// blocks on a common edge once per triangle and compiles set-up code; for points it does neither.
struct Square {
  glm::vec2 centre_px;
  float side_px;

  PixelBounds bounds() const;
};

/// Pixels of a convex outline, cut into cells: squares that the outline may cross (`edge`) and squares wholly
/// inside (`full`). The edge passes draw only `edge`, because in llvmpipe a pixel that is shaded and then
/// discarded costs as much as one that is kept.
struct Cells {
  std::vector<Square> edge;
  std::vector<Square> full;
};

/// Cuts the bounds of a convex outline into cells on a fixed grid of the picture, clipped to the bounds.
/// @param clipped  whole pixels within the picture, because shaders find no valid data beyond
/// @param inside  returns whether a point of the picture is inside the outline
Cells cutIntoCells(const PixelBounds& clipped, const std::function<bool(glm::vec2)>& inside);

/// Adds the fewest squares that make up a rectangle of whole pixels. Each has a side of 1, 2, 4, ... or 64 pixels
/// and is aligned to its side.
void addSquares(std::vector<Square>& squares, const PixelBounds& rectangle);

}  // namespace poinsot::render
