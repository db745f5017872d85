// SPDX-License-Identifier: Apache-2.0
#include "figure/alpha.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace poinsot::figure {
namespace {

using Pixel = std::array<int, 4>;

/// Returns the light of an encoded value, by the formula of IEC 61966-2-1.
double light(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}
double encoded(double light) {
  return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

Pixel fitted(const Pixel& pixel, const draw::Color& paper) {
  image::Image one({1, 1}, 4);
  for (std::size_t c = 0; c < 4; ++c) one.pixels[c] = static_cast<std::uint8_t>(pixel[c]);
  fitAlpha(one, paper);
  Pixel result;
  for (std::size_t c = 0; c < 4; ++c) result[c] = one.pixels[c];
  return result;
}

/// Returns how far, of 255, a viewer's mix over the paper is from the mix of light, in the worst channel.
double error(const Pixel& drawn, const Pixel& fit, double paper) {
  double worst = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double a = drawn[3] / 255.0, b = fit[3] / 255.0;
    const double wanted = encoded(a * light(drawn[c] / 255.0) + (1 - a) * light(paper));
    worst = std::max(worst, std::abs(b * fit[c] / 255.0 + (1 - b) * paper - wanted));
  }
  return 255 * worst;
}

TEST(FitAlpha, MatchesHandValuesOnBlackAndWhite) {
  // 127/255 of the light is 187 of 255 when encoded, 128/255 of it 188.
  EXPECT_EQ(fitted({0, 0, 0, 128}, draw::Color(1)), (Pixel{0, 0, 0, 68}));
  EXPECT_EQ(fitted({255, 255, 255, 128}, draw::Color(0)), (Pixel{255, 255, 255, 188}));
}

// With 16 bits, by hand: 32768/65535 of the light is 48191.3 of 65535, so that 17343.7 are dark.
TEST(FitAlpha, MatchesHandValuesForSixteenBits) {
  image::DeepImage pixel({1, 1}, 4);
  pixel.pixels = {0, 0, 0, 32768};
  fitAlpha(pixel, draw::Color(1));
  EXPECT_EQ(pixel.pixels, (std::vector<std::uint16_t>{0, 0, 0, 17344}));
  const std::vector<std::uint16_t> whole{1, 2, 3, 65535};
  pixel.pixels = whole;
  fitAlpha(pixel, draw::Color(1));
  EXPECT_EQ(pixel.pixels, whole);
  pixel.pixels = {9, 8, 7, 0};
  fitAlpha(pixel, draw::Color(1));
  EXPECT_EQ(pixel.pixels, (std::vector<std::uint16_t>{0, 0, 0, 0}));
}

TEST(FitAlpha, KeepsOpaquePixelsAndInkOfThePapersColour) {
  for (const Pixel& p : {Pixel{1, 2, 3, 255}, Pixel{255, 255, 255, 77}}) EXPECT_EQ(fitted(p, draw::Color(1)), p);
}

TEST(FitAlpha, ClearsColoursOfInvisiblePixels) {
  for (const float paper : {0.0f, 1.0f}) EXPECT_EQ(fitted({200, 90, 10, 0}, draw::Color(paper)), Pixel{});
}

// Measured, the worst of 2000: 0.970 of 255, from rounding twice.
TEST(FitAlpha, GivesGreysTheLookOfLinearBlending) {
  std::mt19937 random(7);
  for (int i = 0; i < 2000; ++i) {
    const int grey = static_cast<int>(random() % 256), alpha = static_cast<int>(random() % 256);
    for (const int paper : {255, 24}) {
      const Pixel drawn{grey, grey, grey, alpha};
      if (std::abs(grey - paper) < 8) continue;
      EXPECT_LE(error(drawn, fitted(drawn, draw::Color(draw::linearFromSrgb8(static_cast<std::uint8_t>(paper)))),
                      paper / 255.0),
                1.1)
          << grey << ' ' << alpha << " on " << paper;
    }
  }
}

// Glass and edges have colours of the palette, at every alpha. Measured, of 255: over their own paper at most 0.82
// off (73.2 with the alpha as drawn). From half alpha on, the ink itself is at most 39 off its colour, so that
// other paper shows no fringe.
TEST(FitAlpha, GivesColoursTheLookOfLinearBlending) {
  const std::array<Pixel, 3> palette{{{0xd5, 0x5e, 0x00, 0}, {0x00, 0x72, 0xb2, 0}, {0x00, 0x9e, 0x73, 0}}};
  for (Pixel drawn : palette) {
    double fit = 0, asDrawn = 0;
    int shift = 0;
    for (drawn[3] = 1; drawn[3] < 255; ++drawn[3]) {
      const Pixel refitted = fitted(drawn, draw::Color(1));
      fit = std::max(fit, error(drawn, refitted, 1));
      asDrawn = std::max(asDrawn, error(drawn, drawn, 1));
      for (std::size_t c = 0; drawn[3] >= 128 && c < 3; ++c)
        shift = std::max(shift, std::abs(refitted[c] - drawn[c]));
    }
    EXPECT_LT(fit, 1.1);
    EXPECT_GT(asDrawn, 70);
    EXPECT_LE(shift, 42);
  }
}

}  // namespace
}  // namespace poinsot::figure
