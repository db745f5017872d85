// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "image/image.h"

namespace poinsot::compare {

/// Sliding window over the rows of one or more planes of numbers. It holds the rows from y - radius to y + radius,
/// so that complete planes need not be stored. A callback computes each row once, from the top. Outside the
/// picture, the first or last row is repeated.
class RowWindow {
 public:
  /// Callback that writes row y of each plane; planes[k] has room for `width` values.
  using Source = std::function<void(int y, const std::vector<double*>& planes)>;

  /// Makes an empty window, which moveTo() fills. @pre size at least 1x1, planes > 0, radius >= 0.
  RowWindow(image::PixelSize size, int planes, int radius, Source source);

  /// Makes row y the middle of the window. @pre y is inside the picture, and not less than before.
  void moveTo(int y);

  /// Returns row y + offset of a plane. @pre |offset| <= radius.
  const double* row(int plane, int offset) const;
  int width() const { return size_.width; }

 private:
  double* slot(int plane, int y);

  image::PixelSize size_;
  int planes_, radius_;
  Source source_;
  int middle_ = 0, made_ = 0;   ///< rows below number `made_` have been computed
  std::vector<double> values_;  ///< ring buffer of 2 radius + 1 rows per plane
};

/// One-dimensional filter whose weights are symmetric (even) or antisymmetric (odd).
class Kernel {
 public:
  enum class Parity { kEven, kOdd };

  /// @param half  weights at the offsets 0, 1, ..., radius; the first must be 0 for an odd filter. @pre not empty.
  Kernel(Parity parity, std::vector<double> half);

  int radius() const { return static_cast<int>(half_.size()) - 1; }
  /// Returns the weight at an offset. @pre |offset| <= radius.
  double at(int offset) const;
  double sum() const;
  Kernel scaled(double factor) const;

  /// Applies the filter along the columns of a plane, at the middle row of a window.
  /// @param out  receives `width` values. @pre the window's radius is not less than this one.
  void alongColumns(const RowWindow& window, int plane, double* out) const;

  /// Applies the filter along a row. Beyond its ends, the row's first and last values are repeated.
  /// @param in, out  arrays of `width` values each, which must not overlap
  void alongRow(const double* in, int width, double* out) const;

 private:
  double sign() const { return parity_ == Parity::kOdd ? -1 : 1; }

  Parity parity_;
  std::vector<double> half_;
};

}  // namespace poinsot::compare
