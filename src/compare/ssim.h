// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "compare/ignore_mask.h"
#include "image/image.h"

namespace poinsot::compare {

/// Structural similarity: 1 for equal pictures, at least -1.
struct SsimFigures {
  double mean = 1;
  double worst = 1;            ///< smallest value of all windows
  int worstX = 0, worstY = 0;  ///< centre of the first such window
};

/// Returns the SSIM of two pictures' luma (0.299, 0.587, 0.114 of the encoded values), with Gaussian windows of
/// 11x11 pixels (σ = 1.5) that lie inside the picture, K1 = 0.01, K2 = 0.03. Returns nullopt if the pictures are
/// smaller than a window, or if no window counts.
/// @pre same size.
/// Source: Wang, Bovik, Sheikh, Simoncelli, "Image Quality Assessment: From Error Visibility to Structural
/// Similarity", IEEE Trans. Image Processing 13(4), 2004.
/// @param ignored  mask of the pictures' size; windows with an ignored centre do not count. Null if all count
std::optional<SsimFigures> ssim(const image::Image& a, const image::Image& b, const IgnoreMask* ignored = nullptr);
std::optional<SsimFigures> ssim(const image::DeepImage& a, const image::DeepImage& b,
                                const IgnoreMask* ignored = nullptr);

}  // namespace poinsot::compare
