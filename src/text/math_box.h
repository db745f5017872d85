// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "text/font.h"
#include "text/glyph_run.h"
#include "text/math_alphabet.h"

namespace poinsot::text {

/// Style of a part of a formula: its size level (0 text, 1 script, 2 script of a script), whether superscripts are
/// kept low (under a bar or a root), and the alphabet of letters.
struct MathStyle {
  int level = 0;
  bool cramped = false;
  Alphabet alphabet = Alphabet::kMathItalic;
};

/// Returns the type size of a level, relative to the line's.
double scaleOf(int level);

/// Piece of set type with its origin at the left end of its baseline. All lengths are in em of the line's size.
/// Height and depth are the ink above and below the baseline, at least 0.
struct Box {
  std::vector<PlacedGlyph> glyphs;
  std::vector<Rule> rules;
  double width = 0;
  double height = 0;
  double depth = 0;
  double italic = 0;  ///< part of the width that only the leaning top needs; a subscript moves under it
  double accentX = 0;
  bool character = false;  ///< single letter, accented or not: scripts sit at the font's usual heights
  std::u32string plain;
};

/// Sets one character in the style's alphabet. A font must have the character.
Box glyphBox(char32_t character, const MathStyle& style);

/// Draws `mark` (a combining character, in the style's alphabet) over, under or through `base`. An i or j under a
/// mark loses its dot.
Box accented(const Box& base, char32_t mark, const MathStyle& style);

/// Sets running text, kerned and with the ligatures of f. Letters must be split into glyphs already
/// (splitIntoGlyphs()).
Box textBox(std::u32string_view text, bool bold, int level);

Box spaceBox(double width_em, int level);

/// Draws `part` with its origin at (x, y) of `box`. Height and depth of `box` grow as needed; its width stays.
void place(Box& box, const Box& part, double x, double y);

/// Appends `part` to the line, including its plain text.
void append(Box& line, const Box& part);

}  // namespace poinsot::text
