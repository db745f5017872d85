// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "text/outline_segments.h"

namespace poinsot::text {

/// Grows filled shapes by a radius, from the distance of each pixel to the nearest piece of outline.
///
/// Growing by distance gives round corners by definition, and the least distance gives the union. FreeType's
/// stroker is not used: its offset curves cross themselves in the narrow places of letters (the eye of an e),
/// where filling them leaves holes or counts overlaps twice.
class HaloBuilder {
 public:
  HaloBuilder(int width, int height, double radius_px);

  void addSegment(const Segment& segment);

  /// Replaces the coverage of the shapes (0 to 1) by that of the grown shapes.
  void growInto(std::vector<double>& coverage) const;

 private:
  int width_;
  int height_;
  double radius_px_;
  std::vector<double> distance2_;  // squared, from each pixel's centre; infinite if too far to matter
};

}  // namespace poinsot::text
