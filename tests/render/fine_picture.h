// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "render/renderer.h"

/// A picture as it should be: drawn many times as large, and each block averaged.
namespace poinsot::render {

/// What n x n samples a pixel say of a view without its type.
struct FinePicture {
  image::Image mean;  ///< of each pixel's samples in linear light, in sRGB
  /// For each pixel row by row whether an edge runs through it: two neighbouring samples of its own differ by more
  /// than 2/255 in some channel. Smooth shading does not: it would have to change by 2/255 * n from pixel to
  /// pixel.
  std::vector<bool> edge;
};

/// The same view n times as large in every way, lines included, without its type. Only the part `size` large from
/// the corner `from_px` of the large picture is to be seen.
draw::DrawList magnified(const draw::DrawList& list, int n, glm::ivec2 from_px, image::PixelSize size);

/// Drawn by `renderer` in parts, so that no buffer gets too large.
FinePicture finePicture(Renderer& renderer, const draw::DrawList& list, int n);

/// The areas and strokes of a picture n times as large, on its paper: neither panels nor type. Of that, the part
/// `size` large from the corner `from_px`.
draw::Picture magnifiedFlat(const draw::Picture& picture, int n, glm::ivec2 from_px, image::PixelSize size);

/// As finePicture(), of what magnifiedFlat() keeps.
FinePicture fineFlatPicture(Renderer& renderer, const draw::Picture& picture, int n);

}  // namespace poinsot::render
