// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

#include "image/image.h"

namespace poinsot::image {

enum class Verdict { kIdentical, kNear, kDifferent };

/// "identical", "near", "different".
std::string_view toString(Verdict verdict);

/// How two pictures of the same size and channel count differ. Channel values count in 1/255.
struct ImageDifference {
  std::int64_t differingPixels = 0;
  double differingShare = 0;  ///< of all pixels, 0 to 1
  int maxAbs = 0;             ///< over all pixels and channels
  double meanAbs = 0;
  double psnr_dB = 0;  ///< infinite when identical
  double flipMean = 0;
  double flipMax = 0;
  int worstX = 0;  ///< the first pixel with maxAbs; 0, 0 when identical
  int worstY = 0;
};

/// Limits for two pictures of one scene from two driver versions or processors: all of them must hold, none alone
/// is enough (a missing facet has a small mean, a whole picture one level brighter a small maximum).
struct NearRule {
  int maxAbs = 2;
  double differingShare = 0.005;
  double flipMean = 1e-3;
  double flipMax = 0.05;
};

/// @throws core::Error(kIo) if sizes or channel counts differ: that is no difference of pixels, and nothing is
/// resized.
ImageDifference compare(const Image& a, const Image& b);

Verdict verdict(const ImageDifference& difference, const NearRule& rule = {});

/// RGB picture of |a - b| times `factor`, cut at 255: black where equal.
/// @throws as compare.
Image amplifiedDifference(const Image& a, const Image& b, int factor = 16);

}  // namespace poinsot::image
