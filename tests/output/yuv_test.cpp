// SPDX-License-Identifier: Apache-2.0
// Expected values: ITU-R BT.709 (3.2 to 3.5) and its 8-bit limited range in double precision, and the chroma
// filter by its definition in yuv.h.
#include "output/yuv.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace poinsot::output {
namespace {

using image::Image;

struct Converted {
  int width = 0;
  std::vector<std::uint8_t> y, cb, cr;
  friend bool operator==(const Converted&, const Converted&) = default;
};

template <class Convert>
Converted converted(const Image& picture, Convert convert) {
  const auto luma = static_cast<std::size_t>(picture.size.width * picture.size.height);
  Converted out{picture.size.width, std::vector<std::uint8_t>(luma), std::vector<std::uint8_t>(luma / 4),
                std::vector<std::uint8_t>(luma / 4)};
  convert(picture, YuvPlanes{out.y.data(), out.cb.data(), out.cr.data(), out.width, out.width / 2, out.width / 2});
  return out;
}

Image noise(image::PixelSize size, int channels, unsigned seed) {
  Image picture(size, channels);
  std::mt19937 random(seed);
  for (auto& v : picture.pixels) v = static_cast<std::uint8_t>(random());
  return picture;
}

double luma(double r, double g, double b) { return 16 + 219 * (0.2126 * r + 0.7152 * g + 0.0722 * b) / 255; }
double blueDifference(double r, double g, double b) {
  return 128 + 224 * (b - (0.2126 * r + 0.7152 * g + 0.0722 * b)) / 1.8556 / 255;
}
double redDifference(double r, double g, double b) {
  return 128 + 224 * (r - (0.2126 * r + 0.7152 * g + 0.0722 * b)) / 1.5748 / 255;
}

/// Returns the largest distance of each of the three planes from the formula.
std::array<double, 3> errors(const Image& picture, const Converted& got) {
  std::array<double, 3> worst{};
  const int width = picture.size.width;
  for (int y = 0; y < picture.size.height; ++y)
    for (int x = 0; x < width; ++x) {
      const std::uint8_t* p = picture.at(x, y);
      worst[0] =
          std::max(worst[0], std::abs(got.y[static_cast<std::size_t>(y * width + x)] - luma(p[0], p[1], p[2])));
    }
  for (int y = 0; y < picture.size.height / 2; ++y)
    for (int x = 0; x < width / 2; ++x) {
      std::array<double, 3> mean{};
      for (std::size_t c = 0; c < 3; ++c)
        for (const int row : {2 * y, 2 * y + 1})
          mean[c] += picture.at(std::max(2 * x - 1, 0), row)[c] / 8.0 + picture.at(2 * x, row)[c] / 4.0 +
                     picture.at(2 * x + 1, row)[c] / 8.0;
      const auto i = static_cast<std::size_t>(y * (width / 2) + x);
      worst[1] = std::max(worst[1], std::abs(got.cb[i] - blueDifference(mean[0], mean[1], mean[2])));
      worst[2] = std::max(worst[2], std::abs(got.cr[i] - redDifference(mean[0], mean[1], mean[2])));
    }
  return worst;
}

// Every colour appears once, in 16 pictures of 1024 x 1024. Rounding to nearest is 0.5; measured 0.50002 (Y),
// 0.50025 (Cb) and 0.50016 (Cr).
TEST(Yuv, EqualsTheRoundedFormulaForEveryColour) {
  std::array<double, 3> worst{};
  for (int part = 0; part < 16; ++part) {
    Image picture({1024, 1024}, 3);
    for (std::size_t i = 0; i < 1024 * 1024; ++i) {
      const std::size_t colour = static_cast<std::size_t>(part) << 20 | i;
      for (std::size_t c = 0; c < 3; ++c) picture.pixels[3 * i + c] = static_cast<std::uint8_t>(colour >> (8 * c));
    }
    const auto e = errors(picture, converted(picture, convertToYuv420));
    for (std::size_t c = 0; c < 3; ++c) worst[c] = std::max(worst[c], e[c]);
  }
  for (const double w : worst) EXPECT_LE(w, 0.5003);
  RecordProperty("worst",
                 std::to_string(worst[0]) + " " + std::to_string(worst[1]) + " " + std::to_string(worst[2]));
}

TEST(Yuv, FiltersChromaAtItsSamplePositions) {
  for (const int channels : {3, 4}) {
    const Image picture = noise({510, 102}, channels, 21);
    for (const double w : errors(picture, converted(picture, convertToYuv420))) EXPECT_LE(w, 0.5003);
  }
}

// Planes hold a picture, and only the part that differs in the next picture is converted. The result must equal a
// conversion of the whole picture.
TEST(Yuv, ConvertsAPartLikeTheWholePicture) {
  std::mt19937 random(3);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  for (int trial = 0; trial < 400; ++trial) {
    const image::PixelSize size{2 * (1 + below(40)), 2 * (1 + below(10))};
    const int channels = 3 + trial % 2;
    Image picture = noise(size, channels, static_cast<unsigned>(trial));
    const Image other = noise(size, channels, static_cast<unsigned>(trial) + 1000);
    image::PixelRect part{below(size.width), below(size.height), 0, 0};
    part.right = part.left + 1 + below(size.width - part.left);
    part.bottom = part.top + 1 + below(size.height - part.top);
    const Converted got = converted(picture, [&](const Image& first, const YuvPlanes& planes) {
      convertToYuv420(first, planes);
      for (int y = part.top; y < part.bottom; ++y)
        std::copy(other.at(part.left, y), other.at(part.left, y) + channels * (part.right - part.left),
                  picture.at(part.left, y));
      convertPartToYuv420(picture, planes, part);
    });
    EXPECT_EQ(got, converted(picture, convertToYuv420Scalar)) << size.width << "x" << size.height;
  }
}

TEST(Yuv, FastCodeEqualsScalarCodeForEveryWidth) {
  for (int width = 2; width <= 66; width += 2)
    for (const int channels : {3, 4}) {
      const Image picture = noise({width, 6}, channels, static_cast<unsigned>(width));
      EXPECT_EQ(converted(picture, convertToYuv420), converted(picture, convertToYuv420Scalar))
          << width << " " << channels;
    }
}

TEST(Yuv, IgnoresAlpha) {
  const Image opaque = noise({32, 8}, 4, 22);
  Image other = opaque;
  for (std::size_t i = 3; i < other.pixels.size(); i += 4) other.pixels[i] ^= 0xff;
  EXPECT_EQ(converted(opaque, convertToYuv420), converted(other, convertToYuv420));
}

TEST(Yuv, KeepsGreysGrey) {
  Image picture({512, 2}, 3);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
    picture.pixels[i] = static_cast<std::uint8_t>(i % 1536 / 6);
  const Converted got = converted(picture, convertToYuv420);
  EXPECT_EQ(got.cb, std::vector<std::uint8_t>(256, 128));
  EXPECT_EQ(got.cr, std::vector<std::uint8_t>(256, 128));
  EXPECT_EQ(got.y.front(), 16);  // black
  EXPECT_EQ(got.y.back(), 235);  // white
}

// The primaries in 8-bit limited BT.709, as in every table of colour bars at 100 %.
TEST(Yuv, GivesTheTabulatedValuesOfPrimaryColours) {
  const auto of = [](std::uint8_t r, std::uint8_t g, std::uint8_t b) {
    Image picture({2, 2}, 3);
    for (std::size_t i = 0; i < 12; i += 3) std::copy_n(std::array{r, g, b}.begin(), 3, &picture.pixels[i]);
    const Converted c = converted(picture, convertToYuv420);
    return std::array<int, 3>{c.y[0], c.cb[0], c.cr[0]};
  };
  EXPECT_EQ(of(255, 0, 0), (std::array{63, 102, 240}));
  EXPECT_EQ(of(0, 255, 0), (std::array{173, 42, 26}));
  EXPECT_EQ(of(0, 0, 255), (std::array{32, 240, 118}));
}

TEST(Yuv, RespectsStridesAndRefusesOddSizes) {
  const Image picture = noise({16, 4}, 3, 23);
  std::vector<std::uint8_t> y(4 * 40, 7), cb(2 * 30, 7), cr(2 * 30, 7);
  convertToYuv420(picture, {y.data(), cb.data(), cr.data(), 40, 30, 30});
  const Converted tight = converted(picture, convertToYuv420);
  for (int row = 0; row < 4; ++row) {
    EXPECT_TRUE(std::equal(&y[static_cast<std::size_t>(row * 40)], &y[static_cast<std::size_t>(row * 40 + 16)],
                           &tight.y[static_cast<std::size_t>(row * 16)]));
    EXPECT_EQ(y[static_cast<std::size_t>(row * 40 + 16)], 7);
  }
  EXPECT_EQ(cb[8], 7);
  EXPECT_EQ(cr[38], 7);
  for (const image::PixelSize odd : {image::PixelSize{3, 2}, {2, 3}})
    EXPECT_THROW(convertToYuv420(Image(odd, 3), {}), std::logic_error);
}

}  // namespace
}  // namespace poinsot::output
