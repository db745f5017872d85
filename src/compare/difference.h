// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "compare/flip.h"
#include "compare/ignore_mask.h"
#include "compare/ssim.h"
#include "image/image.h"

namespace poinsot::compare {

/// Pixel that differs between two pictures, with its channel values in both, as stored.
struct DifferingPixel {
  int x = 0, y = 0;
  double difference = 0;  ///< largest difference of a channel, in 1/255
  std::array<int, 4> a{}, b{};
};

/// Figures of the difference between two pictures of the same size and channel count. Differences of channels are
/// in 1/255, and need not be integers for 16-bit pictures. Fractions and means refer to the compared pixels, which
/// are all pixels except the ignored ones.
struct ImageDifference {
  std::int64_t comparedPixels = 0;
  int channels = 3;  ///< compared channels: 3, or 4 if a picture has transparency
  std::int64_t differingPixels = 0;
  double differingShare = 0;       ///< differing fraction of the compared pixels, 0 to 1
  double level = 0;                ///< largest difference that does not count in `countedPixels`
  std::int64_t countedPixels = 0;  ///< pixels that differ by more than `level`
  double maxAbs = 0;               ///< largest difference of any pixel and channel
  double meanAbs = 0;
  double rmse = 0;
  std::optional<double> psnr_dB;    ///< peak signal-to-noise ratio; nullopt if the pictures are identical
  std::optional<SsimFigures> ssim;  ///< structural similarity; nullopt for pictures smaller than 11x11
  FlipFigures flip;
  std::vector<DifferingPixel> worst;  ///< ten pixels with the largest differences, largest first

  double countedShare() const {
    return comparedPixels == 0 ? 0 : static_cast<double>(countedPixels) / static_cast<double>(comparedPixels);
  }
};

struct Comparison {
  ImageDifference difference;
  FlipMap flip;
};

struct ComparisonOptions {
  double pixelsPerDegree = kFlipPixelsPerDegree;  ///< visual resolution for FLIP
  double level = 0;                               ///< see ImageDifference::level; from 0 to 255
  const IgnoreMask* ignored = nullptr;            ///< mask of the pictures' size; null if no pixel is ignored
};

/// Compares two pictures sample by sample. If the pictures have four channels, FLIP and SSIM are computed on black
/// and on white background, and the larger difference counts.
/// @throws core::Error(kIo) if sizes or channel counts differ, because pictures are never resized
Comparison compare(const image::Image& a, const image::Image& b, const ComparisonOptions& options = {});
Comparison compare(const image::DeepImage& a, const image::DeepImage& b, const ComparisonOptions& options = {});
/// Compares two pictures that have a common form. @pre both have the same sample type, as after toCommonForm(a, b)
/// (common_form.h).
/// @throws core::Error as compare()
Comparison compareCommon(const image::AnyImage& a, const image::AnyImage& b,
                         const ComparisonOptions& options = {});
/// Converts two pictures to a common form and compares them. @throws core::Error(kIo) if the sizes differ
Comparison compare(image::AnyImage a, image::AnyImage b, const ComparisonOptions& options = {});

/// Returns an RGB picture of |a - b| times `factor`, clipped at 255; equal and ignored pixels are black. A
/// difference of alpha appears in all three channels. @throws core::Error as compare()
image::Image amplifiedDifference(const image::Image& a, const image::Image& b, const IgnoreMask* ignored = nullptr,
                                 int factor = 16);
image::Image amplifiedDifference(image::AnyImage a, image::AnyImage b, const IgnoreMask* ignored = nullptr,
                                 int factor = 16);

}  // namespace poinsot::compare
