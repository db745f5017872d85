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

/// Returns the glyph of a letter or a sign in an alphabet, in the alphabet's weight if a font has it; nullopt if
/// no font has the character.
std::optional<FontGlyph> glyphOf(char32_t character, Alphabet alphabet);

/// Splits a letter with its marks into characters that each have a glyph, the letter first. Canonically equal
/// letters give the same result. Characters without a glyph remain if no split avoids them.
std::u32string splitIntoGlyphs(std::u32string_view letter, Alphabet alphabet);

}  // namespace poinsot::text
