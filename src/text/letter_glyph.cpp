// SPDX-License-Identifier: Apache-2.0
#include "text/letter_glyph.h"

#include <hb.h>

#include <algorithm>

#include "text/canonical.h"

namespace poinsot::text {
namespace {

bool isLetter(char32_t character) {
  switch (hb_unicode_general_category(hb_unicode_funcs_get_default(), character)) {
    case HB_UNICODE_GENERAL_CATEGORY_LOWERCASE_LETTER:
    case HB_UNICODE_GENERAL_CATEGORY_UPPERCASE_LETTER:
    case HB_UNICODE_GENERAL_CATEGORY_OTHER_LETTER:
    case HB_UNICODE_GENERAL_CATEGORY_MODIFIER_LETTER:
      return true;
    default:
      return false;
  }
}

// Spaces come from the regular font in bold text too, so that bold words do not change the word space.
bool isSpace(char32_t character) { return character == U' ' || character == U'\u00A0'; }

// Returns the font to try first. In bold formulas only letters and marks are bold, as in TeX.
Typeface preferredFont(char32_t character, Alphabet alphabet) {
  switch (alphabet) {
    case Alphabet::kText:
      return isMark(character) ? Typeface::kRoman : Typeface::kMath;
    case Alphabet::kBoldText:
      return isSpace(character) ? Typeface::kMath : Typeface::kBold;
    case Alphabet::kBold:
    case Alphabet::kBoldItalic:
      return isLetter(character) || isMark(character) ? Typeface::kBold : Typeface::kMath;
    default:
      return Typeface::kMath;
  }
}

std::optional<FontGlyph> glyphIn(Typeface face, char32_t character) {
  const std::optional<GlyphId> id = Font::of(face).glyph(character);
  if (!id) return std::nullopt;
  return FontGlyph{face, *id};
}

bool haveGlyphs(std::u32string_view characters, Alphabet alphabet) {
  return std::ranges::all_of(characters, [&](char32_t c) { return glyphOf(c, alphabet).has_value(); });
}

}  // namespace

std::optional<FontGlyph> glyphOf(char32_t character, Alphabet alphabet) {
  constexpr char32_t kSoftHyphen = U'\u00AD';  // a soft hyphen is visible only where a line is broken
  if (character == kSoftHyphen) return std::nullopt;
  const char32_t shaped = inAlphabet(character, alphabet);
  if (shaped != character) return glyphIn(Typeface::kMath, shaped);
  for (const Typeface face : {preferredFont(character, alphabet), Typeface::kMath, Typeface::kRoman})
    if (const auto glyph = glyphIn(face, character)) return glyph;
  return std::nullopt;
}

std::u32string splitIntoGlyphs(std::u32string_view letter, Alphabet alphabet) {
  // The slanted alphabet has no accented letters. Letters are split, and accents placed as in a formula.
  const std::u32string parts = decomposed(letter);
  if (leans(parts.front(), alphabet) && haveGlyphs(parts, alphabet)) return parts;
  const std::u32string joined = composed(letter, [&](char32_t c) { return glyphOf(c, alphabet).has_value(); });
  // The angle brackets U+2329 and U+232A stay: they are canonically equal to Chinese ones that the fonts lack.
  return haveGlyphs(letter, alphabet) && !haveGlyphs(joined, alphabet) ? std::u32string(letter) : joined;
}

}  // namespace poinsot::text
