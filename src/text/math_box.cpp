// SPDX-License-Identifier: Apache-2.0
#include "text/math_box.h"

#include <algorithm>
#include <utility>

#include "core/expect.h"
#include "text/canonical.h"
#include "text/kerning.h"
#include "text/letter_glyph.h"

namespace poinsot::text {
namespace {

struct Ligature {
  std::u32string_view letters;
  char32_t character;
};

// Ligatures, longest first. The font has glyphs for them, but no OpenType feature that selects the glyphs.
constexpr Ligature kLigatures[] = {
    {U"ffi", U'\uFB03'}, {U"ffl", U'\uFB04'}, {U"ff", U'\uFB00'}, {U"fi", U'\uFB01'}, {U"fl", U'\uFB02'}};

// Reports whether `text` begins with the letters of a ligature. A mark on the last letter prevents the ligature.
bool begins(std::u32string_view text, const Ligature& ligature) {
  const std::size_t length = ligature.letters.size();
  return text.starts_with(ligature.letters) && (text.size() == length || !isMark(text[length]));
}

std::u32string withLigatures(std::u32string_view text) {
  std::u32string result;
  while (!text.empty()) {
    const auto* found = std::ranges::find_if(kLigatures, [&](const Ligature& l) { return begins(text, l); });
    const bool joined = found != std::end(kLigatures);
    result += joined ? found->character : text.front();
    text.remove_prefix(joined ? found->letters.size() : 1);
  }
  return result;
}

// Returns the letters that a ligature stands for, or the character itself.
std::u32string typedAs(char32_t character) {
  const auto* found = std::ranges::find(kLigatures, character, &Ligature::character);
  return found == std::end(kLigatures) ? std::u32string(1, character) : std::u32string(found->letters);
}

std::size_t afterMarks(std::u32string_view letters, std::size_t at) {
  do ++at;
  while (at < letters.size() && isMark(letters[at]));
  return at;
}

void growTo(Box& box, double top, double bottom) {
  box.height = std::max(box.height, top);
  box.depth = std::max(box.depth, -bottom);
}

void addGlyph(Box& box, const PlacedGlyph& glyph) {
  const GlyphMetrics ink = Font::of(glyph.face).metrics(glyph.id);
  box.glyphs.push_back(glyph);
  growTo(box, glyph.y_em + glyph.scale * ink.top, glyph.y_em + glyph.scale * ink.bottom);
}

}  // namespace

double scaleOf(int level) {
  const MathConstants& constants = Font::mathematics().constants();
  return level == 0 ? 1 : level == 1 ? constants.scriptScale : constants.scriptScriptScale;
}

Box glyphBox(char32_t character, const MathStyle& style) {
  const std::optional<FontGlyph> nominal = glyphOf(character, style.alphabet);
  POINSOT_EXPECT(nominal.has_value());
  const Font& font = Font::of(nominal->face);
  const GlyphId id = font.scriptForm(nominal->id, style.level);
  const GlyphMetrics metrics = font.metrics(id);
  const double scale = scaleOf(style.level);

  Box box;
  addGlyph(box, {id, 0, 0, scale, {character}, nominal->face});
  // Upright letters also have an italic correction, for accents and scripts. In words it would add unwanted space.
  box.italic = leans(character, style.alphabet) ? scale * metrics.italicCorrection : 0;
  box.width = scale * metrics.advance + box.italic;
  box.accentX = scale * metrics.topAccent;
  box.character = true;
  box.plain = character;
  return box;
}

namespace {

// Returns a letter without its dot if the box is an i or j. Returns any other box unchanged.
Box withoutDot(Box base) {
  if (!base.character || base.glyphs.size() != 1 || base.glyphs.front().face != Typeface::kMath) return base;
  const Font& font = Font::mathematics();
  PlacedGlyph& glyph = base.glyphs.front();
  const GlyphId dotless = font.dotlessForm(glyph.id);
  if (dotless == glyph.id) return base;
  glyph.id = dotless;
  const GlyphMetrics metrics = font.metrics(dotless);
  base.height = glyph.scale * metrics.top;
  base.accentX = glyph.scale * metrics.topAccent;
  base.width = glyph.scale * metrics.advance + base.italic;
  return base;
}

// Returns the distance by which a mark is moved up. Unmoved, it fits a letter of the font's accent height.
double riseOf(MarkPlace place, const Box& base, int level) {
  const double drawnFor = scaleOf(level) * Font::mathematics().constants().accentBaseHeight;
  switch (place) {
    case MarkPlace::kAbove:
      return std::max(0.0, base.height - drawnFor);
    case MarkPlace::kBelow:
      return -base.depth;
    case MarkPlace::kThrough:
      break;
  }
  return 0;
}

}  // namespace

Box accented(const Box& base, char32_t mark, const MathStyle& style) {
  const MarkPlace where = placeOf(mark);
  Box box = where == MarkPlace::kAbove ? withoutDot(base) : base;
  const Box drawn = glyphBox(mark, style);
  place(box, drawn, box.accentX - drawn.accentX, riseOf(where, box, style.level));
  box.plain += mark;
  return box;
}

Box textBox(std::u32string_view text, bool bold, int level) {
  const MathStyle style{level, false, textAlphabet(bold)};
  // Bold letters are mathematical characters, which have no ligatures.
  const std::u32string letters = bold ? std::u32string(text) : withLigatures(text);
  Box box;
  for (std::size_t i = 0, before = 0; i < letters.size(); before = std::exchange(i, afterMarks(letters, i))) {
    if (i > 0) box.width += scaleOf(level) * kerning_em(letters[before], letters[i], bold);
    Box letter = glyphBox(letters[i], style);
    letter.glyphs.front().plain = typedAs(letters[i]);
    letter.accentX = letter.width / 2;  // centres accents, as in the font's own accented letters
    for (std::size_t mark = i + 1; mark < afterMarks(letters, i); ++mark)
      letter = accented(letter, letters[mark], style);
    place(box, letter, box.width, 0);
    box.width += letter.width;
  }
  box.accentX = box.width / 2;
  box.plain = composed(text, [](char32_t) { return true; });
  return box;
}

Box spaceBox(double width_em, int level) {
  Box box;
  box.width = scaleOf(level) * width_em;
  if (width_em > 0) box.plain += U' ';
  return box;
}

void place(Box& box, const Box& part, double x, double y) {
  for (const PlacedGlyph& g : part.glyphs)
    box.glyphs.push_back({g.id, x + g.x_em, y + g.y_em, g.scale, g.plain, g.face});
  for (const Rule& r : part.rules) box.rules.push_back({x + r.x_em, y + r.y_em, r.width_em, r.height_em});
  growTo(box, y + part.height, y - part.depth);
}

void append(Box& line, const Box& part) {
  place(line, part, line.width, 0);
  line.width += part.width;
  line.plain += part.plain;
}

}  // namespace poinsot::text
