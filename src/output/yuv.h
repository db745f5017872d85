// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "image/image.h"

namespace poinsot::output {

/// Planes to be filled: luma, and alpha where there is one, of the picture's size; chroma of that too, or of half
/// the width and half the height. Strides in bytes.
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

/// Y'CbCr 4:2:0, BT.709, limited range (Y 16..235, Cb and Cr 16..240), from sRGB bytes; alpha is left out.
///   Y = 16 + 219 (0.2126 R + 0.7152 G + 0.0722 B),  Cb = 128 + 224 (B - Y') / 1.8556,  Cr = 128 + 224 (R - Y')
///   / 1.5748
/// with R, G, B in [0, 1] and Y' the bracket of Y. Integer arithmetic, rounded to nearest: the same bytes on every
/// machine, at most 0.5 + 3e-4 from the formula.
/// Chroma is sited as H.264 has it by default ("left": on even columns, half-way between two rows), so each sample
/// is the mean of both rows over the columns 2x-1, 2x, 2x+1 with weights 1/4, 1/2, 1/4; column 0 stands in for -1.
/// @pre even width and height.
void convertToYuv420(const image::Image& picture, const YuvPlanes& planes);
/// Of planes that hold another picture: what depends on pixels of that part, and no more than a few beside it.
/// @pre the part lies within the picture.
void convertPartToYuv420(const image::Image& picture, const YuvPlanes& planes, const image::PixelRect& part);

/// Chroma and luma for each pixel, in 8 or in 10 bits (`planes` then point to 16-bit samples), and alpha where
/// there is a plane for it: full range, of an opaque picture all ones. The formula above, times 4 in 10 bits.
void convertToYuv444(const image::Image& picture, const YuvPlanes& planes, int bits);

/// 4:2:0 with alpha. Chroma is the mean weighed by alpha besides, so that what is not there does not tinge the
/// edge of what is; where nothing is, it is grey.
/// @pre even width and height, 4 channels.
void convertToYuva420(const image::Image& picture, const YuvPlanes& planes);

/// The same as convertToYuv420, one sample at a time: what the fast one is tested against.
void convertToYuv420Scalar(const image::Image& picture, const YuvPlanes& planes);

}  // namespace poinsot::output
