// SPDX-License-Identifier: Apache-2.0
#include "text/font.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <fmt/format.h>
#include <hb-ot.h>
#include <hb.h>

#include <algorithm>
#include <new>

#include "core/error.h"
#include "core/expect.h"

extern "C" {
extern const unsigned char poinsot_font_latin_modern_math[], poinsot_font_latin_modern_math_end[];
extern const unsigned char poinsot_font_latin_modern_roman[], poinsot_font_latin_modern_roman_end[];
extern const unsigned char poinsot_font_latin_modern_bold[], poinsot_font_latin_modern_bold_end[];
}

namespace poinsot::text {
namespace {

using BufferPtr = std::unique_ptr<hb_buffer_t, decltype(&hb_buffer_destroy)>;

using SetPtr = std::unique_ptr<hb_set_t, decltype(&hb_set_destroy)>;

struct EmbeddedFile {
  const char* name;
  const unsigned char* begin;
  const unsigned char* end;

  long size() const { return end - begin; }
};

EmbeddedFile fileOf(Typeface face) {
  switch (face) {
    case Typeface::kMath:
      return {"Latin Modern Math", poinsot_font_latin_modern_math, poinsot_font_latin_modern_math_end};
    case Typeface::kRoman:
      return {"Latin Modern Roman 10 Regular", poinsot_font_latin_modern_roman,
              poinsot_font_latin_modern_roman_end};
    case Typeface::kBold:
      break;
  }
  return {"Latin Modern Roman 10 Bold", poinsot_font_latin_modern_bold, poinsot_font_latin_modern_bold_end};
}

// Throws if memory ran out. HarfBuzz would continue with zero measures, missing forms or short texts.
void expectMemory(bool sufficed) {
  if (!sufficed) throw std::bad_alloc();
}

// Returns the substitution lookups of an OpenType feature of the mathematics font. Returns none for a text font.
// Glyphs are typeset one by one, so these lookups are applied directly instead of by shaping.
std::vector<unsigned> lookupsOf(hb_face_t* face, const char* feature) {
  std::vector<unsigned> lookups;
  if (!hb_ot_math_has_data(face)) return lookups;
  const hb_tag_t wanted[] = {hb_tag_from_string(feature, -1), HB_TAG_NONE};
  const SetPtr set(hb_set_create(), &hb_set_destroy);
  hb_ot_layout_collect_lookups(face, HB_OT_TAG_GSUB, nullptr, nullptr, wanted, set.get());
  hb_codepoint_t lookup = HB_SET_VALUE_INVALID;
  while (hb_set_next(set.get(), &lookup)) lookups.push_back(lookup);
  expectMemory(hb_set_allocation_successful(set.get()) && !lookups.empty());
  return lookups;
}

// Returns a buffer with fixed direction, script and language. HarfBuzz would guess them from the locale.
BufferPtr makeBuffer() {
  BufferPtr buffer(hb_buffer_create(), &hb_buffer_destroy);
  hb_buffer_set_direction(buffer.get(), HB_DIRECTION_LTR);
  hb_buffer_set_script(buffer.get(), HB_SCRIPT_LATIN);
  hb_buffer_set_language(buffer.get(), hb_language_from_string("en", -1));
  return buffer;
}

}  // namespace

struct Font::Handles {
  FT_Library library = nullptr;
  FT_Face face = nullptr;
  hb_blob_t* blob = nullptr;
  hb_face_t* shapingFace = nullptr;
  // The scale is the font's own units, so every position is a whole number.
  hb_font_t* shapingFont = nullptr;
  double unitsPerEm = 1;

  explicit Handles(Typeface which) {
    const EmbeddedFile file = fileOf(which);
    if (FT_Init_FreeType(&library) != 0 || FT_New_Memory_Face(library, file.begin, file.size(), 0, &face) != 0) {
      release();
      throw core::graphicsError(fmt::format("FreeType cannot read the embedded font {}", file.name));
    }
    blob = hb_blob_create(reinterpret_cast<const char*>(file.begin), static_cast<unsigned>(file.size()),
                          HB_MEMORY_MODE_READONLY, nullptr, nullptr);
    shapingFace = hb_face_create(blob, 0);
    shapingFont = hb_font_create(shapingFace);
    const bool whole =
        which == Typeface::kMath ? hb_ot_math_has_data(shapingFace) : hb_ot_layout_has_positioning(shapingFace);
    if (!hb_ot_layout_has_substitution(shapingFace) || !whole || shapingFont == hb_font_get_empty()) {
      release();
      throw std::bad_alloc();
    }
    unitsPerEm = hb_face_get_upem(shapingFace);
  }
  ~Handles() { release(); }
  Handles(const Handles&) = delete;
  Handles& operator=(const Handles&) = delete;

