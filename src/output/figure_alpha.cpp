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

/// Alpha and ink, in encoded values, for a pixel that light mixed of `ink` and paper by alpha a:
///   wanted = encoding of (a ink + (1 - a) paper)
///   a'   = sum (paper - wanted)(paper - ink) / sum (paper - ink)^2     over the three channels: nearest with that
///   ink ink' = paper + (wanted - paper) / a'                               exact, and about that ink
/// Where ink' would be no colour, a' is as much larger as it must be.
class AlphaFit {
 public:
  explicit AlphaFit(const draw::Color& paper) : paper_(paper) {}

  const Pixel& operator()(const Pixel& pixel) {
    if (pixel != last_) {
      last_ = pixel;
      fit_ = fitted(pixel);
    }
    return fit_;
  }

 private:
  struct Channel {
    double paper, ink, wanted;  ///< 0 to 255
    /// The least alpha with which some ink does it.
    double leastAlpha() const {
      const double room = wanted > paper ? 255 - paper : paper;
      return room > 0 ? std::abs(wanted - paper) / room : 0;
    }
  };

  std::array<Channel, 3> channelsOf(const Pixel& pixel) const {
    const float alpha = static_cast<float>(pixel[3]) / 255.0f;
    std::array<Channel, 3> channels{};
    for (std::size_t c = 0; c < 3; ++c) {
      const float under = paper_[static_cast<glm::length_t>(c)];
      const float mixed = alpha * draw::linearFromSrgb8(pixel[c]) + (1 - alpha) * under;
      channels[c] = {static_cast<double>(draw::srgb8FromLinear(under)), static_cast<double>(pixel[c]),
                     static_cast<double>(draw::srgb8FromLinear(mixed))};
    }
    return channels;
  }

  Pixel fitted(const Pixel& pixel) const {
    const auto channels = channelsOf(pixel);
    double along = 0, square = 0, least = 0;
    for (const Channel& c : channels) {
      along += (c.paper - c.wanted) * (c.paper - c.ink);
      square += (c.paper - c.ink) * (c.paper - c.ink);
      least = std::max(least, c.leastAlpha());
    }
    if (square == 0) return pixel;  // ink of the paper's own colour
    const double alpha = std::ceil(255 * std::clamp(along / square, least, 1.0)) / 255;
    Pixel fit{0, 0, 0, static_cast<std::uint8_t>(std::lround(255 * alpha))};
    for (std::size_t i = 0; alpha > 0 && i < 3; ++i) {
      const double ink = channels[i].paper + (channels[i].wanted - channels[i].paper) / alpha;
      fit[i] = static_cast<std::uint8_t>(std::lround(std::clamp(ink, 0.0, 255.0)));
    }
    return fit;
  }

  draw::Color paper_;
  Pixel last_{};  // flat areas ask for the same again and again; without alpha nothing is asked
  Pixel fit_{};
};

}  // namespace

void fitAlpha(image::Image& picture, const draw::Color& paper) {
  POINSOT_EXPECT(picture.channels == 4);
  AlphaFit fit(paper);
  for (std::size_t i = 0; i < picture.pixels.size(); i += 4) {
    Pixel pixel;
    std::memcpy(pixel.data(), picture.pixels.data() + i, pixel.size());
    if (pixel[3] > 0 && pixel[3] < 255) std::memcpy(picture.pixels.data() + i, fit(pixel).data(), pixel.size());
  }
}

}  // namespace poinsot::output
