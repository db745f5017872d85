// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "text/glyph_run.h"

namespace poinsot::text {

/// In pixels, x right and y down.
struct Point {
  double x = 0;
  double y = 0;

  friend Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
  friend Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
  friend Point operator*(Point a, double s) { return {a.x * s, a.y * s}; }
};

inline double distance(Point a, Point b) {
  const Point d = b - a;
  return std::sqrt(d.x * d.x + d.y * d.y);  // the one function here besides + - * /: IEEE 754 fixes its bits
}

/// A straight piece of outline; filled shapes lie on one and the same side of all of them.
struct Segment {
  Point from;
  Point to;
};

/// The closed outlines of the run's glyphs (unhinted) and rules at `size_px` pixels to the em, the left end of the
/// baseline at `origin`; curves are cut into chords no further than about `tolerance_px` from them.
std::vector<Segment> outlineSegments(const GlyphRun& run, double size_px, Point origin, double tolerance_px);

}  // namespace poinsot::text
