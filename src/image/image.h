// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace poinsot::image {

/// Width and height of a picture in pixels.
struct PixelSize {
  int width = 0;
  int height = 0;
  friend bool operator==(const PixelSize&, const PixelSize&) = default;
};

/// 8-bit sRGB pixels, row 0 at the top, 3 (RGB) or 4 (RGBA, straight alpha) channels, rows without padding.
struct Image {
  PixelSize size;
  int channels = 3;
  std::vector<std::uint8_t> pixels;

  Image() = default;
  /// All bytes zero. @pre width, height > 0, channels 3 or 4.
  Image(PixelSize size, int channels);

  /// First byte of pixel (x, y). @pre inside the picture.
  std::uint8_t* at(int x, int y);
  const std::uint8_t* at(int x, int y) const;
  std::size_t rowBytes() const { return static_cast<std::size_t>(size.width) * static_cast<std::size_t>(channels); }

  friend bool operator==(const Image&, const Image&) = default;
};

}  // namespace poinsot::image
