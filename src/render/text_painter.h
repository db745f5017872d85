// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "draw/draw_list.h"
#include "image/image.h"
#include "render/picture_cache.h"
#include "render/screen_outline.h"
#include "text/coverage.h"
#include "text/glyph_run.h"

namespace poinsot::render {

/// Paints type over a finished picture on the CPU. Glyph coverage is exact area, cached because titles stand
/// still; blending is in linear light.
class TextPainter {
 public:
  void beginPicture() { coverage_.beginPicture(); }

  /// Paints the texts in order and returns the places that may have changed. In a picture of four channels a halo
  /// erases the picture under it, regardless of the halo's colour.
  /// @throws core::Error(kUsage) if TeX cannot be set.
  template <typename Sample>
  std::vector<PixelBounds> paint(const std::vector<draw::Text>& texts, image::BasicImage<Sample>& picture);

 private:
  /// Inputs of a coverage map: text, size, left end of the baseline, width of the halo.
  using Key = std::tuple<std::string, float, float, float, float>;

  template <typename Sample>
  PixelBounds paint(const draw::Text& text, image::BasicImage<Sample>& picture);
  const text::GlyphRun& run(const std::string& tex);
  const text::CoverageMap& coverage(const draw::Text& text, float outline_px);

  std::map<std::string, text::GlyphRun> runs_;  // a film shows the same few labels in every frame
  PictureCache<Key, text::CoverageMap> coverage_;
};

}  // namespace poinsot::render
