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

/// Lays type over a finished picture, on the CPU: glyph coverage is exact area, blending is in linear light.
class TextPainter {
 public:
  /// Forgets the type that the picture before did not show.
  void beginPicture() { coverage_.beginPicture(); }

  /// Returns the places that changed.
  /// In a picture of four channels a halo is its paper too: nothing, whatever colour the list has for it.
  /// @throws core::Error(kUsage) for TeX that cannot be set.
  template <typename Sample>
  std::vector<PixelBounds> paint(const std::vector<draw::Text>& texts, image::BasicImage<Sample>& picture);

 private:
  /// What a coverage map depends on: the text, its size, the left end of its baseline, the width of its halo.
  using Key = std::tuple<std::string, float, float, float, float>;

  template <typename Sample>
  PixelBounds paint(const draw::Text& text, image::BasicImage<Sample>& picture);
  const text::GlyphRun& run(const std::string& tex);
  const text::CoverageMap& coverage(const draw::Text& text, float outline_px);

  std::map<std::string, text::GlyphRun> runs_;     // a film shows the same few labels in every frame
  PictureCache<Key, text::CoverageMap> coverage_;  // titles stand still
};

}  // namespace poinsot::render
