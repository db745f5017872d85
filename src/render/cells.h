// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <vector>

#include "render/screen_outline.h"

namespace poinsot::render {

/// Side of a cell in pixels. Smaller cells would cost more time to draw than they save.
inline constexpr float kCell_px = 16;
/// Side of a tile in pixels. llvmpipe divides its framebuffers into tiles of the same size.
inline constexpr int kTile_px = 64;

/// Square of pixels that is drawn as one OpenGL point (squares.vert). In llvmpipe, points are cheaper: two
/// adjacent triangles both shade the 2 x 2 blocks on their common edge, and triangles need compiled set-up code.
struct Square {
  glm::vec2 centre_px;
  float side_px;

  PixelBounds bounds() const;
};

/// Pixels of a convex outline, divided into squares. The outline may cross the squares in `edge`; the squares in
/// `full` lie completely inside. Edge passes draw only `edge`, because in llvmpipe discarded pixels cost time too.
struct Cells {
  std::vector<Square> edge;
  std::vector<Square> full;
};

/// Divides the bounds of a convex outline into cells on a fixed grid of the picture.
/// @param clipped  bounds of the outline in whole pixels, clipped to the picture
/// @param inside  returns whether a point of the picture is inside the outline
Cells cutIntoCells(const PixelBounds& clipped, const std::function<bool(glm::vec2)>& inside);

/// Adds the fewest squares that make up a rectangle of whole pixels. The side of a square is a power of two from 1
/// to 64 pixels, and its position is a multiple of its side.
void addSquares(std::vector<Square>& squares, const PixelBounds& rectangle);

}  // namespace poinsot::render
