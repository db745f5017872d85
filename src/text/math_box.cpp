// SPDX-License-Identifier: Apache-2.0
#include "text/math_box.h"

#include <algorithm>

#include "core/expect.h"
#include "text/kerning.h"

namespace poinsot::text {
namespace {

struct Ligature {
  std::u32string_view letters;
  char32_t character;
};

// Longest first. The font has the glyphs, but no feature that would choose them.
constexpr Ligature kLigatures[] = {
    {U"ffi", U'\uFB03'}, {U"ffl", U'\uFB04'}, {U"ff", U'\uFB00'}, {U"fi", U'\uFB01'}, {U"fl", U'\uFB02'}};

std::u32string withLigatures(std::u32string_view text) {
  std::u32string result;
  while (!text.empty()) {
    const auto* found =
        std::ranges::find_if(kLigatures, [&](const Ligature& l) { return text.starts_with(l.letters); });
    const bool joined = found != std::end(kLigatures);
    result += joined ? found->character : text.front();
    text.remove_prefix(joined ? found->letters.size() : 1);
  }
  return result;
}

// The letters that a character of shaped text was typed as.
std::u32string typedAs(char32_t character) {
  const auto* found = std::ranges::find(kLigatures, character, &Ligature::character);
  return found == std::end(kLigatures) ? std::u32string(1, character) : std::u32string(found->letters);
}

std::u32string inBold(std::u32string_view text) {
  std::u32string bold;
  for (const char32_t c : text) bold += inAlphabet(c, Alphabet::kBold);
  return bold;
}

void growTo(Box& box, double top, double bottom) {
  box.height = std::max(box.height, top);
  box.depth = std::max(box.depth, -bottom);
}

void addGlyph(Box& box, const PlacedGlyph& glyph) {
  const GlyphMetrics ink = Font::mathematics().metrics(glyph.id);
  box.glyphs.push_back(glyph);
  growTo(box, glyph.y_em + glyph.scale * ink.top, glyph.y_em + glyph.scale * ink.bottom);
}

}  // namespace

double scaleOf(int level) {
  const MathConstants& constants = Font::mathematics().constants();
  return level == 0 ? 1 : level == 1 ? constants.scriptScale : constants.scriptScriptScale;
}

Box glyphBox(char32_t character, char32_t plain, const MathStyle& style) {
  const Font& font = Font::mathematics();
  const auto nominal = font.glyph(character);
  POINSOT_EXPECT(nominal.has_value());
  const GlyphId id = font.scriptForm(*nominal, style.level);
  const GlyphMetrics metrics = font.metrics(id);
  const double scale = scaleOf(style.level);

  Box box;
  addGlyph(box, {id, 0, 0, scale, {plain}});
  // Roman letters carry a correction too, which belongs to their use as accented or scripted bases, not to words.
  box.italic = leans(plain, style.alphabet) ? scale * metrics.italicCorrection : 0;
  box.width = scale * metrics.advance + box.italic;
  box.accentX = scale * metrics.topAccent;
  box.character = true;
  box.plain = plain;
  return box;
}

Box textBox(std::u32string_view text, bool bold, int level) {
  const double scale = scaleOf(level);
  // Bold letters are the mathematical ones, which have no ligatures.
  const std::u32string letters = bold ? std::u32string(text) : withLigatures(text);
  Box box;
  double kerned = 0;
  const std::vector<ShapedGlyph> glyphs = Font::mathematics().shape(bold ? inBold(letters) : letters, level);
  for (std::size_t i = 0; i < glyphs.size(); ++i) {
    const ShapedGlyph& g = glyphs[i];
    if (i > 0 && g.index > glyphs[i - 1].index)
      kerned += kerning_em(letters[glyphs[i - 1].index], letters[g.index]);
    addGlyph(box, {g.id, scale * (g.x_em + kerned), scale * g.y_em, scale, typedAs(letters[g.index])});
    box.width += scale * g.advance_em;
  }
  box.width += scale * kerned;
  box.accentX = box.width / 2;
  box.plain = text;
  return box;
}

Box spaceBox(double width_em, int level) {
  Box box;
  box.width = scaleOf(level) * width_em;
  if (width_em > 0) box.plain = U" ";
  return box;
}

void place(Box& box, const Box& part, double x, double y) {
  for (const PlacedGlyph& g : part.glyphs) box.glyphs.push_back({g.id, x + g.x_em, y + g.y_em, g.scale, g.plain});
  for (const Rule& r : part.rules) box.rules.push_back({x + r.x_em, y + r.y_em, r.width_em, r.height_em});
  growTo(box, y + part.height, y - part.depth);
}

void append(Box& line, const Box& part) {
  place(line, part, line.width, 0);
  line.width += part.width;
  line.plain += part.plain;
}

}  // namespace poinsot::text
