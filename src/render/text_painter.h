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

/// Paints text over a finished picture on the CPU, blended in linear light. The coverage of glyphs is the exact
/// area. It is cached, because labels are the same in most frames.
class TextPainter {
 public:
  void beginPicture() { coverage_.beginPicture(); }

  /// Paints the texts in order. Returns the rectangles that may have changed. In a picture with four channels, a
  /// halo erases the picture under it; the halo's colour has no effect.
  /// @throws core::Error(kUsage) if TeX cannot be set.
  template <typename Sample>
  std::vector<PixelBounds> paint(const std::vector<draw::Text>& texts, image::BasicImage<Sample>& picture);

 private:
  /// Inputs that determine a coverage map: TeX text, size, x and y of the baseline's left end, width of the halo.
  using Key = std::tuple<std::string, float, float, float, float>;

  template <typename Sample>
  PixelBounds paint(const draw::Text& text, image::BasicImage<Sample>& picture);
  const text::GlyphRun& run(const std::string& tex);
  const text::CoverageMap& coverage(const draw::Text& text, float outline_px);

  std::map<std::string, text::GlyphRun> runs_;  // typeset labels; a film shows the same few labels in every frame
  PictureCache<Key, text::CoverageMap> coverage_;
};

}  // namespace poinsot::render
