// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "text/font.h"
#include "text/glyph_run.h"
#include "text/math_alphabet.h"

namespace poinsot::text {

/// How a part of a formula is set: its size level (0 text, 1 script, 2 script of a script), whether superscripts
/// are kept low (under a bar or a root), and the alphabet of letters.
struct MathStyle {
  int level = 0;
  bool cramped = false;
  Alphabet alphabet = Alphabet::kMathItalic;
};

/// Type size of a level, relative to the line's.
double scaleOf(int level);

/// A piece of set type with its origin at the left end of its baseline; all lengths in em of the line's size.
struct Box {
  std::vector<PlacedGlyph> glyphs;
  std::vector<Rule> rules;
  double width = 0;
  double height = 0;  ///< ink above the baseline, at least 0
  double depth = 0;   ///< ink below the baseline, at least 0
  double italic = 0;  ///< the part of the width that only the leaning top needs; a subscript tucks in under it
  double accentX = 0;
  bool character = false;  ///< one letter, accented or not: its scripts sit at the font's usual heights
  std::u32string plain;
};

/// One character in the style's alphabet. A font must have it.
Box glyphBox(char32_t character, const MathStyle& style);

/// Draws `mark` (a combining character, in the style's alphabet) over, under or through `base`; an i or j under it
/// loses its dot.
Box accented(const Box& base, char32_t mark, const MathStyle& style);

/// Running text, kerned and with the ligatures of f. Letters are split into glyphs already (splitIntoGlyphs()).
Box textBox(std::u32string_view text, bool bold, int level);

Box spaceBox(double width_em, int level);

/// Draws `part` with its origin at (x, y) of `box`, whose height and depth grow as needed; its width stays.
void place(Box& box, const Box& part, double x, double y);

/// Sets `part` after what is there, plain text included.
void append(Box& line, const Box& part);

}  // namespace poinsot::text
