// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "image/image.h"

namespace poinsot::output {

/// Planes to write to. Luma and alpha have the picture's size; alpha may be null. Chroma has the same size, or
/// half the width and half the height. Strides are in bytes.
struct YuvPlanes {
  std::uint8_t* y = nullptr;
  std::uint8_t* cb = nullptr;
  std::uint8_t* cr = nullptr;
  std::ptrdiff_t yStride = 0;
  std::ptrdiff_t cbStride = 0;
  std::ptrdiff_t crStride = 0;
  std::uint8_t* alpha = nullptr;
  std::ptrdiff_t alphaStride = 0;
};

/// Converts sRGB bytes to Y'CbCr 4:2:0, BT.709, limited range (Y 16..235, Cb and Cr 16..240). Ignores alpha.
///   Y = 16 + 219 (0.2126 R + 0.7152 G + 0.0722 B),
///   Cb = 128 + 224 (B - Y') / 1.8556,  Cr = 128 + 224 (R - Y') / 1.5748,
/// with R, G, B in [0, 1] and Y' the bracket of Y. Arithmetic is in integers, rounded to nearest, so that every
/// machine computes the same bytes. They differ from the formula by at most 0.5 + 3e-4.
/// Chroma is placed at H.264's default position ("left": on even columns, half-way between two rows). Each sample
/// is the mean of two rows over the columns 2x-1, 2x and 2x+1 with weights 1/4, 1/2, 1/4. Column 0 replaces column
/// -1.
/// @pre even width and height.
void convertToYuv420(const image::Image& picture, const YuvPlanes& planes);
/// Updates the planes of an earlier picture that differs only in `part`. Converts the samples that depend on
/// pixels of `part`, and a few samples next to them.
/// @pre the part lies within the picture.
void convertPartToYuv420(const image::Image& picture, const YuvPlanes& planes, const image::PixelRect& part);

/// Converts to 4:4:4 by the formula of convertToYuv420(). With 10 bits, results are four times as large. A plane
/// for alpha, if there is one, has the full range; for an opaque picture, all its bits are ones.
/// @param bits  8, or 10 (`planes` then point to 16-bit samples).
void convertToYuv444(const image::Image& picture, const YuvPlanes& planes, int bits);

/// Converts to 4:2:0 with alpha. Chroma is also weighted by alpha, so that the colours of transparent pixels do
/// not appear at the edges of opaque ones. Where all pixels are transparent, chroma is grey.
/// @pre even width and height, 4 channels.
void convertToYuva420(const image::Image& picture, const YuvPlanes& planes);

/// Converts like convertToYuv420(), one sample at a time. Tests compare the fast code with it.
void convertToYuv420Scalar(const image::Image& picture, const YuvPlanes& planes);

}  // namespace poinsot::output
