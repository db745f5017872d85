// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <variant>
#include <vector>

#include "core/abi.h"

namespace poinsot::image {

struct PixelSize {
  int width = 0;
  int height = 0;
  friend bool operator==(const PixelSize&, const PixelSize&) = default;
};

/// Rectangle of pixels. The column `right` and the row `bottom` are outside.
struct PixelRect {
  int left = 0, top = 0, right = 0, bottom = 0;
  bool empty() const { return right <= left || bottom <= top; }
  friend bool operator==(const PixelRect&, const PixelRect&) = default;
};
inline PixelRect wholeOf(PixelSize size) { return {0, 0, size.width, size.height}; }

/// sRGB picture with 3 (RGB) or 4 (RGBA, straight alpha) channels. Row 0 is at the top; rows have no padding.
template <typename Sample>
struct BasicImage {
  /// Largest value of a sample: full light in a colour channel, opaque in the alpha channel.
  static constexpr Sample kMost = std::numeric_limits<Sample>::max();

  PixelSize size;
  int channels = 3;
  std::vector<Sample> pixels;

  BasicImage() = default;
  /// Creates a picture whose samples are all 0. @pre width, height > 0, channels 3 or 4.
  BasicImage(PixelSize size, int channels);

  /// Returns the first sample of pixel (x, y). @pre inside the picture.
  Sample* at(int x, int y);
  const Sample* at(int x, int y) const;
  std::size_t rowSamples() const {
    return static_cast<std::size_t>(size.width) * static_cast<std::size_t>(channels);
  }
  std::size_t rowBytes() const { return rowSamples() * sizeof(Sample); }

  friend bool operator==(const BasicImage&, const BasicImage&) = default;
};

using Image = BasicImage<std::uint8_t>;
/// Picture with 16 bits per sample. The finer steps avoid bands in gradients that are processed further.
using DeepImage = BasicImage<std::uint16_t>;
using AnyImage = std::variant<Image, DeepImage>;

extern template struct BasicImage<std::uint8_t>;
extern template struct BasicImage<std::uint16_t>;

/// Returns the picture with 16 bits per sample. The 8-bit value v becomes 257 v.
DeepImage deepened(const AnyImage& picture);

}  // namespace poinsot::image
