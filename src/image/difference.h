// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "image/flip.h"
#include "image/image.h"
#include "image/ssim.h"

namespace poinsot::image {

/// One pixel of two pictures; channel values as they are stored.
struct DifferingPixel {
  int x = 0, y = 0;
  double difference = 0;  ///< of its channels, the largest; counts in 1/255
  std::array<int, 4> a{}, b{};
};

/// How two pictures of the same size and channel count differ. Channel values count in 1/255, those of 16 bits in
/// parts of that.
struct ImageDifference {
  std::int64_t differingPixels = 0;
  double differingShare = 0;  ///< of all pixels, 0 to 1
  double maxAbs = 0;          ///< over all pixels and channels
  double meanAbs = 0;
  double rmse = 0;
  std::optional<double> psnr_dB;    ///< nothing when identical
  std::optional<SsimFigures> ssim;  ///< nothing below a window of 11x11
  FlipFigures flip;
  std::vector<DifferingPixel> worst;  ///< the largest first, of equal ones from the top left; ten at most
};

/// The figures, and what FLIP has of every pixel.
struct Comparison {
  ImageDifference difference;
  FlipMap flip;
};

/// @throws core::Error(kIo) if sizes or channel counts differ: that is no difference of pixels, and nothing is
/// resized.
Comparison compare(const Image& a, const Image& b, double pixelsPerDegree = kFlipPixelsPerDegree);
Comparison compare(const DeepImage& a, const DeepImage& b, double pixelsPerDegree = kFlipPixelsPerDegree);
/// Where one has 8 bits a sample and the other 16, both are compared in 16.
Comparison compare(const AnyImage& a, const AnyImage& b, double pixelsPerDegree = kFlipPixelsPerDegree);

/// RGB picture of |a - b| times `factor`, cut at 255: black where equal.
/// @throws as compare.
Image amplifiedDifference(const Image& a, const Image& b, int factor = 16);
Image amplifiedDifference(const AnyImage& a, const AnyImage& b, int factor = 16);

}  // namespace poinsot::image
