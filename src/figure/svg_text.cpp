// SPDX-License-Identifier: Apache-2.0
#include "figure/svg_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "core/text.h"
#include "text/font.h"
#include "text/math_alphabet.h"
#include "text/math_box.h"
#include "text/plain_text.h"

namespace poinsot::figure {
namespace {

using text::Font;
using text::Typeface;

/// Largest distance of a character from the place of its glyph, em. It is less than half a pixel in a figure of
/// 600 pixels per inch with letters of 10 pt.
constexpr double kNear_em = 0.004;

/// Zero-width non-joiner. Bold lines have no ligatures, although the bold font has some.
constexpr std::string_view kNoLigature = "\u200C";

/// Fonts as a viewer knows them. The roman fonts for scripts are designs of their own, not only smaller.
enum class SvgFont { kRoman, kRoman7, kRoman5, kBold, kMath };

std::string_view attributesOf(SvgFont font) {
  switch (font) {
    case SvgFont::kRoman:
      return "font-family=\"'LM Roman 10', Latin Modern Roman, Latin Modern Math, serif\"";
    case SvgFont::kRoman7:
      return "font-family=\"'LM Roman 7', Latin Modern Roman, Latin Modern Math, serif\"";
    case SvgFont::kRoman5:
      return "font-family=\"'LM Roman 5', Latin Modern Roman, Latin Modern Math, serif\"";
    case SvgFont::kBold:
      return "font-family=\"'LM Roman 10', Latin Modern Roman, serif\" font-weight=\"bold\"";
    case SvgFont::kMath:
      return "font-family=\"Latin Modern Math, Latin Modern Roman, serif\"";
  }
  return "";
}

/// Text that stands for a glyph, as a viewer sets it.
struct Letter {
  std::u32string text;
  SvgFont font = SvgFont::kRoman;
  double x_em = 0, y_em = 0, scale = 1;
  double advance_em = 0;  ///< width in the viewer's font
};

/// Returns the level at which a glyph is the form of a character: 0 for text, 1 and 2 for scripts. Returns nullopt
/// if it is another form, such as an i without a dot or a large root sign.
std::optional<int> levelOf(const text::PlacedGlyph& glyph, char32_t character) {
  const Font& font = Font::of(glyph.face);
  const auto nominal = font.glyph(character);
  if (!nominal) return std::nullopt;
  for (const int level : {0, 1, 2})
    if (font.scriptForm(*nominal, level) == glyph.id) return level;
  return std::nullopt;
}

/// Returns the character of a mathematical font, such as an italic letter, of which a glyph is a form.
std::optional<char32_t> mathCharacter(const text::PlacedGlyph& glyph) {
  using enum text::Alphabet;
  for (const text::Alphabet alphabet : {kMathItalic, kBold, kBoldItalic}) {
    const char32_t shaped = text::inAlphabet(glyph.plain.front(), alphabet);
    if (shaped != glyph.plain.front() && levelOf(glyph, shaped)) return shaped;
  }
  return std::nullopt;
}

std::optional<text::GlyphMetrics> metricsOf(Typeface face, char32_t character) {
  const Font& font = Font::of(face);
  const auto glyph = font.glyph(character);
  return glyph ? std::optional(font.metrics(*glyph)) : std::nullopt;
}

double advance(Typeface face, char32_t character) {
  const auto metrics = metricsOf(face, character);
  return metrics ? metrics->advance : 0;
}

/// Returns whether a text font has the glyph of a character of Latin Modern Math, for most letters and signs.
bool isAlike(Typeface face, char32_t character, char32_t inMath) {
  constexpr double kRounding_em = 6e-3;
  const auto a = metricsOf(face, character), b = metricsOf(Typeface::kMath, inMath);
  if (!a || !b) return false;
  const double gaps[] = {a->advance - b->advance, a->left - b->left, a->right - b->right, a->bottom - b->bottom,
                         a->top - b->top};
  return std::ranges::all_of(gaps, [](double gap) { return std::abs(gap) < kRounding_em; });
}

bool isAccent(char32_t c) { return c >= U'\u0300' && c <= U'\u036F'; }

/// Returns an upright character in the font of its level.
Letter upright(const text::PlacedGlyph& glyph, char32_t character, int level) {
  Letter letter{{character}, SvgFont::kMath, glyph.x_em, glyph.y_em, glyph.scale, 0};
  if (glyph.face == Typeface::kBold) {
    letter.font = SvgFont::kBold;
  } else if (glyph.face == Typeface::kRoman || isAlike(Typeface::kRoman, character, character)) {
    letter.font = level == 0 ? SvgFont::kRoman : level == 1 ? SvgFont::kRoman7 : SvgFont::kRoman5;
  }
  letter.advance_em = glyph.scale * Font::of(glyph.face).metrics(glyph.id).advance;
  if (letter.font == SvgFont::kRoman) letter.advance_em = glyph.scale * advance(Typeface::kRoman, character);
  if (letter.font == SvgFont::kMath) letter.advance_em = glyph.scale * advance(Typeface::kMath, character);
  return letter;
}

/// Returns a letter of a mathematical alphabet. A script has a wider form of the letter, which viewers do not
/// choose, so that the usual form is centred in its place.
Letter mathematical(const text::PlacedGlyph& glyph, char32_t shaped) {
  const char32_t plain = glyph.plain.front();
  const bool bold =
      text::inAlphabet(plain, text::Alphabet::kBold) == shaped && isAlike(Typeface::kBold, plain, shaped);
  const Font& font = Font::mathematics();
  const text::GlyphMetrics usual = font.metrics(font.glyph(shaped).value()), own = font.metrics(glyph.id);
  const double shift_em = (own.left + own.right - usual.left - usual.right) / 2;
  return {{bold ? plain : shaped},
          bold ? SvgFont::kBold : SvgFont::kMath,
          glyph.x_em + glyph.scale * shift_em,
          glyph.y_em,
          glyph.scale,
          glyph.scale * usual.advance};
}

/// Returns the character of a ligature. Only some viewers make ligatures of letters.
std::optional<char32_t> ligatureOf(const text::PlacedGlyph& glyph) {
  for (const char32_t c : U"\uFB00\uFB01\uFB02\uFB03\uFB04")
    if (c != 0 && Font::of(glyph.face).glyph(c) == glyph.id) return c;
  return std::nullopt;
}

/// Returns the text of a glyph; nullopt if only its outline shows it.
std::optional<Letter> letterOf(const text::PlacedGlyph& glyph) {
  if (glyph.plain.empty() || isAccent(glyph.plain.front())) return std::nullopt;
  if (glyph.plain.size() > 1) {
    const auto ligature = ligatureOf(glyph);
    return ligature ? std::optional(upright(glyph, *ligature, 0)) : std::nullopt;
  }
  if (const auto level = levelOf(glyph, glyph.plain.front())) return upright(glyph, glyph.plain.front(), *level);
  if (const auto shaped = mathCharacter(glyph)) return mathematical(glyph, *shaped);
  return std::nullopt;
}

/// Returns the space that a viewer puts between two letters of one font.
double kerning_em(const Letter& left, const Letter& right) {
  if (left.font == SvgFont::kMath) return 0;
  const Typeface face = left.font == SvgFont::kBold ? Typeface::kBold : Typeface::kRoman;
  return left.scale * Font::of(face).kerning_em(left.text.back(), right.text.front());
}

/// Writer of letters as <tspan> elements. A new element begins where the font, the size or the baseline changes,
/// or where the viewer would put a letter in another place.
class TspanWriter {
 public:
  explicit TspanWriter(double size_px) : size_px_(size_px) {}

