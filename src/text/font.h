// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "text/glyph_run.h"

struct FT_FaceRec_;

namespace poinsot::text {

/// Measures of one glyph, in em at scale 1; left to top bound its ink.
struct GlyphMetrics {
  double advance = 0;
  double left = 0;
  double right = 0;
  double bottom = 0;
  double top = 0;
  double italicCorrection = 0;  ///< how far a slanted letter leans over its advance
  double topAccent = 0;         ///< x of the point where an accent is attached
};

/// What the font's MATH table says, in em (scales are ratios). Names are those of the OpenType specification.
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
};

/// A glyph of shaped text at its place on the line, in em; `index` is the character it came from.
struct ShapedGlyph {
  GlyphId id = 0;
  double x_em = 0;
  double y_em = 0;
  double advance_em = 0;
  std::size_t index = 0;
};

/// Latin Modern Math, embedded in the program: unhinted outlines through FreeType, shaping and the MATH table
/// through HarfBuzz. Everything is measured in the font's own whole units, so results have the same bits on every
/// machine.
class Font {
 public:
  /// The font. One per thread, made at its first use: it is a constant of the program, so nothing is gained by
  /// passing it about, but FreeType keeps the last glyph in the face, so threads must not share one.
  static const Font& mathematics();

  ~Font();
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  std::optional<GlyphId> glyph(char32_t character) const;
  GlyphMetrics metrics(GlyphId id) const;
  const MathConstants& constants() const { return constants_; }

  /// The glyph's form for scripts (sturdier at small size); level 1 is script, 2 script of a script.
  GlyphId scriptForm(GlyphId id, int level) const;
  /// The glyph without its dot, to carry an accent (i, j); itself where there is no such form.
  GlyphId dotlessForm(GlyphId id) const;
  /// The same sign at its heights, smallest first.
  std::vector<GlyphId> tallerForms(GlyphId id) const;

  /// Glyphs of a line of text, left to right, in their forms for that script level. The font has no kerning of its
  /// own, so none is here (kerning.h).
  std::vector<ShapedGlyph> shape(std::u32string_view text, int level) const;

  /// FreeType's face, for outlines, to be loaded unscaled.
  FT_FaceRec_* face() const;
  double unitsPerEm() const;

 private:
  struct Handles;
  Font();

  std::unique_ptr<const Handles> handles_;  // hides FreeType and HarfBuzz from whoever includes this header
  MathConstants constants_;
  std::vector<unsigned> scriptLookups_, dotlessLookups_;  // of the table of substitutions
};

}  // namespace poinsot::text
