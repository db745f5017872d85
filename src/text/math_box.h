// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "text/font.h"
#include "text/glyph_run.h"
#include "text/math_alphabet.h"

namespace poinsot::text {

/// Style of a part of a formula. `level` is 0 for text, 1 for a script, and 2 for a script of a script. `cramped`
/// means that superscripts are raised less, as under a bar or a root.
struct MathStyle {
  int level = 0;
  bool cramped = false;
  Alphabet alphabet = Alphabet::kMathItalic;
};

/// Returns the text size of a level, as a fraction of the line's size.
double scaleOf(int level);

/// Typeset piece of a formula or text. Its origin is the left end of its baseline. All lengths are in em of the
/// line. Height and depth are the extent of the ink above and below the baseline, at least 0.
struct Box {
  std::vector<PlacedGlyph> glyphs;
  std::vector<Rule> rules;
  double width = 0;
  double height = 0;
  double depth = 0;
  double italic = 0;  ///< part of the width that only the top of a slanted letter needs; a subscript may use it
  double accentX = 0;
  /// Whether the box is a single letter, perhaps accented. Its scripts then have the font's usual heights.
  bool character = false;
  std::u32string plain;
};

/// Sets one character in the style's alphabet. A font must have the character.
Box glyphBox(char32_t character, const MathStyle& style);

/// Draws `mark`, a combining character, above, below or through `base`. An i or j under a mark has no dot.
Box accented(const Box& base, char32_t mark, const MathStyle& style);

/// Typesets running text with kerning and with ligatures such as "fi".
/// @param text  letters that were split by splitIntoGlyphs()
Box textBox(std::u32string_view text, bool bold, int level);

Box spaceBox(double width_em, int level);

/// Adds `part` to `box`, with its origin at (x, y). Height and depth of `box` may grow; its width does not.
void place(Box& box, const Box& part, double x, double y);

/// Appends `part` and its plain text to the end of the line.
void append(Box& line, const Box& part);

}  // namespace poinsot::text
