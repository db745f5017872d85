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

/// Measures of one glyph, in em at scale 1; left to top bound its ink.
struct GlyphMetrics {
  double advance = 0;
  double left = 0;
  double right = 0;
  double bottom = 0;
  double top = 0;
  double italicCorrection = 0;  ///< how far a slanted letter leans over its advance
  double topAccent = 0;  ///< x of the point where an accent is attached; without a MATH table the ink's middle
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
  double radicalKernBeforeDegree = 0;
  double radicalKernAfterDegree = 0;
  double radicalDegreeBottomRaise = 0;  ///< a share of the root sign's whole height
};

/// An embedded font: unhinted outlines through FreeType, kerning and the MATH table through HarfBuzz. Everything
/// is measured in the font's own whole units, so results have the same bits on every machine.
class Font {
 public:
  /// The font. One per thread, made at its first use: it is a constant of the program, so nothing is gained by
  /// passing it about, but FreeType keeps the last glyph in the face, so threads must not share one.
  static const Font& of(Typeface face);
  /// Latin Modern Math, the only one with a MATH table.
  static const Font& mathematics() { return of(Typeface::kMath); }

  ~Font();
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  std::optional<GlyphId> glyph(char32_t character) const;
  GlyphMetrics metrics(GlyphId id) const;
  /// All 0 where the font has no MATH table.
  const MathConstants& constants() const { return constants_; }

  /// The glyph's form for scripts (sturdier at small size); level 1 is script, 2 script of a script.
  GlyphId scriptForm(GlyphId id, int level) const;
  /// The glyph without its dot, to carry an accent (i, j); itself where there is no such form.
  GlyphId dotlessForm(GlyphId id) const;
  /// The same sign at its heights, smallest first.
  std::vector<GlyphId> tallerForms(GlyphId id) const;

  /// Extra space between two characters by the font's own table, in em (negative: closer). Latin Modern Math has
  /// none.
  double kerning_em(char32_t left, char32_t right) const;

  /// FreeType's face, for outlines, to be loaded unscaled.
  FT_FaceRec_* face() const;
  double unitsPerEm() const;

 private:
  struct Handles;
  explicit Font(Typeface face);
  GlyphMetrics measured(GlyphId id) const;

  std::unique_ptr<const Handles> handles_;  // hides FreeType and HarfBuzz from whoever includes this header
  MathConstants constants_;
  mutable std::unordered_map<GlyphId, GlyphMetrics> measured_;  ///< HarfBuzz reads the outline for each
  std::vector<unsigned> scriptLookups_, dotlessLookups_;        // of the table of substitutions
};

}  // namespace poinsot::text
