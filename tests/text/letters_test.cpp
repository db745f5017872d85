// SPDX-License-Identifier: Apache-2.0
// Accented letters: which of them are accepted, that they look the same in any spelling, and their weight.
// Expected values come from canonical decompositions of Python's unicodedata (canonical_decompositions.inc), and
// from character maps, outlines and areas of the three font files, which the test reads itself (font_oracle.h).
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "core/error.h"
#include "text/coverage.h"
#include "text/font_oracle.h"
#include "text/math_setter.h"
#include "text/plain_text.h"

namespace poinsot::text {
namespace {

struct Parts {
  char32_t whole;
  char32_t first;
  char32_t second;  // 0 if there is one part
};
constexpr Parts kParts[] = {
#include "canonical_decompositions.inc"
};

struct Block {
  const char* name;
  char32_t first;
  char32_t last;
};
constexpr Block kBlocks[] = {{"Latin-1 Supplement", 0xA1, 0xFF},
                             {"Latin Extended-A", 0x100, 0x17F},
                             {"Greek", 0x370, 0x3FF},
                             {"Latin Extended Additional", 0x1E00, 0x1EFF}};

const Parts* partsOf(char32_t c) {
  const auto* found = std::ranges::find(kParts, c, &Parts::whole);
  return found == std::end(kParts) ? nullptr : found;
}

std::string utf8(char32_t c) { return toUtf8({&c, 1}); }

/// Returns the full decomposition, as a Mac's keyboard or a file's name has it. In these blocks, only letters with
/// a dot or a line below need their marks sorted, and the table lists these marks first.
std::string decomposedByTable(char32_t c) {
  const Parts* parts = partsOf(c);
  if (parts == nullptr) return utf8(c);
  return decomposedByTable(parts->first) + (parts->second == 0 ? "" : utf8(parts->second));
}

bool sets(const std::string& tex) {
  try {
    setTex(tex);
    return true;
  } catch (const core::Error& error) {
    EXPECT_EQ(error.kind(), core::ErrorKind::kUsage) << tex;
    return false;
  }
}

class Letters : public ::testing::Test {
 protected:
  bool hasGlyph(char32_t c) const {
    return c != 0xAD && (math_.glyph(c) != 0 || roman_.glyph(c) != 0);  // a soft hyphen is not drawn
  }

  /// Returns whether a character has a glyph of its own, or parts that are all accepted.
  bool isAccepted(char32_t c) const {
    if (hasGlyph(c)) return true;
    const Parts* parts = partsOf(c);
    return parts != nullptr && isAccepted(parts->first) && (parts->second == 0 || isAccepted(parts->second));
  }

  std::vector<char32_t> accepted() const {
    std::vector<char32_t> all;
    for (const Block& block : kBlocks)
      for (char32_t c = block.first; c <= block.last; ++c)
        if (isAccepted(c)) all.push_back(c);
    return all;
  }

  const testing::FontOracle& fontOf(const PlacedGlyph& g) const {
    return g.face == Typeface::kMath ? math_ : g.face == Typeface::kBold ? bold_ : roman_;
  }
  testing::Ink inkOf(const PlacedGlyph& g) const { return fontOf(g).ink(g.id); }
  double inkArea(const std::string& tex) const {
    double area = 0;
    for (const PlacedGlyph& g : setTex(tex).glyphs) area += fontOf(g).area(g.id);
    return area;
  }

