// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "text/glyph_run.h"
#include "text/point.h"

namespace poinsot::text {

/// Straight piece of an outline in pixels, y down. The filled side is the same for all segments.
struct Segment {
  Point from;
  Point to;
};

/// Returns the closed outlines of a line's glyphs (unhinted) and rules.
/// @param size_px  pixels per em
/// @param origin  position of the left end of the baseline
/// @param tolerance_px  approximate largest distance of a chord from its curve
std::vector<Segment> outlineSegments(const GlyphRun& run, double size_px, Point origin, double tolerance_px);

}  // namespace poinsot::text
