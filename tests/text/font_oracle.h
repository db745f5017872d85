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

/// A font of Latin Modern read from its file with FreeType and HarfBuzz directly: what the text layer is checked
/// against. Lengths in em.
class FontOracle {
 public:
  explicit FontOracle(const char* file = POINSOT_MATH_FONT);
  ~FontOracle();
  FontOracle(const FontOracle&) = delete;
  FontOracle& operator=(const FontOracle&) = delete;

  /// 0 where the font has none.
  unsigned glyph(char32_t character) const { return FT_Get_Char_Index(face_, character); }
  double advance(unsigned glyph) const;
  double italicCorrection(unsigned glyph) const;
  double topAccent(unsigned glyph) const;
  double constant(hb_ot_math_constant_t which) const;

  /// From the curves, each cut into 64 chords.
  Ink ink(unsigned glyph) const;
  /// In em², positive: filled area by the shoelace formula, holes taken off.
  double area(unsigned glyph) const;

 private:
  FT_Library library_ = nullptr;
  FT_Face face_ = nullptr;
  hb_font_t* font_ = nullptr;
};

}  // namespace poinsot::text::testing
