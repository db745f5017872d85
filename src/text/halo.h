// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "text/outline_segments.h"

namespace poinsot::text {

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