  void release() const {
    hb_font_destroy(shapingFont);
    hb_face_destroy(shapingFace);
    hb_blob_destroy(blob);
    FT_Done_Face(face);
    FT_Done_FreeType(library);
  }

  double em(hb_position_t units) const { return units / unitsPerEm; }
};

namespace {

MathConstants readConstants(hb_font_t* font, double unitsPerEm) {
  const auto raw = [&](hb_ot_math_constant_t which) {
    return static_cast<double>(hb_ot_math_get_constant(font, which));
  };
  const auto em = [&](hb_ot_math_constant_t which) { return raw(which) / unitsPerEm; };
  MathConstants c;
  c.scriptScale = raw(HB_OT_MATH_CONSTANT_SCRIPT_PERCENT_SCALE_DOWN) / 100;
  c.scriptScriptScale = raw(HB_OT_MATH_CONSTANT_SCRIPT_SCRIPT_PERCENT_SCALE_DOWN) / 100;
  c.axisHeight = em(HB_OT_MATH_CONSTANT_AXIS_HEIGHT);
  c.accentBaseHeight = em(HB_OT_MATH_CONSTANT_ACCENT_BASE_HEIGHT);
  c.subscriptShiftDown = em(HB_OT_MATH_CONSTANT_SUBSCRIPT_SHIFT_DOWN);
  c.subscriptTopMax = em(HB_OT_MATH_CONSTANT_SUBSCRIPT_TOP_MAX);
  c.subscriptBaselineDropMin = em(HB_OT_MATH_CONSTANT_SUBSCRIPT_BASELINE_DROP_MIN);
  c.superscriptShiftUp = em(HB_OT_MATH_CONSTANT_SUPERSCRIPT_SHIFT_UP);
  c.superscriptShiftUpCramped = em(HB_OT_MATH_CONSTANT_SUPERSCRIPT_SHIFT_UP_CRAMPED);
  c.superscriptBottomMin = em(HB_OT_MATH_CONSTANT_SUPERSCRIPT_BOTTOM_MIN);
  c.superscriptBaselineDropMax = em(HB_OT_MATH_CONSTANT_SUPERSCRIPT_BASELINE_DROP_MAX);
  c.subSuperscriptGapMin = em(HB_OT_MATH_CONSTANT_SUB_SUPERSCRIPT_GAP_MIN);
  c.superscriptBottomMaxWithSubscript = em(HB_OT_MATH_CONSTANT_SUPERSCRIPT_BOTTOM_MAX_WITH_SUBSCRIPT);
  c.spaceAfterScript = em(HB_OT_MATH_CONSTANT_SPACE_AFTER_SCRIPT);
  c.fraction = {
      em(HB_OT_MATH_CONSTANT_FRACTION_NUMERATOR_SHIFT_UP), em(HB_OT_MATH_CONSTANT_FRACTION_DENOMINATOR_SHIFT_DOWN),
      em(HB_OT_MATH_CONSTANT_FRACTION_NUMERATOR_GAP_MIN), em(HB_OT_MATH_CONSTANT_FRACTION_DENOMINATOR_GAP_MIN)};
  c.displayFraction = {em(HB_OT_MATH_CONSTANT_FRACTION_NUMERATOR_DISPLAY_STYLE_SHIFT_UP),
                       em(HB_OT_MATH_CONSTANT_FRACTION_DENOMINATOR_DISPLAY_STYLE_SHIFT_DOWN),
                       em(HB_OT_MATH_CONSTANT_FRACTION_NUM_DISPLAY_STYLE_GAP_MIN),
                       em(HB_OT_MATH_CONSTANT_FRACTION_DENOM_DISPLAY_STYLE_GAP_MIN)};
  c.fractionRuleThickness = em(HB_OT_MATH_CONSTANT_FRACTION_RULE_THICKNESS);
  c.radicalVerticalGap = em(HB_OT_MATH_CONSTANT_RADICAL_VERTICAL_GAP);
  c.radicalRuleThickness = em(HB_OT_MATH_CONSTANT_RADICAL_RULE_THICKNESS);
  c.radicalExtraAscender = em(HB_OT_MATH_CONSTANT_RADICAL_EXTRA_ASCENDER);
  c.radicalKernBeforeDegree = em(HB_OT_MATH_CONSTANT_RADICAL_KERN_BEFORE_DEGREE);
  c.radicalKernAfterDegree = em(HB_OT_MATH_CONSTANT_RADICAL_KERN_AFTER_DEGREE);
  c.radicalDegreeBottomRaise = raw(HB_OT_MATH_CONSTANT_RADICAL_DEGREE_BOTTOM_RAISE_PERCENT) / 100;
  return c;
}

}  // namespace

const Font& Font::of(Typeface face) {
  if (face == Typeface::kMath) {
    static const thread_local Font math(Typeface::kMath);
    return math;
  }
  if (face == Typeface::kRoman) {
    static const thread_local Font roman(Typeface::kRoman);
    return roman;
  }
  static const thread_local Font bold(Typeface::kBold);
  return bold;
}

Font::Font(Typeface face)
    : handles_(std::make_unique<const Handles>(face)),
      constants_(readConstants(handles_->shapingFont, handles_->unitsPerEm)),
      scriptLookups_(lookupsOf(handles_->shapingFace, "ssty")),
      dotlessLookups_(lookupsOf(handles_->shapingFace, "dtls")) {}

Font::~Font() = default;

std::optional<GlyphId> Font::glyph(char32_t character) const {
  hb_codepoint_t id = 0;
  if (!hb_font_get_nominal_glyph(handles_->shapingFont, character, &id)) return std::nullopt;
  return id;
}

GlyphMetrics Font::metrics(GlyphId id) const {
  const auto known = measured_.find(id);
  return known != measured_.end() ? known->second : measured_.emplace(id, measured(id)).first->second;
}

GlyphMetrics Font::measured(GlyphId id) const {
  hb_font_t* font = handles_->shapingFont;
  hb_glyph_extents_t ink{};
  expectMemory(hb_font_get_glyph_extents(font, id, &ink));
  GlyphMetrics m;
  m.advance = handles_->em(hb_font_get_glyph_h_advance(font, id));
  m.left = handles_->em(ink.x_bearing);
  m.right = handles_->em(ink.x_bearing + ink.width);
  m.top = handles_->em(ink.y_bearing);
  m.bottom = handles_->em(ink.y_bearing + ink.height);
  m.italicCorrection = handles_->em(hb_ot_math_get_glyph_italics_correction(font, id));
  const bool attached = hb_ot_math_has_data(handles_->shapingFace);
  m.topAccent =
      attached ? handles_->em(hb_ot_math_get_glyph_top_accent_attachment(font, id)) : (m.left + m.right) / 2;
  return m;
}

GlyphId Font::scriptForm(GlyphId id, int level) const {
  if (level == 0) return id;
  hb_face_t* face = handles_->shapingFace;
  for (const unsigned lookup : scriptLookups_) {
    hb_codepoint_t forms[2];
    unsigned count = 2;
    hb_ot_layout_lookup_get_glyph_alternates(face, lookup, id, 0, &count, forms);
    if (count > 0) return forms[std::min(static_cast<unsigned>(level), count) - 1];
  }
  return id;
}

GlyphId Font::dotlessForm(GlyphId id) const {
  // HarfBuzz cannot list one-to-one substitutions. It can extend a set of glyphs by their substitutes, so the
  // added glyph is the dotless form.
  hb_face_t* face = handles_->shapingFace;
  const SetPtr glyphs(hb_set_create(), &hb_set_destroy);
  hb_set_add(glyphs.get(), id);
  bool hasForm = false;
  for (const unsigned lookup : dotlessLookups_) {
    hasForm = hasForm || hb_ot_layout_lookup_would_substitute(face, lookup, &id, 1, true);
    hb_ot_layout_lookup_substitute_closure(face, lookup, glyphs.get());
  }
  hb_set_del(glyphs.get(), id);
  expectMemory(hb_set_allocation_successful(glyphs.get()) && hasForm != hb_set_is_empty(glyphs.get()));
  return hasForm ? hb_set_get_min(glyphs.get()) : id;
}

std::vector<GlyphId> Font::tallerForms(GlyphId id) const {
  hb_ot_math_glyph_variant_t variants[16];
  unsigned count = 16;
  hb_ot_math_get_glyph_variants(handles_->shapingFont, id, HB_DIRECTION_TTB, 0, &count, variants);
  std::vector<GlyphId> forms;
  for (unsigned i = 0; i < count; ++i) forms.push_back(variants[i].glyph);
  return forms;
}

double Font::kerning_em(char32_t left, char32_t right) const {
  const BufferPtr buffer = makeBuffer();
  hb_buffer_add(buffer.get(), left, 0);
  hb_buffer_add(buffer.get(), right, 1);
  hb_buffer_set_content_type(buffer.get(), HB_BUFFER_CONTENT_TYPE_UNICODE);
  expectMemory(hb_shape_full(handles_->shapingFont, buffer.get(), nullptr, 0, nullptr) &&
               hb_buffer_allocation_successful(buffer.get()));
  unsigned count = 0;
  const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer.get(), &count);
  if (count != 2) return 0;  // a ligature
  const hb_position_t advance = hb_buffer_get_glyph_positions(buffer.get(), nullptr)[0].x_advance;
  return handles_->em(advance - hb_font_get_glyph_h_advance(handles_->shapingFont, infos[0].codepoint));
}

FT_FaceRec_* Font::face() const { return handles_->face; }
double Font::unitsPerEm() const { return handles_->unitsPerEm; }

}  // namespace poinsot::text
