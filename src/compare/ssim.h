// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "compare/ignore_mask.h"
#include "image/image.h"

namespace poinsot::compare {

/// Structural similarity (SSIM) of two pictures: 1 for equal pictures, at least -1.
struct SsimFigures {
  double mean = 1;
  double worst = 1;            ///< smallest SSIM of all windows
  int worstX = 0, worstY = 0;  ///< centre of the first window with the smallest SSIM
};

/// Returns the SSIM of the luma of two pictures; nullopt if they are smaller than a window, or if no window
/// counts. Luma is 0.299 R + 0.587 G + 0.114 B of the encoded values. Windows have 11x11 pixels with Gaussian
/// weights (σ = 1.5) and lie inside the picture. K1 = 0.01, K2 = 0.03.
/// @pre same size.
/// Source: Wang, Bovik, Sheikh, Simoncelli, "Image Quality Assessment: From Error Visibility to Structural
/// Similarity", IEEE Trans. Image Processing 13(4), 2004.
/// @param ignored  mask of the pictures' size; windows with an ignored centre do not count. Null if all count
std::optional<SsimFigures> ssim(const image::Image& a, const image::Image& b, const IgnoreMask* ignored = nullptr);
std::optional<SsimFigures> ssim(const image::DeepImage& a, const image::DeepImage& b,
                                const IgnoreMask* ignored = nullptr);

}  // namespace poinsot::compare
