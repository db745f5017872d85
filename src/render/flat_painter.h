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

/// Paints areas and strokes over a finished picture on the CPU, blended in linear light. Coverage is the exact
/// area. It is cached, because axes and finished curves are the same in every frame.
class FlatPainter {
 public:
  void beginPicture() { coverage_.beginPicture(); }

  /// Paints the areas, then the strokes, each in list order. Returns the rectangles that may have changed.
  template <typename Sample>
  std::vector<PixelBounds> paint(const draw::Picture& flat, image::BasicImage<Sample>& picture);

 private:
  /// Inputs of a coverage map: picture width and height, points, line width (0 for an area), dash length, closed.
  using Key = std::tuple<int, int, std::vector<float>, float, float, bool>;

  template <typename Sample>
  PixelBounds paint(const draw::Area& area, image::BasicImage<Sample>& picture);
  template <typename Sample>
  PixelBounds paint(const draw::Stroke& stroke, image::BasicImage<Sample>& picture);

  PictureCache<Key, text::CoverageMap> coverage_;
};

}  // namespace poinsot::render
