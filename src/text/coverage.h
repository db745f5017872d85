// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "text/glyph_run.h"

namespace poinsot::text {

/// Coverage of each pixel, 0 to 255; rows from the top, `left` and `top` in picture pixels.
struct CoverageMap {
  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> values;

  /// Returns the coverage of pixel (x, y) of the picture; 0 outside the map.
  std::uint8_t at(int x, int y) const;
};

/// Returns the coverage of a run at `size_px` pixels to the em. The left end of its baseline is at (originX_px,
/// originY_px), in picture pixels, y down, where pixel (0, 0) covers [0, 1] x [0, 1].
///
/// With outline_px = 0 each value is the exact area of the unhinted outlines in the pixel, rounded to a byte.
/// Overlapping ink counts once, except in pixels that hold edges of both glyphs.
///
/// With outline_px > 0 the shapes are grown by that radius with round corners and united, for a halo. Its edge is
/// a ramp of one pixel over the distance to the outline. If the edge is straight within a pixel, the ramp is the
/// covered area.
///
/// The result has the same bits on every machine. Moving the origin by whole pixels gives exactly the same map,
/// moved; the origin counts to 1/1024 pixel.
/// @pre size_px in (0, 4000], outline_px in [0, 200], origin within 10^6 pixels of 0.
CoverageMap rasterize(const GlyphRun& run, double size_px, double originX_px, double originY_px,
                      double outline_px = 0);

}  // namespace poinsot::text
