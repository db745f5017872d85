// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "text/glyph_run.h"
#include "text/point.h"

namespace poinsot::text {

/// Straight piece of outline in pixels, y down. Filled shapes lie on the same side of all segments.
struct Segment {
  Point from;
  Point to;
};

/// Returns the closed outlines of a run's glyphs (unhinted) and rules at `size_px` pixels to the em, with the left
/// end of the baseline at `origin`. Curves are cut into chords at most about `tolerance_px` away from them.
std::vector<Segment> outlineSegments(const GlyphRun& run, double size_px, Point origin, double tolerance_px);

}  // namespace poinsot::text
