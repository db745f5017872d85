// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "text/glyph_run.h"
#include "text/point.h"

namespace poinsot::text {

/// Receives the contours of a glyph one after the other. Each contour ends at its start.
class OutlineSink {
 public:
  virtual ~OutlineSink() = default;
  virtual void moveTo(Point to) = 0;
  virtual void lineTo(Point to) = 0;
  virtual void cubicTo(Point c1, Point c2, Point end) = 0;

 protected:
  OutlineSink() = default;
  OutlineSink(const OutlineSink&) = default;
  OutlineSink& operator=(const OutlineSink&) = default;
};

/// Passes the unhinted outline of a glyph to `sink`. Coordinates are whole numbers in the font's units.
/// @throws std::bad_alloc; exceptions of the sink.
void traceGlyph(Typeface font, GlyphId id, OutlineSink& sink);

}  // namespace poinsot::text
