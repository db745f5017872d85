// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <vector>

#include "render/screen_outline.h"

namespace poinsot::render {

/// The side of a cell. Smaller ones cost more as triangles than they save as pixels.
inline constexpr float kCell_px = 16;

/// The pixels of a convex outline cut into cells, as triangles. The passes that look for edges draw `edge` only:
/// in llvmpipe a pixel that is shaded and then discarded costs as much as one that is kept.
struct Cells {
  std::vector<glm::vec2> edge;  ///< cells that the outline may pass through
  std::vector<glm::vec2> full;  ///< cells wholly inside
};

/// They lie in the picture as squared paper does, cut to the bounds.
/// `inside` tells whether a point of the picture is inside the outline, which must be convex.
Cells cutIntoCells(const PixelBounds& clipped, const std::function<bool(glm::vec2)>& inside);

/// Two triangles.
void addRectangle(std::vector<glm::vec2>& triangles, const PixelBounds& rectangle);

}  // namespace poinsot::render
