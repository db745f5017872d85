// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "text/glyph_run.h"

struct FT_FaceRec_;

namespace poinsot::text {

/// Measures of one glyph in em. `left`, `right`, `bottom` and `top` are the bounds of its ink.
struct GlyphMetrics {
  double advance = 0;
  double left = 0;
  double right = 0;
  double bottom = 0;
  double top = 0;
  double italicCorrection = 0;  ///< distance by which a slanted letter extends beyond its advance
  double topAccent = 0;         ///< x at which an accent is centred; without a MATH table, the middle of the ink
};

/// Constants of the font's MATH table, with the names of the OpenType specification. Lengths are in em, scales are
/// ratios.
struct MathConstants {
  double scriptScale = 0;
  double scriptScriptScale = 0;
  double axisHeight = 0;
  double accentBaseHeight = 0;
  double subscriptShiftDown = 0;
  double subscriptTopMax = 0;
  double subscriptBaselineDropMin = 0;
  double superscriptShiftUp = 0;
  double superscriptShiftUpCramped = 0;
  double superscriptBottomMin = 0;
  double superscriptBaselineDropMax = 0;
  double subSuperscriptGapMin = 0;
  double superscriptBottomMaxWithSubscript = 0;
  double spaceAfterScript = 0;
  struct Fraction {
    double numeratorShiftUp = 0;
    double denominatorShiftDown = 0;
    double numeratorGapMin = 0;
    double denominatorGapMin = 0;
  };
  Fraction fraction, displayFraction;
  double fractionRuleThickness = 0;
  double radicalVerticalGap = 0;
  double radicalRuleThickness = 0;
  double radicalExtraAscender = 0;
  double radicalKernBeforeDegree = 0;
  double radicalKernAfterDegree = 0;
  double radicalDegreeBottomRaise = 0;  ///< fraction of the root sign's total height
};

/// Embedded font. FreeType reads its outlines without hinting; HarfBuzz reads its kerning and MATH table. All
/// measures are whole numbers in the font's units, so results have the same bits on every machine.
class Font {
 public:
  /// Returns a font, which is loaded at its first use on each thread. Threads must not share a font, because
  /// FreeType stores the glyph that was loaded last in its face object.
  static const Font& of(Typeface face);
  /// Returns Latin Modern Math, the only font with a MATH table.
  static const Font& mathematics() { return of(Typeface::kMath); }

  ~Font();
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  std::optional<GlyphId> glyph(char32_t character) const;
  GlyphMetrics metrics(GlyphId id) const;
  /// Returns the constants of the MATH table. All are 0 if the font has no such table.
  const MathConstants& constants() const { return constants_; }

  /// Returns the glyph's form for subscripts and superscripts, which has thicker strokes.
  /// @param level  0 for normal text, 1 for a script, 2 for a script of a script
  GlyphId scriptForm(GlyphId id, int level) const;
  /// Returns the form of an i or j without its dot, for use under an accent. Otherwise returns the glyph itself.
  GlyphId dotlessForm(GlyphId id) const;
  /// Returns the forms of a symbol, such as a root sign, in different heights. The smallest comes first.
  std::vector<GlyphId> tallerForms(GlyphId id) const;

  /// Returns the extra space between two characters in em, from the font's kerning table; negative values bring
  /// them closer. The result is 0 for Latin Modern Math, which has no kerning table.
  double kerning_em(char32_t left, char32_t right) const;

  /// Returns FreeType's face object, for reading outlines. Load glyphs unscaled.
  FT_FaceRec_* face() const;
  double unitsPerEm() const;

 private:
  struct Handles;
  explicit Font(Typeface face);
  GlyphMetrics measured(GlyphId id) const;

  std::unique_ptr<const Handles> handles_;  // pointer, so that this header does not include FreeType and HarfBuzz
  MathConstants constants_;
  /// Measures by glyph; computing them again would be slow.
  mutable std::unordered_map<GlyphId, GlyphMetrics> measured_;
  std::vector<unsigned> scriptLookups_, dotlessLookups_;
};

}  // namespace poinsot::text
