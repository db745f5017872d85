// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "image/image.h"

namespace poinsot::output {

/// Destination planes. Luma and alpha (if any) have the picture's size; chroma has the same size, or half the
/// width and half the height. Strides are in bytes.
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

/// Converts sRGB bytes to Y'CbCr 4:2:0, BT.709, limited range (Y 16..235, Cb and Cr 16..240). Alpha is ignored.
///   Y = 16 + 219 (0.2126 R + 0.7152 G + 0.0722 B),
///   Cb = 128 + 224 (B - Y') / 1.8556,  Cr = 128 + 224 (R - Y') / 1.5748,
/// with R, G, B in [0, 1] and Y' the bracket of Y. Integer arithmetic, rounded to nearest, gives the same bytes on
/// every machine, at most 0.5 + 3e-4 from the formula.
/// Chroma is sited as H.264 has it by default ("left": on even columns, half-way between two rows). Each sample is
/// the mean of both rows over the columns 2x-1, 2x, 2x+1 with weights 1/4, 1/2, 1/4; column 0 stands in for -1.
/// @pre even width and height.
void convertToYuv420(const image::Image& picture, const YuvPlanes& planes);
/// Updates planes that hold another picture: converts the samples that depend on pixels of `part`, and at most a
/// few beside them.
/// @pre the part lies within the picture.
void convertPartToYuv420(const image::Image& picture, const YuvPlanes& planes, const image::PixelRect& part);

/// Converts to 4:4:4 by the formula of convertToYuv420(), times 4 for 10 bits. A plane for alpha, if there is one,
/// gets the full range, all ones for an opaque picture.
/// @param bits  8, or 10 (`planes` then point to 16-bit samples).
void convertToYuv444(const image::Image& picture, const YuvPlanes& planes, int bits);

/// Converts to 4:2:0 with alpha. Chroma is also weighted by alpha, so that transparent pixels do not tinge the
/// edges of opaque ones. Where all pixels are transparent, chroma is grey.
/// @pre even width and height, 4 channels.
void convertToYuva420(const image::Image& picture, const YuvPlanes& planes);

/// Converts like convertToYuv420(), one sample at a time, as a reference for its test.
void convertToYuv420Scalar(const image::Image& picture, const YuvPlanes& planes);

}  // namespace poinsot::output
