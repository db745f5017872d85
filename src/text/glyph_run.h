// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/abi.h"

/// Typesetting: from a small TeX subset to positioned glyphs of the embedded fonts, and to coverage of pixels.
/// Lengths named _em are in units of the type size, from the left end of the baseline, x right and y up.
namespace poinsot::text {

/// Embedded fonts, all of one design. Latin Modern Math sets formulas, and text as far as it has the letters.
/// Latin Modern Roman 10, regular and bold, has the letters that it lacks.
enum class Typeface : std::uint8_t { kMath, kRoman, kBold };

using GlyphId = std::uint32_t;

/// Glyph at a place in a line. `scale` is 1 for ordinary type and less for scripts.
struct PlacedGlyph {
  GlyphId id = 0;
  double x_em = 0;
  double y_em = 0;
  double scale = 1;
  std::u32string plain;  ///< characters that a reader copies from a figure, without alphabet: "ω", "fi"
  Typeface face = Typeface::kMath;
};

/// Filled rectangle, such as the bar of a fraction or a root; (x, y) is its lower left corner.
struct Rule {
  double x_em = 0;
  double y_em = 0;
  double width_em = 0;
  double height_em = 0;
};

/// One line of set type, as plain values.
struct GlyphRun {
  std::vector<PlacedGlyph> glyphs;
  std::vector<Rule> rules;

  /// Room that the line takes. Ascent and descent (both positive) are at least those of a parenthesis, so that
  /// labels of one size keep their lines apart, independent of their letters.
  double width_em = 0;
  double ascent_em = 0;
  double descent_em = 0;

  /// Smallest rectangle around the ink; all 0 if nothing is drawn.
  double inkLeft_em = 0;
  double inkRight_em = 0;
  double inkTop_em = 0;
  double inkBottom_em = 0;

  /// Text of the line in plain Unicode ("ω", "ê₁"), for alternative text.
  std::string plainText;
};

}  // namespace poinsot::text
