// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "draw/draw_list.h"
#include "image/image.h"
#include "text/glyph_run.h"

namespace poinsot::render {

/// Lays type over a finished picture, on the CPU: glyph coverage is exact area, blending is in linear light.
class TextPainter {
 public:
  /// @throws core::Error(kUsage) for TeX that cannot be set.
  void paint(const draw::Text& text, image::Image& picture);

 private:
  const text::GlyphRun& run(const std::string& tex);

  std::map<std::string, text::GlyphRun> runs_;  // a film shows the same few labels in every frame
};

}  // namespace poinsot::render
