// SPDX-License-Identifier: Apache-2.0
#include "text/font_oracle.h"

#include FT_ADVANCES_H
#include FT_OUTLINE_H

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace poinsot::text::testing {
namespace {

constexpr double kUnits = 1000;  // units to the em of these fonts
constexpr int kChords = 64;

struct Trace {
  double x = 0, y = 0;  // the pen
  double twiceArea = 0;
  Ink ink{1e9, -1e9, 1e9, -1e9};

  void lineTo(double toX, double toY) {
    twiceArea += x * toY - toX * y;
    moveTo(toX, toY);
  }
  void moveTo(double toX, double toY) {
    x = toX;
    y = toY;
    ink = {std::min(ink.left, x), std::max(ink.right, x), std::min(ink.bottom, y), std::max(ink.top, y)};
  }
  void cubicTo(const FT_Vector& a, const FT_Vector& b, const FT_Vector& end) {
    const double x0 = x, y0 = y;
    for (int i = 1; i <= kChords; ++i) {
      const double t = static_cast<double>(i) / kChords, s = 1 - t;
      const auto at = [&](double p0, FT_Pos p1, FT_Pos p2, FT_Pos p3) {
        return s * s * s * p0 + 3 * s * s * t * static_cast<double>(p1) + 3 * s * t * t * static_cast<double>(p2) +
               t * t * t * static_cast<double>(p3);
      };
      lineTo(at(x0, a.x, b.x, end.x), at(y0, a.y, b.y, end.y));
    }
  }
};

Trace trace(FT_Face face, unsigned glyph) {
  if (FT_Load_Glyph(face, glyph, FT_LOAD_NO_SCALE | FT_LOAD_NO_HINTING) != 0)
    throw std::runtime_error("the oracle cannot load the glyph");
  FT_Outline_Funcs funcs{};
  funcs.move_to = [](const FT_Vector* to, void* user) {
    static_cast<Trace*>(user)->moveTo(static_cast<double>(to->x), static_cast<double>(to->y));
    return 0;
  };
  funcs.line_to = [](const FT_Vector* to, void* user) {
    static_cast<Trace*>(user)->lineTo(static_cast<double>(to->x), static_cast<double>(to->y));
    return 0;
  };
  funcs.conic_to = [](const FT_Vector*, const FT_Vector*, void*) { return 1; };  // a CFF font has no conics
  funcs.cubic_to = [](const FT_Vector* a, const FT_Vector* b, const FT_Vector* to, void* user) {
    static_cast<Trace*>(user)->cubicTo(*a, *b, *to);
    return 0;
  };
  Trace result;
  if (FT_Outline_Decompose(&face->glyph->outline, &funcs, &result) != 0)
    throw std::runtime_error("the oracle cannot trace the outline");
  return result;
}

}  // namespace

FontOracle::FontOracle(const char* file) {
  if (FT_Init_FreeType(&library_) != 0 || FT_New_Face(library_, file, 0, &face_) != 0)
    throw std::runtime_error(std::string("the oracle cannot read ") + file);
  hb_blob_t* blob = hb_blob_create_from_file(file);
  hb_face_t* face = hb_face_create(blob, 0);
  font_ = hb_font_create(face);
  hb_face_destroy(face);
  hb_blob_destroy(blob);
}

FontOracle::~FontOracle() {
  hb_font_destroy(font_);
  FT_Done_Face(face_);
  FT_Done_FreeType(library_);
}

double FontOracle::advance(unsigned glyph) const {
  FT_Fixed units = 0;
  if (FT_Get_Advance(face_, glyph, FT_LOAD_NO_SCALE, &units) != 0) throw std::runtime_error("no advance");
  return static_cast<double>(units) / kUnits;
}

double FontOracle::italicCorrection(unsigned glyph) const {
  return hb_ot_math_get_glyph_italics_correction(font_, glyph) / kUnits;
}

double FontOracle::topAccent(unsigned glyph) const {
  return hb_ot_math_get_glyph_top_accent_attachment(font_, glyph) / kUnits;
}

double FontOracle::constant(hb_ot_math_constant_t which) const {
  return hb_ot_math_get_constant(font_, which) / kUnits;
}

Ink FontOracle::ink(unsigned glyph) const {
  const Ink units = trace(face_, glyph).ink;
  return {units.left / kUnits, units.right / kUnits, units.bottom / kUnits, units.top / kUnits};
}

double FontOracle::area(unsigned glyph) const {
  return std::abs(trace(face_, glyph).twiceArea) / 2 / (kUnits * kUnits);
}

}  // namespace poinsot::text::testing
