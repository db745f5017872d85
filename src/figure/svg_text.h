// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "text/glyph_run.h"

namespace poinsot::figure {

/// Returns a number with at most three decimals, for SVG.
std::string number(double v);

/// Pieces of a typeset line for an SVG with text: characters that a viewer sets in Latin Modern, and glyphs that
/// no character gives, such as root signs and the accents of formulas.
struct SvgLine {
  std::string tspans;                   ///< content of a <text> at (0, 0), one <tspan> for each font and baseline
  std::vector<text::PlacedGlyph> rest;  ///< glyphs to draw as outlines
};

/// Returns the attribute of a <text> with the font of upright letters, in which elements without a font are set.
std::string_view svgTextFont();

/// Converts a typeset line to SVG text. Each character is where the line has its glyph, if the viewer has the
/// fonts Latin Modern Roman and Latin Modern Math. Characters follow each other, so that the line closes up when
/// it is edited.
/// @param size_px  size of the text
SvgLine svgLine(const text::GlyphRun& line, double size_px);

}  // namespace poinsot::figure
