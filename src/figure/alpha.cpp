// SPDX-License-Identifier: Apache-2.0
#include "figure/alpha.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/expect.h"

namespace poinsot::figure {
namespace {

/// Computes alpha and ink, in encoded values, for a translucent pixel. The pixel mixes `ink` and paper in linear
/// light, with alpha a. Programs that show it mix encoded values instead.
///   wanted = encoding of (a ink + (1 - a) paper)
///   a'   = sum (paper - wanted)(paper - ink) / sum (paper - ink)^2   over the three channels
///   ink' = paper + (wanted - paper) / a'
/// With a', mixing the original ink comes as close as possible to the wanted colour. Mixing ink', which is close
/// to the original ink, gives it exactly. If ink' is outside the range of colours, a' is increased.
template <typename Sample>
class AlphaFit {
 public:
  using Pixel = std::array<Sample, 4>;

  explicit AlphaFit(const draw::Color& paper) : paper_(paper) {}

  const Pixel& operator()(const Pixel& pixel) {
    if (pixel != last_) {
      last_ = pixel;
      fit_ = fitted(pixel);
    }
    return fit_;
  }

 private:
  static constexpr double kMost = image::BasicImage<Sample>::kMost;

  struct Channel {
    double paper, ink, wanted;  ///< values from 0 to kMost
    /// Returns the least alpha with which some ink gives the wanted value.
    double leastAlpha() const {
      const double room = wanted > paper ? kMost - paper : paper;
      return room > 0 ? std::abs(wanted - paper) / room : 0;
    }
  };

  std::array<Channel, 3> channelsOf(const Pixel& pixel) const {
    const float alpha = static_cast<float>(pixel[3]) / static_cast<float>(kMost);
    std::array<Channel, 3> channels{};
    for (std::size_t c = 0; c < 3; ++c) {
      const float under = paper_[static_cast<glm::length_t>(c)];
      const float mixed = alpha * draw::linearFromSrgb(pixel[c]) + (1 - alpha) * under;
      channels[c] = {static_cast<double>(draw::srgbFromLinear<Sample>(under)), static_cast<double>(pixel[c]),
                     static_cast<double>(draw::srgbFromLinear<Sample>(mixed))};
    }
    return channels;
  }

  Pixel fitted(const Pixel& pixel) const {
    if (pixel[3] == 0) return {};
    const auto channels = channelsOf(pixel);
    double along = 0, square = 0, least = 0;
    for (const Channel& c : channels) {
      along += (c.paper - c.wanted) * (c.paper - c.ink);
      square += (c.paper - c.ink) * (c.paper - c.ink);
      least = std::max(least, c.leastAlpha());
    }
    if (square == 0) return pixel;  // the ink is the colour of the paper
    const double alpha = std::ceil(kMost * std::clamp(along / square, least, 1.0)) / kMost;
    Pixel fit{0, 0, 0, static_cast<Sample>(std::lround(kMost * alpha))};
    for (std::size_t i = 0; alpha > 0 && i < 3; ++i) {
      const double ink = channels[i].paper + (channels[i].wanted - channels[i].paper) / alpha;
      fit[i] = static_cast<Sample>(std::lround(std::clamp(ink, 0.0, kMost)));
    }
    return fit;
  }

  draw::Color paper_;
  // Last pixel and its result. Flat areas have many equal pixels.
  Pixel last_{};
  Pixel fit_{};
};

}  // namespace

template <typename Sample>
void fitAlpha(image::BasicImage<Sample>& picture, const draw::Color& paper) {
  POINSOT_EXPECT(picture.channels == 4);
  AlphaFit<Sample> fit(paper);
  for (auto at = picture.pixels.begin(); at != picture.pixels.end(); at += 4) {
    typename AlphaFit<Sample>::Pixel pixel;
    std::copy_n(at, 4, pixel.begin());
    if (pixel[3] < picture.kMost) std::copy_n(fit(pixel).begin(), 4, at);
  }
}

template void fitAlpha(image::Image&, const draw::Color&);
template void fitAlpha(image::DeepImage&, const draw::Color&);

}  // namespace poinsot::figure
