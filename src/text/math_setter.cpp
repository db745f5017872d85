// SPDX-License-Identifier: Apache-2.0
#include "text/math_setter.h"

#include <algorithm>

#include "text/parsers.h"
#include "text/plain_text.h"

namespace poinsot::text {
namespace {

class InkBounds {
 public:
  void add(double left, double right, double bottom, double top) {
    if (left == right || bottom == top) return;  // a blank
    run_.inkLeft_em = empty_ ? left : std::min(run_.inkLeft_em, left);
    run_.inkRight_em = empty_ ? right : std::max(run_.inkRight_em, right);
    run_.inkBottom_em = empty_ ? bottom : std::min(run_.inkBottom_em, bottom);
    run_.inkTop_em = empty_ ? top : std::max(run_.inkTop_em, top);
    empty_ = false;
  }
  explicit InkBounds(GlyphRun& run) : run_(run) {}

 private:
  GlyphRun& run_;
  bool empty_ = true;
};

void measureInk(GlyphRun& run) {
  InkBounds bounds(run);
  for (const PlacedGlyph& g : run.glyphs) {
    const GlyphMetrics m = Font::of(g.face).metrics(g.id);
    bounds.add(g.x_em + g.scale * m.left, g.x_em + g.scale * m.right, g.y_em + g.scale * m.bottom,
               g.y_em + g.scale * m.top);
  }
  for (const Rule& r : run.rules) bounds.add(r.x_em, r.x_em + r.width_em, r.y_em, r.y_em + r.height_em);
}

}  // namespace

GlyphRun setTex(std::string_view tex) {
  TexReader reader(tex);
  Box line = parseText(reader, {}, {});
  const Font& font = Font::mathematics();
  const GlyphMetrics parenthesis = font.metrics(*font.glyph(U'('));

  GlyphRun run;
  run.glyphs = std::move(line.glyphs);
  run.rules = std::move(line.rules);
  run.width_em = line.width;
  run.ascent_em = std::max(line.height, parenthesis.top);
  run.descent_em = std::max(line.depth, -parenthesis.bottom);
  run.plainText = toUtf8(line.plain);
  measureInk(run);
  return run;
}

}  // namespace poinsot::text
