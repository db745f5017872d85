// SPDX-License-Identifier: Apache-2.0
#include "text/outline_segments.h"

#include <cmath>

#include "text/font.h"
#include "text/glyph_outline.h"

namespace poinsot::text {
namespace {

class Tracer {
 public:
  Tracer(std::vector<Segment>& segments, double tolerance_px) : segments_(segments), tolerance_px_(tolerance_px) {}

  void moveTo(Point to) { pen_ = to; }

  void lineTo(Point to) {
    segments_.push_back({pen_, to});
    pen_ = to;
  }

  void cubicTo(Point c1, Point c2, Point end) {
    const Point start = pen_;
    // Number of chords for a curve, from the length of its control polygon. A quarter circle of radius r has a
    // control polygon of length 1.66 r; n chords deviate from it by 0.31 r / n².
    const double length = distance(start, c1) + distance(c1, c2) + distance(c2, end);
    const int pieces = 1 + static_cast<int>(std::sqrt(0.19 * length / tolerance_px_));
    for (int i = 1; i < pieces; ++i) {
      const double t = static_cast<double>(i) / pieces, s = 1 - t;
      lineTo(start * (s * s * s) + c1 * (3 * s * s * t) + c2 * (3 * s * t * t) + end * (t * t * t));
    }
    lineTo(end);
  }

 private:
  std::vector<Segment>& segments_;
  double tolerance_px_;
  Point pen_;
};

class GlyphTracer final : public OutlineSink {
 public:
  GlyphTracer(Tracer& tracer, Point origin, double pixelsPerUnit)
      : tracer_(tracer), origin_(origin), pixelsPerUnit_(pixelsPerUnit) {}

  void moveTo(Point to) override { tracer_.moveTo(pixel(to)); }
  void lineTo(Point to) override { tracer_.lineTo(pixel(to)); }
  void cubicTo(Point c1, Point c2, Point end) override { tracer_.cubicTo(pixel(c1), pixel(c2), pixel(end)); }

 private:
  Point pixel(Point v) const { return {origin_.x + pixelsPerUnit_ * v.x, origin_.y - pixelsPerUnit_ * v.y}; }

  Tracer& tracer_;
  Point origin_;
  double pixelsPerUnit_;
};

// Adds the outline of a rule. It is counter-clockwise, like the outer contours of PostScript glyphs.
void traceRule(Tracer& tracer, const Rule& rule, double size_px, Point origin) {
  const double left = origin.x + size_px * rule.x_em;
  const double right = origin.x + size_px * (rule.x_em + rule.width_em);
  const double bottom = origin.y - size_px * rule.y_em;
  const double top = origin.y - size_px * (rule.y_em + rule.height_em);
  tracer.moveTo({left, bottom});
  tracer.lineTo({right, bottom});
  tracer.lineTo({right, top});
  tracer.lineTo({left, top});
  tracer.lineTo({left, bottom});
}

}  // namespace

std::vector<Segment> outlineSegments(const GlyphRun& run, double size_px, Point origin, double tolerance_px) {
  std::vector<Segment> segments;
  Tracer tracer(segments, tolerance_px);
  for (const PlacedGlyph& glyph : run.glyphs) {
    const Point at = {origin.x + size_px * glyph.x_em, origin.y - size_px * glyph.y_em};
    GlyphTracer scaled(tracer, at, size_px * glyph.scale / Font::of(glyph.face).unitsPerEm());
    traceGlyph(glyph.face, glyph.id, scaled);
  }
  for (const Rule& rule : run.rules) traceRule(tracer, rule, size_px, origin);
  return segments;
}

}  // namespace poinsot::text
