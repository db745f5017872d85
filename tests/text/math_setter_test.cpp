// SPDX-License-Identifier: Apache-2.0
#include "text/math_setter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "text/font_oracle.h"

// Expected values: advances, attachment points and constants that the test reads from the font's file
// (font_oracle.h), code points from the Unicode charts, and spaces from The TeXbook. Positions are sums of whole
// font units over 1000, so that differences are rounding only: measured at most 5e-16 em where the bound is 1e-12.
namespace poinsot::text {
namespace {

constexpr double kExact_em = 1e-12;

class MathSetter : public ::testing::Test {
 protected:
  double advance(char32_t c) const { return font_.advance(font_.glyph(c)); }
  double advances(std::u32string_view text) const {
    double sum = 0;
    for (const char32_t c : text) sum += advance(c);
    return sum;
  }
  void expectGlyphs(const char* tex, std::u32string_view characters) const {
    const GlyphRun run = setTex(tex);
    ASSERT_EQ(run.glyphs.size(), characters.size()) << tex;
    for (std::size_t i = 0; i < characters.size(); ++i)
      EXPECT_EQ(run.glyphs[i].id, font_.glyph(characters[i])) << tex << " glyph " << i;
  }

  testing::FontOracle font_;
};

TEST_F(MathSetter, TextIsAsWideAsItsAdvances) {
  EXPECT_NEAR(setTex("Irish mist").width_em, advances(U"Irish mist"), kExact_em);
  EXPECT_NEAR(setTex("12 rad/s").width_em, advances(U"12 rad/s"), kExact_em);
  EXPECT_NEAR(setTex("office flips").width_em, advances(U"o\uFB03ce \uFB02ips"), kExact_em);
  EXPECT_EQ(setTex("").width_em, 0);
}

TEST_F(MathSetter, TextIsKerned) {
  EXPECT_NEAR(setTex("Te").width_em, advances(U"Te") - 1.0 / 12, kExact_em);
  EXPECT_NEAR(setTex("AVA").width_em, advances(U"AVA") - 2.0 / 9, kExact_em);
  EXPECT_NEAR(setTex("\\textbf{Te}").width_em, advances(U"𝐓𝐞") - 1.0 / 12, kExact_em);
  const GlyphRun run = setTex("Te");
  EXPECT_NEAR(run.glyphs[1].x_em, advance(U'T') - 1.0 / 12, kExact_em);
}

TEST_F(MathSetter, LettersUseUnicodesMathematicalAlphabets) {
  expectGlyphs("$Lxh2$", U"𝐿𝑥ℎ2");
  expectGlyphs("$\\mathbf{Lx2}$", U"𝐋𝐱𝟐");
  expectGlyphs("$\\boldsymbol{Lx2}$", U"𝑳𝒙𝟐");
  expectGlyphs("$\\mathrm{dh}$", U"dh");
  expectGlyphs("$\\alpha\\omega\\phi\\varphi\\theta\\psi\\lambda\\epsilon$", U"𝛼𝜔𝜙𝜑𝜃𝜓𝜆𝜖");
  expectGlyphs("$\\Omega\\Gamma\\mathrm{\\omega}$", U"ΩΓω");
  expectGlyphs("$\\boldsymbol{\\omega\\Omega\\phi}$", U"𝝎𝛀𝝓");
  expectGlyphs("$\\mathbf{\\omega\\Omega}$", U"𝛚𝛀");
  expectGlyphs("$ω\\boldsymbolω$", U"𝜔𝝎");
  expectGlyphs("Lx2\\textbf{Lx2}", U"Lx2𝐋𝐱𝟐");
  EXPECT_NE(setTex("$\\mathbf{L}$").glyphs[0].id, setTex("$L$").glyphs[0].id);
  EXPECT_NE(setTex("$L$").glyphs[0].id, setTex("L").glyphs[0].id);
}

TEST_F(MathSetter, TextHasTypographicQuotesDashesAndLigatures) {
  expectGlyphs("Poinsot's", U"Poinsot’s");
  expectGlyphs("1--2---3", U"1–2—3");
  expectGlyphs("``a''", U"“a”");
  expectGlyphs("a \t b", U"a b");
  expectGlyphs("\\$5 \\% \\{\\}\\degree C", U"$5 % {}°C");
  expectGlyphs("fl{f}i", U"\uFB02fi");
}

TEST_F(MathSetter, OperatorsAreSpacedAsInTheTeXbook) {
  const double a = setTex("$a$").width_em, b = setTex("$b$").width_em;
  for (const auto& [tex, sign] : {std::pair{"$a+b$", U'+'}, {"$a-b$", U'−'}, {"$a\\times b$", U'×'}})
    EXPECT_NEAR(setTex(tex).width_em, a + b + advance(sign) + 8.0 / 18, kExact_em) << tex;
  for (const auto& [tex, sign] : {std::pair{"$a=b$", U'='}, {"$a\\le b$", U'≤'}, {"$a\\to b$", U'→'}})
    EXPECT_NEAR(setTex(tex).width_em, a + b + advance(sign) + 10.0 / 18, kExact_em) << tex;
  EXPECT_NEAR(setTex("$a,b$").width_em, a + b + advance(U',') + 3.0 / 18, kExact_em);
  EXPECT_NEAR(setTex("$ab$").width_em, a + b, kExact_em);
  EXPECT_NEAR(setTex("$a\\,b\\;a\\quad b$").width_em, 2 * a + 2 * b + 8.0 / 18 + 1, kExact_em);
}

TEST_F(MathSetter, AMinusSignHasNoSpaceAfterIt) {
  expectGlyphs("$-1$", U"−1");
  EXPECT_NEAR(setTex("$-1$").width_em, advances(U"−1"), kExact_em);
  EXPECT_NEAR(setTex("$(-1)$").width_em, advances(U"(−1)"), kExact_em);
  EXPECT_NEAR(setTex("$1=-1$").width_em, advances(U"1=−1") + 10.0 / 18, kExact_em);
  EXPECT_NEAR(setTex("$10^{1-1}$").width_em - setTex("$10^{1}$").width_em,
              setTex("$x^{1-1}$").width_em - setTex("$x^{1}$").width_em, kExact_em);
}

TEST_F(MathSetter, SlantedLettersGetTheirItalicCorrection) {
  const unsigned T = font_.glyph(U'𝑇');
  EXPECT_GT(font_.italicCorrection(T), 0.1);
  EXPECT_NEAR(setTex("$T$").width_em, font_.advance(T) + font_.italicCorrection(T), kExact_em);
  const GlyphRun scripts = setTex("$T_1^2$");  // base, subscript, superscript
  EXPECT_NEAR(scripts.glyphs[1].x_em, font_.advance(T), kExact_em);
  EXPECT_NEAR(scripts.glyphs[2].x_em, font_.advance(T) + font_.italicCorrection(T), kExact_em);
}

TEST_F(MathSetter, AccentsAreAtTheAttachmentPointsOfTheFont) {
  const std::pair<const char*, char32_t> kAccents[] = {{"hat", U'\u0302'},  {"dot", U'\u0307'},
                                                       {"ddot", U'\u0308'}, {"bar", U'\u0304'},
                                                       {"vec", U'\u20D7'},  {"tilde", U'\u0303'}};
  const std::pair<const char*, char32_t> kBases[] = {
      {"\\mathbf{e}", U'𝐞'}, {"\\mathbf{L}", U'𝐋'}, {"\\boldsymbol{\\omega}", U'𝝎'}, {"x", U'𝑥'}, {"T", U'𝑇'}};
  for (const auto& [name, mark] : kAccents)
    for (const auto& [tex, character] : kBases) {
      const GlyphRun run = setTex(std::string("$\\") + name + "{" + tex + "}$");
      ASSERT_EQ(run.glyphs.size(), 2u);
      const unsigned base = font_.glyph(character);
      EXPECT_EQ(run.glyphs[0].id, base);
      EXPECT_EQ(run.glyphs[1].id, font_.glyph(mark));
      EXPECT_NEAR(run.glyphs[1].x_em + font_.topAccent(font_.glyph(mark)), font_.topAccent(base), kExact_em)
          << tex;
      const double gap = run.glyphs[1].y_em + font_.ink(font_.glyph(mark)).bottom - font_.ink(base).top;
      EXPECT_GT(gap, 0.05) << name << tex;  // measured 0.071 (vec) to 0.167 (bar)
      EXPECT_LT(gap, 0.20) << name << tex;
    }
}

// These letters are symmetric by themselves, so that the eye measures from ink to ink.
TEST_F(MathSetter, AccentsLookCentred) {
  for (const char* tex :
       {"$\\hat{\\mathbf{T}}$", "$\\dot{\\mathbf{o}}$", "$\\bar{\\mathbf{I}}$", "$\\ddot{\\mathbf{e}}$"}) {
    const GlyphRun run = setTex(tex);
    const auto centre = [&](const PlacedGlyph& g) {
      const testing::Ink ink = font_.ink(g.id);
      return g.x_em + g.scale * (ink.left + ink.right) / 2;
    };
    EXPECT_NEAR(centre(run.glyphs[0]), centre(run.glyphs[1]), 0.02) << tex;  // measured at most 0.0155, over the e
  }
}

TEST_F(MathSetter, AnAccentedILosesItsDot) {
  EXPECT_EQ(setTex("$\\hat{i}$").glyphs[0].id, font_.glyph(U'𝚤'));
  EXPECT_EQ(setTex("$\\vec{j}$").glyphs[0].id, font_.glyph(U'𝚥'));
  EXPECT_EQ(setTex("$i$").glyphs[0].id, font_.glyph(U'𝑖'));
}

TEST_F(MathSetter, ScriptsHaveTheSizesAndShiftsOfTheFont) {
  const double script = 10 * font_.constant(HB_OT_MATH_CONSTANT_SCRIPT_PERCENT_SCALE_DOWN);  // % / 100, not em
  const double scriptScript = 10 * font_.constant(HB_OT_MATH_CONSTANT_SCRIPT_SCRIPT_PERCENT_SCALE_DOWN);
  EXPECT_NEAR(script, 0.7, 1e-12);
  const GlyphRun sub = setTex("$\\mathbf{e}_1$");
  EXPECT_NEAR(sub.glyphs[1].scale, script, kExact_em);
  EXPECT_NEAR(sub.glyphs[1].y_em, -font_.constant(HB_OT_MATH_CONSTANT_SUBSCRIPT_SHIFT_DOWN), kExact_em);
  EXPECT_NEAR(sub.glyphs[1].x_em, advance(U'𝐞'), kExact_em);
  const GlyphRun sup = setTex("$x^{2}$");
  EXPECT_NEAR(sup.glyphs[1].y_em, font_.constant(HB_OT_MATH_CONSTANT_SUPERSCRIPT_SHIFT_UP), kExact_em);
  EXPECT_NEAR(setTex("$x_{y_z}$").glyphs[2].scale, scriptScript, kExact_em);
  EXPECT_NEAR(setTex("$x_{y_{z_w}}$").glyphs[3].scale, scriptScript, kExact_em);
}

// The font draws small letters sturdier (feature ssty): at the same nominal size the script form is wider.
TEST_F(MathSetter, ScriptsUseTheScriptGlyphsOfTheFont) {
  for (const auto& [tex, character] :
       {std::pair{"$x_e$", U'𝑒'}, {"$x_\\mathbf{e}$", U'𝐞'}, {"$x_1$", U'1'}, {"$x_{\\text{e}}$", U'e'}}) {
    const GlyphId script = setTex(tex).glyphs[1].id;
    EXPECT_NE(script, font_.glyph(character)) << tex;
    EXPECT_GT(font_.advance(script), 1.1 * advance(character)) << tex;  // measured 1.12 to 1.16
    EXPECT_LT(font_.advance(script), 1.2 * advance(character)) << tex;
  }
}

TEST_F(MathSetter, SubscriptAndSuperscriptKeepTheMinimumGap) {
  const double least = font_.constant(HB_OT_MATH_CONSTANT_SUB_SUPERSCRIPT_GAP_MIN);
  for (const char* tex : {"$x_1^2$", "$x_b^y$", "$x_{b^2}^{y_1}$"}) {
    const GlyphRun run = setTex(tex);
    double subTop = -1, supBottom = 9;
    for (const PlacedGlyph& g : run.glyphs) {
      const testing::Ink ink = font_.ink(g.id);
      if (g.y_em < 0) subTop = std::max(subTop, g.y_em + g.scale * ink.top);
      if (g.y_em > 0.2) supBottom = std::min(supBottom, g.y_em + g.scale * ink.bottom);
    }
    EXPECT_GE(supBottom - subTop, least - 1e-9) << tex;
  }
}

TEST_F(MathSetter, AFractionIsCentredOnTheAxis) {
  const GlyphRun run = setTex("$\\frac{a}{bb}$");
  ASSERT_EQ(run.rules.size(), 1u);
  const Rule& bar = run.rules[0];
  EXPECT_NEAR(bar.y_em + bar.height_em / 2, font_.constant(HB_OT_MATH_CONSTANT_AXIS_HEIGHT), kExact_em);
  EXPECT_NEAR(bar.height_em, font_.constant(HB_OT_MATH_CONSTANT_FRACTION_RULE_THICKNESS), kExact_em);
  EXPECT_GT(run.glyphs[0].y_em + run.glyphs[0].scale * font_.ink(run.glyphs[0].id).bottom,
            bar.y_em + bar.height_em);
  EXPECT_LT(run.glyphs[1].y_em + run.glyphs[1].scale * font_.ink(run.glyphs[1].id).top, bar.y_em);
  const double numerator_em = setTex("$\\frac{a}{a}$").rules[0].width_em;
  EXPECT_NEAR(run.glyphs[0].x_em + numerator_em / 2, bar.x_em + bar.width_em / 2, kExact_em);
}

// The parts of \dfrac are as large as the line's type, and as far from the bar as the font requires for displays.
TEST_F(MathSetter, ADisplayedFractionHasPartsOfFullSize) {
  const GlyphRun small = setTex("$\\frac{a}{b}$"), large = setTex("$\\dfrac{a}{b}$");
  EXPECT_EQ(large.glyphs[0].scale, 1);
  EXPECT_LT(small.glyphs[0].scale, 0.8);
  const Rule& bar = large.rules.at(0);
  EXPECT_NEAR(bar.y_em + bar.height_em / 2, font_.constant(HB_OT_MATH_CONSTANT_AXIS_HEIGHT), kExact_em);
  EXPECT_GE(large.glyphs[0].y_em,
            font_.constant(HB_OT_MATH_CONSTANT_FRACTION_NUMERATOR_DISPLAY_STYLE_SHIFT_UP) - kExact_em);
  const double gap = bar.y_em - (large.glyphs[1].y_em + font_.ink(large.glyphs[1].id).top);
  EXPECT_GE(gap, font_.constant(HB_OT_MATH_CONSTANT_FRACTION_DENOM_DISPLAY_STYLE_GAP_MIN) - kExact_em);
  EXPECT_EQ(large.plainText, small.plainText);
}

TEST_F(MathSetter, ARootCoversItsContent) {
  for (const char* tex : {"$\\sqrt{x}$", "$\\sqrt{2T/L}$", "$\\sqrt{\\frac{2T}{I_1}}$"}) {
    const GlyphRun run = setTex(tex);
    const Rule* bar = &run.rules[0];
    const PlacedGlyph& sign = run.glyphs[0];
    const testing::Ink ink = font_.ink(sign.id);
    EXPECT_NEAR(bar->x_em, sign.x_em + sign.scale * ink.right, 1e-3) << tex;
    EXPECT_NEAR(bar->y_em + bar->height_em, sign.y_em + sign.scale * ink.top, 1e-3) << tex;
    EXPECT_NEAR(bar->x_em + bar->width_em, run.width_em, kExact_em) << tex;
    for (const PlacedGlyph& g : run.glyphs) {
      if (&g == &sign) continue;
      EXPECT_LT(g.y_em + g.scale * font_.ink(g.id).top, bar->y_em) << tex;
      EXPECT_GT(g.y_em + g.scale * font_.ink(g.id).bottom, sign.y_em + sign.scale * ink.bottom) << tex;
    }
  }
}

// Expected: OpenType 1.9, MATH table, the three radical degree constants, and MathML Core 3.3.3. The index ends
// RadicalKernAfterDegree (negative) before the sign begins. The index's bottom is at the share
// RadicalDegreeBottomRaisePercent of the sign's height.
TEST_F(MathSetter, TheIndexOfARootIsAtThePositionOfTheFont) {
  const double smallest = 10 * font_.constant(HB_OT_MATH_CONSTANT_SCRIPT_SCRIPT_PERCENT_SCALE_DOWN);
  const double before = font_.constant(HB_OT_MATH_CONSTANT_RADICAL_KERN_BEFORE_DEGREE);
  const double after = font_.constant(HB_OT_MATH_CONSTANT_RADICAL_KERN_AFTER_DEGREE);
  const double raise = 10 * font_.constant(HB_OT_MATH_CONSTANT_RADICAL_DEGREE_BOTTOM_RAISE_PERCENT);
  EXPECT_EQ(raise, 0.6);
  for (const char* content : {"x", "\\frac{2T}{I_1}", "\\sqrt{x}"}) {
    const std::string radicand = std::string("{") + content + "}$";
    const GlyphRun plain = setTex("$\\sqrt" + radicand), run = setTex("$\\sqrt[3]" + radicand);
    ASSERT_EQ(run.glyphs.size(), plain.glyphs.size() + 1) << content;
    const PlacedGlyph &index = run.glyphs[0], &sign = run.glyphs[1];
    EXPECT_EQ(index.scale, smallest);
    EXPECT_NEAR(index.x_em, before, kExact_em);
    const double signX = std::max(0.0, before + smallest * font_.advance(index.id) + after);
    EXPECT_NEAR(sign.x_em, signX, kExact_em) << content;
    EXPECT_NEAR(run.width_em, signX + plain.width_em, kExact_em) << content;
    const testing::Ink ink = font_.ink(sign.id);
    const double bottom = index.y_em + smallest * font_.ink(index.id).bottom;
    // The layer's extents are whole units: measured at most 4e-4 off.
    EXPECT_NEAR(bottom, sign.y_em + ink.bottom + raise * (ink.top - ink.bottom), 2e-3) << content;
  }
  EXPECT_EQ(setTex("$\\sqrt{x}$").glyphs.size(), 2u);
}

TEST_F(MathSetter, ARootsIndexMayBeAnyFormula) {
  for (const char* tex :
       {"$\\sqrt[n]{x}$", "$\\sqrt[n+1]{x}$", "$\\sqrt [3] x$", "$\\sqrt[\\sqrt[3]{2}]{x}$", "$\\sqrt[{[a]}]{x}$",
        "$\\sqrt[3]{\\sqrt[5]{x}}$", "$\\sqrt[\\text{a]}]{x}$", "$x^{\\sqrt[3]{y}}$"})
    EXPECT_GT(setTex(tex).rules.size(), 0u) << tex;
  EXPECT_EQ(setTex("$\\sqrt[3]{x}$").plainText, "∛x");
  EXPECT_EQ(setTex("$\\sqrt[4]{x+1}$").plainText, "∜(x + 1)");
  EXPECT_EQ(setTex("$\\sqrt[12]{x}$").plainText, "¹²√x");
  EXPECT_EQ(setTex("$\\sqrt[n]{x}$").plainText, "[n]√x");
}

// The brackets are rules: an upright and two ends on each side. The middle of the matrix is on the axis of the
// line.
TEST_F(MathSetter, AMatrixIsInBracketsCentredOnTheAxis) {
  const GlyphRun run = setTex("$\\begin{bmatrix} 1 & 0 \\\\ 0 & 12 \\end{bmatrix}$");
  ASSERT_EQ(run.glyphs.size(), 5u);
  ASSERT_EQ(run.rules.size(), 6u);
  const Rule &left = run.rules[0], &right = run.rules[3];
  EXPECT_NEAR(left.y_em + left.height_em / 2, font_.constant(HB_OT_MATH_CONSTANT_AXIS_HEIGHT), kExact_em);
  EXPECT_NEAR(right.y_em, left.y_em, kExact_em);
  EXPECT_NEAR(left.x_em, run.width_em - right.x_em - right.width_em, kExact_em);
  for (const PlacedGlyph& g : run.glyphs) {
    const testing::Ink ink = font_.ink(g.id);
    EXPECT_GT(g.x_em + ink.left, left.x_em + left.width_em);
    EXPECT_LT(g.x_em + ink.right, right.x_em);
    EXPECT_GT(g.y_em + ink.bottom, left.y_em);
    EXPECT_LT(g.y_em + ink.top, left.y_em + left.height_em);
  }
}

TEST_F(MathSetter, TheColumnsOfAMatrixAreFlushRight) {
  const GlyphRun run = setTex("$\\begin{bmatrix} 1 & 0 \\\\ 0 & 12 \\end{bmatrix}$");
  const auto right = [&](std::size_t i) { return run.glyphs.at(i).x_em + font_.advance(run.glyphs.at(i).id); };
  EXPECT_NEAR(right(0), right(2), kExact_em);  // 1 above 0
  EXPECT_NEAR(right(1), right(4), kExact_em);  // 0 above 12
  EXPECT_EQ(run.glyphs[0].y_em, run.glyphs[1].y_em);
  EXPECT_GT(run.glyphs[0].y_em, run.glyphs[2].y_em);
}

TEST_F(MathSetter, AMatrixMayHaveAnyFormulaAsElement) {
  EXPECT_EQ(setTex("$\\begin{bmatrix} I_1 & 0 \\\\ -x & \\sqrt{y} \\end{bmatrix}$").plainText, "[I₁ 0; −x √y]");
  EXPECT_EQ(setTex("$\\begin{bmatrix} 1 \\\\ 2 \\\\ \\end{bmatrix}$").plainText,
            "[1; 2]");  // LaTeX accepts this too
  EXPECT_EQ(setTex("$\\begin{bmatrix}1&\\begin{bmatrix}a\\end{bmatrix}\\end{bmatrix}$").plainText, "[1 [a]]");
}

// The layer's extents are HarfBuzz's, in whole font units; the expected extents come from the curves.
TEST_F(MathSetter, InkBoundsAreThoseOfTheOutlines) {
  for (const char* tex : {"Poinsot", "$\\hat{\\mathbf{e}}_1$", "$2T/L$", " y ", "$\\frac{x}{y}$"}) {
    const GlyphRun run = setTex(tex);
    testing::Ink all{9, -9, 9, -9};
    for (const PlacedGlyph& g : run.glyphs) {
      const testing::Ink ink = font_.ink(g.id);
      if (ink.left > ink.right) continue;  // a blank
      all = {std::min(all.left, g.x_em + g.scale * ink.left), std::max(all.right, g.x_em + g.scale * ink.right),
             std::min(all.bottom, g.y_em + g.scale * ink.bottom), std::max(all.top, g.y_em + g.scale * ink.top)};
    }
    for (const Rule& r : run.rules)
      all = {std::min(all.left, r.x_em), std::max(all.right, r.x_em + r.width_em), all.bottom, all.top};
    EXPECT_NEAR(run.inkLeft_em, all.left, 1.1e-3) << tex;
    EXPECT_NEAR(run.inkRight_em, all.right, 1.1e-3) << tex;
    EXPECT_NEAR(run.inkBottom_em, all.bottom, 1.1e-3) << tex;
    EXPECT_NEAR(run.inkTop_em, all.top, 1.1e-3) << tex;
    EXPECT_GE(run.ascent_em, run.inkTop_em) << tex;
    EXPECT_GE(run.descent_em, -run.inkBottom_em) << tex;
  }
  EXPECT_EQ(setTex(" ").inkRight_em, 0);
  EXPECT_EQ(setTex("x").ascent_em, setTex("L").ascent_em);
}

TEST_F(MathSetter, ConvertsFormulasToPlainText) {
  EXPECT_EQ(setTex("Poinsot's construction").plainText, "Poinsot’s construction");
  EXPECT_EQ(setTex("$\\boldsymbol{\\omega}$").plainText, "ω");
  EXPECT_EQ(setTex("$\\hat{\\mathbf{e}}_1$").plainText, "e\u0302₁");
  EXPECT_EQ(setTex("$h=2T/L$").plainText, "h = 2T/L");
  EXPECT_EQ(setTex("$\\frac{2T}{|\\mathbf{L}|}$").plainText, "2T/|L|");
  EXPECT_EQ(setTex("$\\sqrt{x^2-y_n}$").plainText, "√(x² − y_n)");
  EXPECT_EQ(setTex("$30^\\circ$, $x_{ab}$").plainText, "30°, x_(ab)");
}

}  // namespace
}  // namespace poinsot::text
