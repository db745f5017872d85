// SPDX-License-Identifier: Apache-2.0
#include "image/image.h"

#include "core/expect.h"

namespace poinsot::image {
namespace {

std::size_t byteCount(PixelSize size, int channels) {
  POINSOT_EXPECT(size.width > 0 && size.height > 0);
  POINSOT_EXPECT(channels == 3 || channels == 4);
  return static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) *
         static_cast<std::size_t>(channels);
}

std::size_t offset(const Image& image, int x, int y) {
  POINSOT_ASSERT(x >= 0 && x < image.size.width && y >= 0 && y < image.size.height);
  return static_cast<std::size_t>(y) * image.rowBytes() +
         static_cast<std::size_t>(x) * static_cast<std::size_t>(image.channels);
}

}  // namespace

Image::Image(PixelSize imageSize, int channelCount)
    : size(imageSize), channels(channelCount), pixels(byteCount(imageSize, channelCount)) {}

std::uint8_t* Image::at(int x, int y) { return pixels.data() + offset(*this, x, y); }

const std::uint8_t* Image::at(int x, int y) const { return pixels.data() + offset(*this, x, y); }

}  // namespace poinsot::image
