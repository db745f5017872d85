// SPDX-License-Identifier: Apache-2.0
#include "image/image.h"

#include <algorithm>

#include "core/expect.h"

namespace poinsot::image {
namespace {

std::size_t sampleCount(PixelSize size, int channels) {
  POINSOT_EXPECT(size.width > 0 && size.height > 0);
  POINSOT_EXPECT(channels == 3 || channels == 4);
  return static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) *
         static_cast<std::size_t>(channels);
}

template <typename Sample>
std::size_t offset(const BasicImage<Sample>& image, int x, int y) {
  POINSOT_EXPECT(x >= 0 && x < image.size.width && y >= 0 && y < image.size.height);
  return static_cast<std::size_t>(y) * image.rowSamples() +
         static_cast<std::size_t>(x) * static_cast<std::size_t>(image.channels);
}

}  // namespace

template <typename Sample>
BasicImage<Sample>::BasicImage(PixelSize imageSize, int channelCount)
    : size(imageSize), channels(channelCount), pixels(sampleCount(imageSize, channelCount)) {}

template <typename Sample>
Sample* BasicImage<Sample>::at(int x, int y) {
  return pixels.data() + offset(*this, x, y);
}

template <typename Sample>
const Sample* BasicImage<Sample>::at(int x, int y) const {
  return pixels.data() + offset(*this, x, y);
}

template struct BasicImage<std::uint8_t>;
template struct BasicImage<std::uint16_t>;

DeepImage deepened(const AnyImage& picture) {
  if (const auto* deep = std::get_if<DeepImage>(&picture)) return *deep;
  const Image& flat = std::get<Image>(picture);
  DeepImage out(flat.size, flat.channels);
  constexpr int kRepeated = 257;
  std::transform(flat.pixels.begin(), flat.pixels.end(), out.pixels.begin(),
                 [](std::uint8_t v) { return static_cast<std::uint16_t>(kRepeated * v); });
  return out;
}

}  // namespace poinsot::image
