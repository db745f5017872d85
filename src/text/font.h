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

/// Measures of one glyph, in em at scale 1. Left, right, bottom and top bound its ink.
struct GlyphMetrics {
  double advance = 0;
  double left = 0;
  double right = 0;
  double bottom = 0;
  double top = 0;
  double italicCorrection = 0;  ///< how far a slanted letter leans over its advance
  double topAccent = 0;         ///< x where an accent is attached; without a MATH table the ink's middle
};

/// Constants of the font's MATH table, in em (scales are ratios), with the names of the OpenType specification.
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

/// Embedded font: unhinted outlines through FreeType, kerning and the MATH table through HarfBuzz. All measures
/// are whole numbers of the font's own units, so results have the same bits on every machine.
class Font {
 public:
  /// Returns the font of this thread, made at first use. A font is a constant of the program, so there is no need
  /// to pass it on. Threads must not share one, because FreeType keeps the last glyph in the face.
  static const Font& of(Typeface face);
  /// Returns Latin Modern Math, the only font with a MATH table.
  static const Font& mathematics() { return of(Typeface::kMath); }

  ~Font();
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  std::optional<GlyphId> glyph(char32_t character) const;
  GlyphMetrics metrics(GlyphId id) const;
  /// Returns the constants of the MATH table; all 0 if the font has none.
  const MathConstants& constants() const { return constants_; }

  /// Returns the glyph's form for scripts, which is sturdier at small size. Level 0 is text, 1 a script, 2 a
  /// script of a script.
  GlyphId scriptForm(GlyphId id, int level) const;
  /// Returns the glyph without its dot, to carry an accent (i, j); the glyph itself if it has no such form.
  GlyphId dotlessForm(GlyphId id) const;
  /// Returns the same sign at its heights, smallest first.
  std::vector<GlyphId> tallerForms(GlyphId id) const;

  /// Returns the extra space between two characters by the font's own table, in em; negative brings them closer.
  /// Latin Modern Math has no such table.
  double kerning_em(char32_t left, char32_t right) const;

  /// Returns FreeType's face for outlines, which must be loaded unscaled.
  FT_FaceRec_* face() const;
  double unitsPerEm() const;

 private:
  struct Handles;
  explicit Font(Typeface face);
  GlyphMetrics measured(GlyphId id) const;

  std::unique_ptr<const Handles> handles_;  // hides FreeType and HarfBuzz from users of this header
  MathConstants constants_;
  mutable std::unordered_map<GlyphId, GlyphMetrics> measured_;  ///< cache: HarfBuzz reads an outline each time
  std::vector<unsigned> scriptLookups_, dotlessLookups_;
};

}  // namespace poinsot::text
