// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "text/font.h"
#include "text/math_alphabet.h"

namespace poinsot::text {

struct FontGlyph {
  Typeface face = Typeface::kMath;
  GlyphId id = 0;
};

/// Returns the glyph of a character in an alphabet, bold if the alphabet is bold and a bold font has the
/// character. Returns nullopt if no font has the character.
std::optional<FontGlyph> glyphOf(char32_t character, Alphabet alphabet);

/// Splits a letter with its marks into characters that have glyphs. The letter comes first. Canonically equal
/// letters give the same result. Characters without a glyph remain if the split cannot avoid them.
std::u32string splitIntoGlyphs(std::u32string_view letter, Alphabet alphabet);

}  // namespace poinsot::text