  void add(const Letter& letter) {
    const bool first = !last_;
    const bool alike =
        !first && last_->font == letter.font && last_->scale == letter.scale && last_->y_em == letter.y_em;
    if (first || !alike || !follows(letter))
      begin(letter);
    else if (letter.font == SvgFont::kBold && last_->text.back() == U'f')
      spans_ += kNoLigature;
    spans_ += core::xmlAttribute(text::toUtf8(letter.text));
    pen_em_ = end_em(letter);
    last_ = letter;
  }

  std::string finish() {
    if (last_) spans_ += "</tspan>";
    return std::move(spans_);
  }

 private:
  static double end_em(const Letter& letter) { return letter.x_em + letter.advance_em; }

  /// Adds a space if one fits into the gap before a letter. Returns whether the letter then is in its place.
  bool follows(const Letter& letter) {
    if (std::abs(pen_em_ + kerning_em(*last_, letter) - letter.x_em) < kNear_em) return true;
    const double space_em =
        letter.scale * advance(letter.font == SvgFont::kBold ? Typeface::kBold : Typeface::kRoman, U' ');
    if (letter.font == SvgFont::kMath || std::abs(pen_em_ + space_em - letter.x_em) > kNear_em) return false;
    spans_ += ' ';
    return true;
  }

  void begin(const Letter& letter) {
    if (last_) spans_ += "</tspan>";
    const double dx_em = letter.x_em - pen_em_, dy_em = (last_ ? last_->y_em : 0) - letter.y_em;
    spans_ += "<tspan";
    if (std::abs(dx_em) > 1e-6) spans_ += fmt::format(" dx=\"{}\"", number(dx_em * size_px_));
    if (std::abs(dy_em) > 1e-6) spans_ += fmt::format(" dy=\"{}\"", number(dy_em * size_px_));
    if (letter.scale != 1) spans_ += fmt::format(" font-size=\"{}\"", number(letter.scale * size_px_));
    if (letter.font != SvgFont::kRoman) spans_ += fmt::format(" {}", attributesOf(letter.font));
    spans_ += '>';
  }

  double size_px_;
  std::string spans_;
  double pen_em_ = 0;
  std::optional<Letter> last_;
};

}  // namespace

std::string_view svgTextFont() { return attributesOf(SvgFont::kRoman); }

std::string number(double v) {
  std::string text = fmt::format("{:.3f}", v);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

SvgLine svgLine(const text::GlyphRun& line, double size_px) {
  SvgLine made;
  TspanWriter writer(size_px);
  for (const text::PlacedGlyph& glyph : line.glyphs) {
    if (const auto letter = letterOf(glyph))
      writer.add(*letter);
    else
      made.rest.push_back(glyph);
  }
  made.tspans = writer.finish();
  return made;
}

}  // namespace poinsot::figure
