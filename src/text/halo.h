// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "text/outline_segments.h"

namespace poinsot::text {

/// Enlarges filled shapes by a radius. The new coverage of a pixel follows from its distance to the nearest piece
/// of the outlines.
///
/// With this method, corners are round and overlapping shapes are united. FreeType's stroker is not used. In
/// narrow parts of letters, such as the eye of an e, its offset curves cross themselves. Filling them leaves holes
/// or counts overlaps twice.
class HaloBuilder {
 public:
  HaloBuilder(int width, int height, double radius_px);

  void addSegment(const Segment& segment);

  /// Replaces the coverage of the shapes, from 0 to 1, by the coverage of the enlarged shapes.
  void growInto(std::vector<double>& coverage) const;

 private:
  int width_;
  int height_;
  double radius_px_;
  // Square of the distance from each pixel's centre to the outline; infinite beyond the halo.
  std::vector<double> distance2_;
};

}  // namespace poinsot::text
