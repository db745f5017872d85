// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "text/glyph_run.h"

namespace poinsot::text {

/// How much of each pixel is covered, 0 to 255; rows from the top, `left` and `top` in picture pixels.
struct CoverageMap {
  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> values;

  /// 0 outside the map; (x, y) in picture pixels.
  std::uint8_t at(int x, int y) const;
};

/// Coverage of the run at `size_px` pixels to the em, with the left end of its baseline at (originX_px,
/// originY_px): picture pixels, y down, pixel (0, 0) covering [0, 1] x [0, 1].
///
/// With outline_px = 0 each value is the exact area of the unhinted outlines in that pixel, rounded to a byte.
/// Where glyphs overlap the ink is not counted twice, except in pixels that hold edges of both.
///
/// With outline_px > 0 the shapes are grown by that radius, corners round: the union, for a halo. Its edge is the
/// distance to the outline met by a straight ramp of one pixel, which for an edge straight within a pixel is the
/// area covered, too.
///
/// The same bits on every machine; moved by whole pixels exactly the same map (the origin counts to 1/1024 pixel).
/// @pre size_px in (0, 4000], outline_px in [0, 200], origin within 10^6 pixels of 0.
CoverageMap rasterize(const GlyphRun& run, double size_px, double originX_px, double originY_px,
                      double outline_px = 0);

}  // namespace poinsot::text