  testing::FontOracle math_;
  testing::FontOracle roman_{POINSOT_ROMAN_FONT};
  testing::FontOracle bold_{POINSOT_BOLD_FONT};
};

void expectSame(const GlyphRun& a, const GlyphRun& b, const std::string& what) {
  ASSERT_EQ(a.glyphs.size(), b.glyphs.size()) << what;
  for (std::size_t i = 0; i < a.glyphs.size(); ++i) {
    const PlacedGlyph &p = a.glyphs[i], &q = b.glyphs[i];
    EXPECT_TRUE(p.id == q.id && p.face == q.face && p.x_em == q.x_em && p.y_em == q.y_em && p.plain == q.plain)
        << what << " glyph " << i;
  }
  EXPECT_EQ(a.width_em, b.width_em) << what;
  EXPECT_EQ(a.plainText, b.plainText) << what;
  EXPECT_EQ(rasterize(a, 40, 3.3, 30.7, 2).values, rasterize(b, 40, 3.3, 30.7, 2).values) << what;
}

TEST_F(Letters, AreAcceptedExactlyIfTheFontsHaveTheirParts) {
  for (const Block& block : kBlocks) {
    int count = 0;
    for (char32_t c = block.first; c <= block.last; ++c) {
      count += isAccepted(c);
      EXPECT_EQ(sets(utf8(c)), isAccepted(c)) << utf8(c) << " U+" << std::hex << static_cast<unsigned>(c);
      EXPECT_EQ(sets("\\textbf{" + utf8(c) + "}"), isAccepted(c)) << utf8(c);
      EXPECT_EQ(sets("$" + utf8(c) + "$"), isAccepted(c)) << utf8(c);
      EXPECT_EQ(sets(decomposedByTable(c)), isAccepted(c)) << utf8(c);
    }
    printf("%s: %d accepted\n", block.name, count);
  }
  for (const char* few : {"ẋ", "ẍ", "ŵ", "ĥ", "ή", "ế", "ǐ"}) EXPECT_TRUE(sets(few)) << few;
}

// Letters beyond a to z of the languages that docs/figures.md names, from the exemplar characters of Unicode's
// CLDR.
TEST_F(Letters, CoverTheLanguagesInTheDocumentation) {
  const std::pair<const char*, const char*> kLanguages[] = {{"Catalan", "àçéèíïŀóòúü·"},
                                                            {"Croatian", "čćđšžČĆĐŠŽ"},
                                                            {"Czech", "áčďéěíňóřšťúůýžŘŮ"},
                                                            {"Danish", "åæøÅÆØ"},
                                                            {"Dutch", "áäéëíïóöúüĳ"},
                                                            {"Esperanto", "ĉĝĥĵŝŭĈĜĤĴŜŬ"},
                                                            {"Estonian", "äõöšüž"},
                                                            {"Finnish", "äåö"},
                                                            {"French", "àâæçéèêëîïôœùûüÿÉÇŒ«»"},
                                                            {"German", "äöüßÄÖÜ„“"},
                                                            {"Greek", "άέήίόύώΐΰϊϋςΆΈΉΊΌΎΏ"},
                                                            {"Hungarian", "áéíóöőúüűŐŰ"},
                                                            {"Icelandic", "áæðéíóöúýþÐÞ"},
                                                            {"Irish", "áéíóúḃċḋḟġṁṗṡṫ"},
                                                            {"Italian", "àéèìóòù"},
                                                            {"Latvian", "āčēģīķļņšūžĢĶ"},
                                                            {"Lithuanian", "ąčęėįšųūž"},
                                                            {"Maltese", "ċġħżĊĠĦŻ"},
                                                            {"Norwegian", "åæøéò"},
                                                            {"Polish", "ąćęłńóśźżŁŹ"},
                                                            {"Portuguese", "áâãàçéêíóôõú"},
                                                            {"Romanian", "ăâîșțȘȚ"},
                                                            {"Slovak", "áäčďéíĺľňóôŕšťúýž"},
                                                            {"Slovenian", "čšž"},
                                                            {"Spanish", "áéíñóúü¿¡"},
                                                            {"Swedish", "åäö"},
                                                            {"Turkish", "çğıöşüİĞŞ"},
                                                            {"Vietnamese", "ăâđêôơưạảấầẩẫậỹ"},
                                                            {"Welsh", "âêîôûŵŷẁẃẅŴŶ"},
                                                            {"pinyin", "āáǎàēéěèīíǐìǖǘǚǜ"},
                                                            {"signs", "«»“”„–—…§†•°€£²³½"}};
  for (const auto& [language, letters] : kLanguages) {
    EXPECT_TRUE(sets(letters)) << language;
    EXPECT_TRUE(sets("\\textbf{" + std::string(letters) + "}")) << language;
  }
  for (const char* lacking : {"ẞ", "Ə", "ŧ", "Ж", "א", "ع", "अ", "ก", "中", "あ", "한", "😀"})
    EXPECT_FALSE(sets(lacking)) << lacking;
}

TEST_F(Letters, LookTheSameComposedAndDecomposed) {
  for (const char32_t c : accepted()) {
    const std::string nfc = utf8(c), nfd = decomposedByTable(c);
    for (const auto& [before, after] : {std::pair{"", ""}, {"T", "e"}, {"\\textbf{f", "i}"}, {"$", "_1$"}}) {
      SCOPED_TRACE(nfc);
      expectSame(setTex(before + nfc + after), setTex(before + nfd + after), before + nfc + after);
    }
  }
}

TEST_F(Letters, LookTheSameInAnyOrderOfMarks) {
  expectSame(setTex("s\u0323\u0307"), setTex("s\u0307\u0323"), "dots below and above");
  expectSame(setTex("ệ"), setTex("e\u0302\u0323"), "dot below and circumflex");
}

// A letter has more ink with its marks than without, and bold has more ink than regular.
TEST_F(Letters, StayBoldUnderAccents) {
  int count = 0;
  for (const char32_t c : accepted()) {
    const std::string base = decomposedByTable(c).substr(0, 1);
    if (partsOf(c) == nullptr || !std::isalpha(static_cast<unsigned char>(base.front()))) continue;
    ++count;
    const double area = inkArea("\\textbf{" + utf8(c) + "}");
    const bool dotted = base == "i" || base == "j";  // the dot makes way for the marks
    const double plain = inkArea("\\textbf{" + (dotted ? base == "i" ? "ı" : "ȷ" : base) + "}");
    EXPECT_GT(area, plain) << utf8(c);
    EXPECT_GT(area, 1.1 * inkArea(utf8(c))) << utf8(c);
  }
  EXPECT_GT(count, 300);
}

TEST_F(Letters, UseTheGlyphsOfTheBoldFont) {
  for (const char32_t c : std::u32string_view(U"üéñößřÜÉÑŘçąđħŵ")) {
    const GlyphRun run = setTex("\\textbf{" + utf8(c) + "}");
    ASSERT_EQ(run.glyphs.size(), 1u) << utf8(c);
    EXPECT_EQ(run.glyphs[0].face, Typeface::kBold) << utf8(c);
    EXPECT_EQ(run.glyphs[0].id, bold_.glyph(c)) << utf8(c);
    EXPECT_NEAR(run.width_em, bold_.advance(bold_.glyph(c)), 1e-12) << utf8(c);
  }
}

TEST_F(Letters, HaveBoldPunctuationInBoldText) {
  for (const char32_t c : std::u32string_view(U".,:;!?()[]-–—’“”\"/%=+²½·§")) {
    const GlyphRun run = setTex("\\textbf{" + (c == U'%' ? "\\%" : utf8(c)) + "}");
    ASSERT_EQ(run.glyphs.size(), 1u) << utf8(c);
    EXPECT_EQ(run.glyphs[0].face, Typeface::kBold) << utf8(c);
    EXPECT_EQ(run.glyphs[0].id, bold_.glyph(c)) << utf8(c);
  }
  EXPECT_EQ(setTex("$\\mathbf{1.5}$").glyphs[1].face, Typeface::kMath);  // as in TeX
}

// Pictures of plain titles do not depend on the fonts for text.
TEST_F(Letters, UseTheMathematicsFontIfUnaccented) {
  const std::string plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz 0123456789";
  for (const std::string& tex : {plain, "\\textbf{" + plain + "}"})
    for (const PlacedGlyph& g : setTex(tex).glyphs) EXPECT_EQ(g.face, Typeface::kMath);
}

// Marks on letters for which no font has one glyph, measured from ink to ink: gaps 0.044 to 0.139 em, off the
// middle by at most 0.064 em.
TEST_F(Letters, HaveAccentsCentredAboveOrBelow) {
  int above = 0, below = 0;
  for (const char32_t c : accepted())
    for (const std::string& tex : {utf8(c), "\\textbf{" + utf8(c) + "}"}) {
      const GlyphRun run = setTex(tex);
      for (std::size_t i = 1; i < run.glyphs.size(); ++i) {
        const PlacedGlyph &letter = run.glyphs[i - 1], &mark = run.glyphs[i];
        const double gap = mark.y_em + inkOf(mark).bottom - letter.y_em - inkOf(letter).top;
        const double drop = letter.y_em + inkOf(letter).bottom - mark.y_em - inkOf(mark).top;
        EXPECT_TRUE(gap > 0.03 || drop > 0.03) << tex << ' ' << gap << ' ' << drop;
        EXPECT_LT(std::max(gap, drop), 0.16) << tex;
        const auto middle = [&](const PlacedGlyph& g) { return g.x_em + (inkOf(g).left + inkOf(g).right) / 2; };
        EXPECT_NEAR(middle(mark), middle(letter), 0.08) << tex;
        ++(gap > drop ? above : below);
      }
    }
  EXPECT_GT(above, 50);
  printf("marks set by the program: %d above, %d below\n", above, below);
}

TEST_F(Letters, LoseTheirDotUnderAMark) {
  EXPECT_EQ(setTex("i\u0304\u0301").glyphs[0].id, setTex("ī").glyphs[0].id);
  EXPECT_EQ(setTex("$í$").glyphs[0].id, math_.glyph(U'𝚤'));
  EXPECT_EQ(setTex("$i\u0301$").glyphs[0].id, math_.glyph(U'𝚤'));
  EXPECT_EQ(setTex("i\u0307\u0301").glyphs[0].id, math_.glyph(U'ı'));  // Lithuanian: the dot is a mark itself
}

// Expected by hand from the kern tables of the two fonts, in thousandths of an em.
TEST_F(Letters, AreKernedByTheFontsTables) {
  const auto kerning = [&](const std::string& a, const std::string& b, const char* style) {
    const auto width = [&](const std::string& t) { return setTex(style + ("{" + t + "}")).width_em; };
    return 1000 * (width(a + b) - width(a) - width(b));
  };
  EXPECT_NEAR(kerning("T", "é", "\\text"), -56, 1e-9);
  EXPECT_NEAR(kerning("T", "ö", "\\text"), -21, 1e-9);
  EXPECT_NEAR(kerning("Á", "V", "\\text"), -111, 1e-9);
  EXPECT_NEAR(kerning("T", "é", "\\textbf"), -64, 1e-9);
  EXPECT_NEAR(kerning("Á", "V", "\\textbf"), -128, 1e-9);
  EXPECT_NEAR(kerning("Ä", "r", "\\textbf"), 0, 1e-9);
}

TEST_F(Letters, HaveTheSameAccentsInFormulasAsCommands) {
  for (const auto& [typed, command] : {std::pair{"$ẋ$", "$\\dot{x}$"},
                                       {"$é$", "$\\hat{e}$"},
                                       {"$θ\u0308$", "$\\ddot{θ}$"},
                                       {"$\\theta\u0307_1$", "$\\dot\\theta_1$"},
                                       {"${ab}\u0304$", "$\\bar{ab}$"}}) {
    const GlyphRun a = setTex(typed), b = setTex(command);
    ASSERT_EQ(a.glyphs.size(), b.glyphs.size()) << typed;
    EXPECT_EQ(a.glyphs[0].id, b.glyphs[0].id) << typed;
    EXPECT_EQ(a.width_em, b.width_em) << typed;
  }
  expectSame(setTex("$a≠b$"), setTex("$a=\u0338b$"), "a relation with a stroke");
}

TEST_F(Letters, AreNotJoinedIntoLigaturesUnderAMark) {
  EXPECT_EQ(setTex("fi\u0331").glyphs.size(), 3u);
  EXPECT_EQ(setTex("fi").glyphs.size(), 1u);
}

TEST_F(Letters, AreNamedWithTheirColumnIfRefused) {
  for (const auto& [tex, says] : {std::pair{"ab ḩ", "column 4 of \"ab ḩ\": the font has no glyph for ḩ (U+1E29)"},
                                  {"e\u0327x", "column 2 of"},
                                  {"$q\u0328$", "column 3 of"}}) {
    try {
      setTex(tex);
      ADD_FAILURE() << tex;
    } catch (const core::Error& error) {
      EXPECT_TRUE(error.message().starts_with(says)) << error.message();
    }
  }
}

}  // namespace
}  // namespace poinsot::text
