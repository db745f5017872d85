// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/abi.h"

/// Type: from a small TeX subset to positioned glyphs of the embedded fonts, and to coverage of pixels.
/// Lengths named _em are in units of the type size, from the left end of the baseline, x right and y up.
namespace poinsot::text {

/// The embedded fonts, all of one design. Latin Modern Math sets formulas and what it has of text; the two others,
/// Latin Modern Roman 10 in its regular and its bold weight, have the letters that it lacks.
enum class Typeface : std::uint8_t { kMath, kRoman, kBold };

/// Index of a glyph in its font.
using GlyphId = std::uint32_t;

/// One glyph; `scale` is 1 for ordinary type and less for scripts.
struct PlacedGlyph {
  GlyphId id = 0;
  double x_em = 0;
  double y_em = 0;
  double scale = 1;
  std::u32string plain;  ///< what it stands for, without alphabet: "ω", "fi"; what a reader copies from a figure
  Typeface face = Typeface::kMath;
};

/// A filled rectangle (bar of a fraction or of a root); (x, y) is its lower left corner.
struct Rule {
  double x_em = 0;
  double y_em = 0;
  double width_em = 0;
  double height_em = 0;
};

/// One line of set type, as values.
struct GlyphRun {
  std::vector<PlacedGlyph> glyphs;
  std::vector<Rule> rules;

  /// Room the line takes. Ascent and descent (both positive) are those of a parenthesis unless the ink goes
  /// further, so that labels of one size keep their lines apart whatever letters they hold.
  double width_em = 0;
  double ascent_em = 0;
  double descent_em = 0;

  /// The smallest rectangle around the ink; all 0 where nothing is drawn.
  double inkLeft_em = 0;
  double inkRight_em = 0;
  double inkTop_em = 0;
  double inkBottom_em = 0;

  /// The same in plain Unicode ("ω", "ê₁"), for alternative text.
  std::string plainText;
};

}  // namespace poinsot::text
