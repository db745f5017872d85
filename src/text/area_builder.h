// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "text/outline_segments.h"

namespace poinsot::text {

/// Exact area of filled polygons in each pixel. An edge covers everything to its right; edges up and edges down
/// have opposite signs, so what remains is the inside. Each edge leaves in the pixels it meets, and in their right
/// neighbours, the change of that cover from the pixel before; a sum along the row gives it back.
///
/// FreeType's own rasteriser was not taken: it knows points to 1/64 pixel, which makes the bar of a fraction up to
/// one hundredth too light or dark and lets a label's weight flicker as it moves (measured: area of a minus sign
/// at 40 pixels off by 1.2 %; here 0.03 %).
class AreaBuilder {
 public:
  AreaBuilder(int width, int height);

  /// Within [0, width] x [0, height].
  void addSegment(Segment segment);

  /// Share of each pixel that is inside, 0 to 1, rows from the top; inside twice is inside.
  std::vector<double> coverage() const;

 private:
  void addInRow(int y, double signedHeight, double x0, double x1);

  int width_;
  int height_;
  std::vector<double> change_;  // rows of width_ + 2: the last pixel has a right neighbour, and so has its edge
};

}  // namespace poinsot::text
