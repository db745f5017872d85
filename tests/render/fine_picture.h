// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "render/renderer.h"

/// Reference pictures, drawn many times as large and averaged over blocks.
namespace poinsot::render {

/// Reference of a view without its type, from n x n samples a pixel.
struct FinePicture {
  image::Image mean;  ///< mean of each pixel's samples in linear light, stored as sRGB
  /// Whether an edge runs through each pixel, row by row: two neighbouring samples of the pixel differ by more
  /// than 2/255 in some channel. Smooth shading would have to change by 2/255 * n from pixel to pixel for that.
  std::vector<bool> edge;
};

/// Returns the same view n times as large in every way, lines included, without its type. Shows only the part that
/// is `size` large from the corner `from_px` of the large picture.
draw::DrawList magnified(const draw::DrawList& list, int n, glm::ivec2 from_px, image::PixelSize size);

/// Draws the reference of a view in parts, so that no buffer gets too large.
FinePicture finePicture(Renderer& renderer, const draw::DrawList& list, int n);

/// Returns the areas and strokes of a picture on its paper, n times as large, without panels and type. Shows only
/// the part that is `size` large from the corner `from_px`.
draw::Picture magnifiedFlat(const draw::Picture& picture, int n, glm::ivec2 from_px, image::PixelSize size);

/// Draws the reference of the areas and strokes of a picture, see magnifiedFlat().
FinePicture fineFlatPicture(Renderer& renderer, const draw::Picture& picture, int n);

}  // namespace poinsot::render
