// SPDX-License-Identifier: Apache-2.0
#include "image/difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "core/error.h"
#include "core/expect.h"
#include "image/flip.h"

namespace poinsot::image {
namespace {

std::string shape(const Image& image) {
  return fmt::format("{}x{} with {} channels", image.size.width, image.size.height, image.channels);
}

void checkComparable(const Image& a, const Image& b) {
  if (a.size == b.size && a.channels == b.channels) return;
  throw core::Error(core::ErrorKind::kIo,
                    fmt::format("pictures of different shape cannot be compared: {} and {}", shape(a), shape(b)));
}

/// Largest difference of the channels of one pixel; adds to the sums.
int pixelDifference(const std::uint8_t* p, const std::uint8_t* q, int channels, std::int64_t& sum,
                    std::int64_t& squares) {
  int largest = 0;
  for (int c = 0; c < channels; ++c) {
    const int delta = std::abs(p[c] - q[c]);
    largest = std::max(largest, delta);
    sum += delta;
    squares += delta * delta;
  }
  return largest;
}

double psnr(double meanSquare) {
  if (meanSquare == 0) return std::numeric_limits<double>::infinity();
  return 10 * std::log10(255.0 * 255.0 / meanSquare);
}

}  // namespace

std::string_view toString(Verdict verdict) {
  switch (verdict) {
    case Verdict::kIdentical:
      return "identical";
    case Verdict::kNear:
      return "near";
    case Verdict::kDifferent:
      return "different";
  }
  return "";
}

ImageDifference compare(const Image& a, const Image& b) {
  checkComparable(a, b);
  ImageDifference d;
  std::int64_t sum = 0, squares = 0;
  for (int y = 0; y < a.size.height; ++y)
    for (int x = 0; x < a.size.width; ++x) {
      const int delta = pixelDifference(a.at(x, y), b.at(x, y), a.channels, sum, squares);
      d.differingPixels += delta > 0;
      if (delta <= d.maxAbs) continue;
      d.maxAbs = delta;
      d.worstX = x;
      d.worstY = y;
    }
  const double values = static_cast<double>(a.pixels.size());
  d.differingShare = static_cast<double>(d.differingPixels) * a.channels / values;
  d.meanAbs = static_cast<double>(sum) / values;
  d.psnr_dB = psnr(static_cast<double>(squares) / values);
  if (d.maxAbs == 0) return d;  // FLIP of equal pictures is 0; it is the slow part
  const FlipMap map = flip(a, b);
  d.flipMean = map.mean();
  d.flipMax = map.max();
  return d;
}

Verdict verdict(const ImageDifference& d, const NearRule& rule) {
  if (d.maxAbs == 0) return Verdict::kIdentical;
  const bool near = d.maxAbs <= rule.maxAbs && d.differingShare <= rule.differingShare &&
                    d.flipMean <= rule.flipMean && d.flipMax <= rule.flipMax;
  return near ? Verdict::kNear : Verdict::kDifferent;
}

Image amplifiedDifference(const Image& a, const Image& b, int factor) {
  checkComparable(a, b);
  POINSOT_EXPECT(factor > 0);
  Image out(a.size, 3);
  for (int y = 0; y < a.size.height; ++y)
    for (int x = 0; x < a.size.width; ++x)
      for (int c = 0; c < 3; ++c)
        out.at(x, y)[c] =
            static_cast<std::uint8_t>(std::min(255, factor * std::abs(a.at(x, y)[c] - b.at(x, y)[c])));
  return out;
}

}  // namespace poinsot::image
