// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "compare/changed_pixels.h"
#include "compare/kernel.h"
#include "image/image.h"

namespace poinsot::compare {

/// Pixels that a filter with `radius` connects with a differing pixel of two pictures, row by row from the top.
/// A filter's results differ nowhere else.
template <typename Sample>
class AffectedSpans {
 public:
  /// @pre both pictures have the same shape, and outlive this object.
  AffectedSpans(const image::BasicImage<Sample>& a, const image::BasicImage<Sample>& b, int radius)
      : a_(a), b_(b), radius_(radius), latest_(static_cast<std::size_t>(a.size.width), kNever) {}

  /// Returns the affected spans of row y, from left to right. Spans that are at most two radii apart are joined,
  /// because a filter computes the columns between them anyhow. @pre y is not less than before.
  const std::vector<ColumnSpan>& row(int y) {
    for (; read_ <= std::min(y + radius_, a_.size.height - 1); ++read_) read(read_);
    spans_.clear();
    if (newest_ < y - radius_) return spans_;
    for (int x = 0; x < a_.size.width; ++x)
      if (latest_[static_cast<std::size_t>(x)] >= y - radius_) add(x);
    return spans_;
  }

 private:
  static constexpr int kNever = -1 << 30;

  void read(int y) {
    int marked = 0;  // columns below this one are marked
    forEachChangedPixel(a_, b_, {0, y, a_.size.width, y + 1}, [&](int x, int, const Sample*, const Sample*) {
      const int from = std::max(marked, x - radius_), to = std::min(x + radius_ + 1, a_.size.width);
      std::fill(latest_.begin() + from, latest_.begin() + to, y);
      marked = to;
      newest_ = y;
    });
  }

  void add(int x) {
    if (!spans_.empty() && x - spans_.back().end <= 2 * radius_)
      spans_.back().end = x + 1;
    else
      spans_.push_back({x, x + 1});
  }

  const image::BasicImage<Sample>&a_, &b_;
  int radius_, read_ = 0;    ///< rows below number `read_` have been compared
  int newest_ = kNever;      ///< the last row read that has a differing pixel
  std::vector<int> latest_;  ///< for each column, the last row read that has one within the radius
  std::vector<ColumnSpan> spans_;
};

}  // namespace poinsot::compare
