// SPDX-License-Identifier: Apache-2.0
#include "output/figure_alpha.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "core/expect.h"

namespace poinsot::output {
namespace {

using Pixel = std::array<std::uint8_t, 4>;

/// The alpha a' for which a' ink + (1 - a') paper, all encoded, is nearest to the encoding of a ink + (1 - a)
/// paper in light, over the three channels together:
///   a' = sum (paper - wanted)(paper - ink) / sum (paper - ink)^2
class AlphaFit {
 public:
  explicit AlphaFit(const draw::Color& paper) : paper_(paper) {}

  std::uint8_t operator()(const Pixel& pixel) {
    if (pixel != last_) {
      last_ = pixel;
      alpha_ = fitted(pixel);
    }
    return alpha_;
  }

 private:
  std::uint8_t fitted(const Pixel& pixel) const {
    const float alpha = static_cast<float>(pixel[3]) / 255.0f;
    double along = 0, square = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const float under = paper_[static_cast<glm::length_t>(c)];
      const double paper = draw::srgb8FromLinear(under);
      const double wanted = draw::srgb8FromLinear(alpha * draw::linearFromSrgb8(pixel[c]) + (1 - alpha) * under);
      along += (paper - wanted) * (paper - pixel[c]);
      square += (paper - pixel[c]) * (paper - pixel[c]);
    }
    if (square == 0) return pixel[3];  // ink of the paper's own colour
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(along / square, 0.0, 1.0)));
  }

  draw::Color paper_;
  Pixel last_{};  // flat areas ask for the same again and again; without alpha nothing is asked
  std::uint8_t alpha_ = 0;
};

}  // namespace

void fitAlpha(image::Image& picture, const draw::Color& paper) {
  POINSOT_EXPECT(picture.channels == 4);
  AlphaFit fit(paper);
  for (std::size_t i = 0; i < picture.pixels.size(); i += 4) {
    Pixel pixel;
    std::memcpy(pixel.data(), picture.pixels.data() + i, pixel.size());
    if (pixel[3] > 0 && pixel[3] < 255) picture.pixels[i + 3] = fit(pixel);
  }
}

}  // namespace poinsot::output
