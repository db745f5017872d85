// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ft2build.h>
#include FT_FREETYPE_H
#include <hb-ot.h>
#include <hb.h>

namespace poinsot::text::testing {

struct Ink {
  double left = 0;
  double right = 0;
  double bottom = 0;
  double top = 0;
};

/// Font of Latin Modern, read from its file with FreeType and HarfBuzz directly; reference for the text layer.
/// Lengths are in em.
class FontOracle {
 public:
  explicit FontOracle(const char* file = POINSOT_MATH_FONT);
  ~FontOracle();
  FontOracle(const FontOracle&) = delete;
  FontOracle& operator=(const FontOracle&) = delete;

  /// Returns the glyph of a character; 0 if the font has none.
  unsigned glyph(char32_t character) const { return FT_Get_Char_Index(face_, character); }
  double advance(unsigned glyph) const;
  double italicCorrection(unsigned glyph) const;
  double topAccent(unsigned glyph) const;
  double constant(hb_ot_math_constant_t which) const;

  /// Returns the bounds of a glyph's ink, from curves cut into 64 chords each.
  Ink ink(unsigned glyph) const;
  /// Returns the filled area in em², by the shoelace formula; holes do not count.
  double area(unsigned glyph) const;

 private:
  FT_Library library_ = nullptr;
  FT_Face face_ = nullptr;
  hb_font_t* font_ = nullptr;
};

}  // namespace poinsot::text::testing
