// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "compare/row_window.h"

namespace poinsot::compare {

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
