// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "image/image.h"

namespace poinsot::compare {

/// Rows y - radius to y + radius of planes of numbers that are worked out row by row, from the top: what a filter
/// looks at, without the memory of whole planes. Beyond the picture its first and last rows are repeated.
class RowWindow {
 public:
  /// Writes row y of each plane; planes[k] has room for `width` values.
  using Source = std::function<void(int y, const std::vector<double*>& planes)>;

  /// @pre size at least 1x1, planes > 0, radius >= 0.
  RowWindow(image::PixelSize size, int planes, int radius, Source source);

  /// The middle row from now on. @pre y is inside the picture, and not less than before.
  void moveTo(int y);

  /// Row y + offset of a plane. @pre |offset| <= radius.
  const double* row(int plane, int offset) const;
  int width() const { return size_.width; }

 private:
  double* slot(int plane, int y);

  image::PixelSize size_;
  int planes_, radius_;
  Source source_;
  int middle_ = 0, made_ = 0;   ///< rows below `made_` have been worked out
  std::vector<double> values_;  ///< a ring of 2 radius + 1 rows for each plane
};

}  // namespace poinsot::compare
