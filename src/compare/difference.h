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

/// One pixel of two pictures; channel values as they are stored.
struct DifferingPixel {
  int x = 0, y = 0;
  double difference = 0;  ///< of its channels, the largest; counts in 1/255
  std::array<int, 4> a{}, b{};
};

/// How two pictures of the same size and channel count differ. Channel values count in 1/255, those of 16 bits in
/// parts of that. Shares and means are over the pixels that are compared, which are all but the ignored ones.
struct ImageDifference {
  std::int64_t comparedPixels = 0;
  int channels = 3;  ///< compared: 3, or 4 where transparency is
  std::int64_t differingPixels = 0;
  double differingShare = 0;       ///< of the compared pixels, 0 to 1
  double level = 0;                ///< difference that a pixel may have without being counted
  std::int64_t countedPixels = 0;  ///< pixels that differ by more than `level`
  double maxAbs = 0;               ///< over all pixels and channels
  double meanAbs = 0;
  double rmse = 0;
  std::optional<double> psnr_dB;    ///< nothing when identical
  std::optional<SsimFigures> ssim;  ///< nothing below a window of 11x11
  FlipFigures flip;
  std::vector<DifferingPixel> worst;  ///< the largest first, of equal ones from the top left; ten at most

  double countedShare() const {
    return comparedPixels == 0 ? 0 : static_cast<double>(countedPixels) / static_cast<double>(comparedPixels);
  }
};

/// The figures, and what FLIP has of every pixel.
struct Comparison {
  ImageDifference difference;
  FlipMap flip;
};

/// How pictures are compared.
struct ComparisonOptions {
  double pixelsPerDegree = kFlipPixelsPerDegree;  ///< of view, for FLIP
  double level = 0;                               ///< see ImageDifference::level; 0 to 255
  const IgnoreMask* ignored = nullptr;            ///< of the pictures' size; none: nothing is left out
};

/// Compares two pictures sample by sample. Where they have four channels, FLIP and SSIM look at them upon black
/// and upon white paper, and the larger difference counts.
/// @throws core::Error(kIo) if sizes or channel counts differ: nothing is resized.
Comparison compare(const image::Image& a, const image::Image& b, const ComparisonOptions& options = {});
Comparison compare(const image::DeepImage& a, const image::DeepImage& b, const ComparisonOptions& options = {});
/// Compares pictures that are in a common form. @pre both have the same sample type, as after toCommonForm(a, b)
/// (common_form.h). @throws as compare.
Comparison compareCommon(const image::AnyImage& a, const image::AnyImage& b,
                         const ComparisonOptions& options = {});
/// Compares by value, whatever the form. @throws core::Error(kIo) if the sizes differ.
Comparison compare(image::AnyImage a, image::AnyImage b, const ComparisonOptions& options = {});

/// RGB picture of |a - b| times `factor`, cut at 255: black where equal or ignored. A difference of alpha counts
/// in all three. @throws as compare.
image::Image amplifiedDifference(const image::Image& a, const image::Image& b, const IgnoreMask* ignored = nullptr,
                                 int factor = 16);
image::Image amplifiedDifference(image::AnyImage a, image::AnyImage b, const IgnoreMask* ignored = nullptr,
                                 int factor = 16);

}  // namespace poinsot::compare
