// SPDX-License-Identifier: Apache-2.0
#include "text/glyph_outline.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <exception>
#include <new>

#include "core/expect.h"
#include "text/font.h"

namespace poinsot::text {
namespace {

Point pointOf(const FT_Vector& v) { return {static_cast<double>(v.x), static_cast<double>(v.y)}; }

/// Passes the points that FreeType reports to an OutlineSink. Exceptions of the sink are stored here, because they
/// must not pass through FreeType's C code.
struct Relay {
  OutlineSink& sink;
  std::exception_ptr thrown;

  template <typename Call>
  static int hand(void* relay, Call call) noexcept {
    auto& self = *static_cast<Relay*>(relay);
    try {
      call(self.sink);
      return 0;
    } catch (...) {
      self.thrown = std::current_exception();
      return 1;
    }
  }
};

FT_Outline_Funcs relayed() {
  FT_Outline_Funcs calls{};
  calls.move_to = [](const FT_Vector* to, void* relay) {
    return Relay::hand(relay, [&](OutlineSink& sink) { sink.moveTo(pointOf(*to)); });
  };
  calls.line_to = [](const FT_Vector* to, void* relay) {
    return Relay::hand(relay, [&](OutlineSink& sink) { sink.lineTo(pointOf(*to)); });
  };
  // Outlines in CFF fonts have cubic curves only. A quadratic curve would mean that the font was replaced.
  calls.conic_to = [](const FT_Vector*, const FT_Vector*, void*) { return 1; };
  calls.cubic_to = [](const FT_Vector* c1, const FT_Vector* c2, const FT_Vector* to, void* relay) {
    return Relay::hand(relay, [&](OutlineSink& sink) { sink.cubicTo(pointOf(*c1), pointOf(*c2), pointOf(*to)); });
  };
  return calls;
}

}  // namespace

void traceGlyph(Typeface font, GlyphId id, OutlineSink& sink) {
  FT_Face face = Font::of(font).face();
  const FT_Error error = FT_Load_Glyph(face, id, FT_LOAD_NO_SCALE | FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP);
  if (error == FT_Err_Out_Of_Memory) throw std::bad_alloc();
  POINSOT_EXPECT(error == 0);
  Relay relay{sink, nullptr};
  const FT_Outline_Funcs calls = relayed();
  const bool whole = FT_Outline_Decompose(&face->glyph->outline, &calls, &relay) == 0;
  if (relay.thrown) std::rethrow_exception(relay.thrown);
  POINSOT_EXPECT(whole);
}

}  // namespace poinsot::text
