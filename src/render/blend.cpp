// SPDX-License-Identifier: Apache-2.0
#include "render/blend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "core/expect.h"

namespace poinsot::render {
namespace {

/// Blends one colour into pixels. Caches the last result, because pixels of a flat area often have the same value.
template <typename Sample>
class Blender {
 public:
  Blender(const draw::Color& color, float opacity, int channels)
      : color_(color), opacity_(opacity), channels_(static_cast<std::size_t>(channels)) {}

  void blend(Sample* pixel, std::uint8_t coverage) {
    if (coverage != coverage_ || !std::equal(pixel, pixel + channels_, under_.begin())) remember(pixel, coverage);
    std::copy_n(blended_.begin(), channels_, pixel);
  }

 private:
  void remember(const Sample* pixel, std::uint8_t coverage) {
    coverage_ = coverage;
    std::copy_n(pixel, channels_, under_.begin());
    const float share = opacity_ * static_cast<float>(coverage) / 255.0f;
    const float below = channels_ == 4 ? static_cast<float>(under_[3]) / kMost : 1.0f;
    const float alpha = share + below * (1 - share);
    if (alpha <= 0) {
      blended_ = under_;
      return;
    }
    for (std::size_t c = 0; c < 3; ++c) {
      const float under = draw::linearFromSrgb(under_[c]);
      const float over = color_[static_cast<glm::length_t>(c)];
      blended_[c] = draw::srgbFromLinear<Sample>((over * share + under * below * (1 - share)) / alpha);
    }
    blended_[3] = static_cast<Sample>(std::lround(alpha * kMost));
  }

  static constexpr float kMost = image::BasicImage<Sample>::kMost;

  draw::Color color_;
  float opacity_;
  std::size_t channels_;
  // coverage of the cached pixel; 0 if nothing is cached, because pixels of coverage 0 are not blended
  std::uint8_t coverage_ = 0;
  std::array<Sample, 4> under_{}, blended_{};
};

// Tests eight coverage bytes at once, because most of a map is empty.
bool nextEightEmpty(const std::uint8_t* coverage) {
  std::uint64_t eight = 0;
  std::memcpy(&eight, coverage, sizeof(eight));
  return eight == 0;
}

/// Calls use(pixel, coverage) for every covered pixel. Returns the map's bounds, clipped to the picture.
template <typename Sample, class Use>
PixelBounds forEachCovered(const text::CoverageMap& map, image::BasicImage<Sample>& picture, Use use) {
  const int left = std::max(map.left, 0), right = std::min(map.left + map.width, picture.size.width);
  const int bottom = std::min(map.top + map.height, picture.size.height);
  for (int y = std::max(map.top, 0); y < bottom; ++y) {
    const std::uint8_t* row = map.values.data() + static_cast<std::ptrdiff_t>(y - map.top) * map.width;
    for (int x = left; x < right; ++x) {
      const std::uint8_t* coverage = row + (x - map.left);
      if (*coverage)
        use(picture.at(x, y), *coverage);
      else if (x + 8 <= right && nextEightEmpty(coverage))
        x += 7;
    }
  }
  return {static_cast<float>(left), static_cast<float>(std::max(map.top, 0)), static_cast<float>(right),
          static_cast<float>(bottom)};
}

}  // namespace

template <typename Sample>
PixelBounds blendCoverage(const text::CoverageMap& map, const draw::Color& color, float opacity,
                          image::BasicImage<Sample>& picture) {
  Blender<Sample> blender(color, opacity, picture.channels);
  return forEachCovered(map, picture,
                        [&](Sample* pixel, std::uint8_t coverage) { blender.blend(pixel, coverage); });
}

template <typename Sample>
PixelBounds eraseCoverage(const text::CoverageMap& map, float opacity, image::BasicImage<Sample>& picture) {
  POINSOT_EXPECT(picture.channels == 4);
  return forEachCovered(map, picture, [&](Sample* pixel, std::uint8_t coverage) {
    const float left = 1 - opacity * static_cast<float>(coverage) / 255.0f;
    pixel[3] = static_cast<Sample>(std::lround(left * static_cast<float>(pixel[3])));
  });
}

template PixelBounds blendCoverage(const text::CoverageMap&, const draw::Color&, float, image::Image&);
template PixelBounds blendCoverage(const text::CoverageMap&, const draw::Color&, float, image::DeepImage&);
template PixelBounds eraseCoverage(const text::CoverageMap&, float, image::Image&);
template PixelBounds eraseCoverage(const text::CoverageMap&, float, image::DeepImage&);

}  // namespace poinsot::render
