// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstring>

#include "core/interruption.h"
#include "image/image.h"

namespace poinsot::compare {

/// Calls visit(x, y, p, q) for each differing pixel of a rectangle, row by row. p and q point to the pixel's
/// samples in `a` and in `b`. Runs of 16 equal pixels are skipped together, to save time.
/// @pre both pictures have the same shape.
template <typename Sample, typename Visit>
void forEachChangedPixel(const image::BasicImage<Sample>& a, const image::BasicImage<Sample>& b,
                         const image::PixelRect& where, Visit visit) {
  constexpr int kRun = 16;
  const auto samples = [&](int pixels) { return static_cast<std::size_t>(pixels * a.channels); };
  const auto equal = [&](const Sample* p, const Sample* q, int pixels) {
    return std::memcmp(p, q, samples(pixels) * sizeof(Sample)) == 0;
  };
  for (int y = where.top; y < where.bottom; ++y) {
    core::checkInterruption();
    for (int x = where.left; x < where.right; x += kRun) {
      const int count = std::min(kRun, where.right - x);
      const Sample *p = a.at(x, y), *q = b.at(x, y);
      if (equal(p, q, count)) continue;
      for (int i = 0; i < count; ++i, p += a.channels, q += a.channels)
        if (p[0] != q[0] || p[1] != q[1] || p[2] != q[2] || (a.channels == 4 && p[3] != q[3]))
          visit(x + i, y, p, q);
    }
  }
}

}  // namespace poinsot::compare
