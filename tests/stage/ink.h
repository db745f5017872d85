// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "draw/draw_list.h"
#include "stage/type/pixel_box.h"
#include "text/math_setter.h"

namespace poinsot::stage {

/// Returns the bounds of a text's ink, in the picture or panel that holds the text.
inline PixelBox inkOf(const draw::Text& text) {
  const text::GlyphRun run = text::setTex(text.tex);
  const double size = static_cast<double>(text.size_px);
  const glm::dvec2 at(text.baseline_px);
  return {at.x + size * run.inkLeft_em, at.y - size * run.inkTop_em, at.x + size * run.inkRight_em,
          at.y - size * run.inkBottom_em};
}

/// Returns the bounds of the ink of a panel's text, in the picture.
inline PixelBox inkOf(const draw::Text& text, glm::ivec2 panel_px) {
  const PixelBox ink = inkOf(text);
  const glm::dvec2 by(panel_px);
  return {ink.left + by.x, ink.top + by.y, ink.right + by.x, ink.bottom + by.y};
}

}  // namespace poinsot::stage
