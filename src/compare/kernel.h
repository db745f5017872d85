// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "image/image.h"

namespace poinsot::compare {

/// Range of columns of a picture; `end` is outside.
struct ColumnSpan {
  int begin = 0, end = 0;
  /// Returns the span with `by` more columns at each end.
  ColumnSpan grown(int by) const { return {begin - by, end + by}; }
  friend bool operator==(const ColumnSpan&, const ColumnSpan&) = default;
};

/// Row of numbers with `margin` more places before its first column and after its last.
class MarginedRow {
 public:
  MarginedRow(int width, int margin)
      : margin_(margin), values_(static_cast<std::size_t>(width) + 2 * static_cast<std::size_t>(margin)) {}
  /// Returns the place of column 0; columns from -margin are there.
  double* columns() { return values_.data() + margin_; }
  const double* columns() const { return values_.data() + margin_; }

 private:
  std::ptrdiff_t margin_;
  std::vector<double> values_;
};

/// Sliding window over the rows of one or more planes of numbers. It holds the rows from y - radius to y + radius,
/// so that complete planes need not be stored. A callback computes each row once, from the top. Outside the
/// picture, the values at its edge are repeated: the first and last row, and in each row `radius` columns beyond
/// its first and last value.
class RowWindow {
 public:
  /// Callback that writes row y of each plane; planes[k] has room for `width` values.
  using Source = std::function<void(int y, const std::vector<double*>& planes)>;

  /// Makes an empty window, which moveTo() fills. @pre size at least 1x1, planes > 0, radius >= 0.
  RowWindow(image::PixelSize size, int planes, int radius, Source source);

  /// Makes row y the middle of the window. Rows that no window holds are not computed.
  /// @pre y is inside the picture, and not less than before.
  void moveTo(int y);

  /// Column 0 of the rows y, y + step, y + 2 step, ... of a plane, radius + 1 rows; step is -1 for rowsAbove() and
  /// 1 for rowsBelow().
  const double* const* rowsAbove(int plane) const { return rowsFrom(plane, 0); }
  const double* const* rowsBelow(int plane) const { return rowsFrom(plane, radius_ + 1); }
  int width() const { return size_.width; }
  int radius() const { return radius_; }

 private:
  double* slot(int plane, int y);
  void make(int y);
  void pointToRows();
  const double* const* rowsFrom(int plane, int first) const {
    return &pointers_[static_cast<std::size_t>(plane * 2 * (radius_ + 1) + first)];
  }

  image::PixelSize size_;
  int planes_, radius_;
  Source source_;
  int middle_ = 0, made_ = 0;            ///< rows below number `made_` have been computed
  std::vector<MarginedRow> rows_;        ///< ring buffer of 2 radius + 1 rows per plane
  std::vector<const double*> pointers_;  ///< for each plane, its rows above and its rows below
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
  /// @param where  columns to compute, at most the window's radius beyond its rows
  /// @param out  column 0 of the result. @pre the window's radius is not less than this one.
  void alongColumns(const RowWindow& window, int plane, ColumnSpan where, double* out) const;

  /// Applies the filter along a row.
  /// @param in  column 0 of the row, which has values in `where.grown(radius())`
  /// @param out  column 0 of the result; must not overlap `in`
  void alongRow(const double* in, ColumnSpan where, double* out) const;

 private:
  double sign() const { return parity_ == Parity::kOdd ? -1 : 1; }

  Parity parity_;
  std::vector<double> half_;
};

}  // namespace poinsot::compare
