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

/// Weights of a filter along one direction that mirrors into itself (even), or into its negative (odd).
class Kernel {
 public:
  enum class Parity { kEven, kOdd };

  /// @param half  weights at the offsets 0, 1, ..., radius; an odd one has 0 first. @pre not empty.
  Kernel(Parity parity, std::vector<double> half);

  int radius() const { return static_cast<int>(half_.size()) - 1; }
  /// Weight at an offset. @pre |offset| <= radius.
  double at(int offset) const;
  /// Of all weights.
  double sum() const;
  /// All weights times `factor`.
  Kernel scaled(double factor) const;

  /// The filter down the columns, for the middle row of a window.
  /// @param out  `width` values.  @pre the window's radius is not less than this one.
  void alongColumns(const RowWindow& window, int plane, double* out) const;

  /// The filter along a row whose ends are repeated.
  /// @param in, out  `width` values each, not the same ones
  void alongRow(const double* in, int width, double* out) const;

 private:
  double sign() const { return parity_ == Parity::kOdd ? -1 : 1; }

  Parity parity_;
  std::vector<double> half_;
};

}  // namespace poinsot::compare
