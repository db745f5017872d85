// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "text/glyph_run.h"
#include "text/point.h"

namespace poinsot::text {

/// A straight piece of outline, in pixels, y down; filled shapes lie on one and the same side of all of them.
struct Segment {
  Point from;
  Point to;
};

/// The closed outlines of the run's glyphs (unhinted) and rules at `size_px` pixels to the em, the left end of the
/// baseline at `origin`; curves are cut into chords no further than about `tolerance_px` from them.
std::vector<Segment> outlineSegments(const GlyphRun& run, double size_px, Point origin, double tolerance_px);

}  // namespace poinsot::text
