// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "text/glyph_run.h"
#include "text/outline_segments.h"

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

/// Grows filled shapes by a radius, from the distance of each pixel to the nearest piece of outline.
///
/// A distance is the radius with round corners by definition, and the least of several is their union. FreeType's
/// stroker was not taken: its offset curves cross themselves in the narrow places of letters (the eye of an e),
/// where filling them leaves holes or counts overlaps twice.
class HaloBuilder {
 public:
  /// Sizes and radius in pixels.
  HaloBuilder(int width, int height, double radius_px);

  void addSegment(const Segment& segment);

  /// Turns the coverage of the shapes (0 to 1) into that of the grown shapes.
  void growInto(std::vector<double>& coverage) const;

 private:
  int width_;
  int height_;
  double radius_px_;
  std::vector<double> distance2_;  // squared, from each pixel's centre; infinite where too far to matter
};

}  // namespace poinsot::text
