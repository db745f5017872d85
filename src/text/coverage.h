// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "text/glyph_run.h"

namespace poinsot::text {

/// Covered fraction of each pixel in a rectangle, from 0 to 255. Rows start at the top. `left` and `top` are the
/// position of the rectangle in the picture.
struct CoverageMap {
  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> values;

  /// Returns the coverage of the pixel (x, y) of the picture. Pixels outside the map have coverage 0.
  std::uint8_t at(int x, int y) const;
};

/// Returns the coverage of a line of text at `size_px` pixels per em. The left end of its baseline is at
/// (originX_px, originY_px) in the picture, y down. Pixel (0, 0) covers [0, 1] x [0, 1].
///
/// With outline_px = 0, each value is the exact area of the unhinted outlines in the pixel, rounded to a byte.
/// Overlapping glyphs count once, except in pixels that edges of both glyphs cross.
///
/// With outline_px > 0, the result is a halo: the shapes are enlarged by that radius, with round corners, and
/// united. Across the edge of the halo, coverage falls linearly from 1 to 0 within one pixel. For a straight edge
/// this agrees with the covered area.
///
/// The result has the same bits on every machine. The origin is rounded to 1/1024 pixel. If the origin moves by
/// whole pixels, the map moves with it and keeps its values.
/// @pre size_px in (0, 4000], outline_px in [0, 200], origin within 10^6 pixels of 0.
CoverageMap rasterize(const GlyphRun& run, double size_px, double originX_px, double originY_px,
                      double outline_px = 0);

}  // namespace poinsot::text
