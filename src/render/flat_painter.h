// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>
#include <vector>

#include "draw/picture.h"
#include "image/image.h"
#include "render/picture_cache.h"
#include "render/screen_outline.h"
#include "text/coverage.h"

namespace poinsot::render {

/// Lays areas and strokes over a finished picture, on the CPU: coverage is exact area, blending is in linear
/// light.
class FlatPainter {
 public:
  /// Forgets what the picture before did not show.
  void beginPicture() { coverage_.beginPicture(); }

  /// Areas first, then strokes, each in the order of the list. Returns the places that changed.
  template <typename Sample>
  std::vector<PixelBounds> paint(const draw::Picture& flat, image::BasicImage<Sample>& picture);

 private:
  /// What a coverage map depends on: picture size, points, width (0: an area), dash, whether closed.
  using Key = std::tuple<int, int, std::vector<float>, float, float, bool>;

  template <typename Sample>
  PixelBounds paint(const draw::Area& area, image::BasicImage<Sample>& picture);
  template <typename Sample>
  PixelBounds paint(const draw::Stroke& stroke, image::BasicImage<Sample>& picture);

  PictureCache<Key, text::CoverageMap> coverage_;  // axes and past curves stand still
};

}  // namespace poinsot::render
