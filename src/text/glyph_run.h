// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/abi.h"

/// Typesetting: converts a small TeX subset to positioned glyphs of the embedded fonts, and glyphs to coverage of
/// pixels. Lengths that end in _em are in units of the text size. They are measured from the left end of the
/// baseline, x to the right and y up.
namespace poinsot::text {

/// Embedded fonts, all of the same design. Latin Modern Math is used for formulas, and for text if it has the
/// letters. Latin Modern Roman 10 (regular and bold) has the other letters.
enum class Typeface : std::uint8_t { kMath, kRoman, kBold };

using GlyphId = std::uint32_t;

/// Glyph at a position in a line. `scale` is 1 for normal text and smaller for scripts.
struct PlacedGlyph {
  GlyphId id = 0;
  double x_em = 0;
  double y_em = 0;
  double scale = 1;
  std::u32string plain;  ///< text for copying from a figure, without the alphabet: "ω", "fi"
  Typeface face = Typeface::kMath;
};

/// Filled rectangle, such as the bar of a fraction or a root. (x, y) is its lower left corner.
struct Rule {
  double x_em = 0;
  double y_em = 0;
  double width_em = 0;
  double height_em = 0;
};

/// One line of typeset text as plain values.
struct GlyphRun {
  std::vector<PlacedGlyph> glyphs;
  std::vector<Rule> rules;

  /// Size of the line, for layout. Ascent and descent are positive and at least those of a parenthesis. Labels of
  /// the same size therefore have the same line height, unless one contains something taller.
  double width_em = 0;
  double ascent_em = 0;
  double descent_em = 0;

  /// Smallest rectangle around the ink. All 0 if nothing is drawn.
  double inkLeft_em = 0;
  double inkRight_em = 0;
  double inkTop_em = 0;
  double inkBottom_em = 0;

  /// Text of the line in plain Unicode, such as "ω" or "ê₁", for alternative text.
  std::string plainText;
};

}  // namespace poinsot::text
