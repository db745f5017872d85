// SPDX-License-Identifier: Apache-2.0
// Compares FLIP of whole pictures with flip_oracle.py, an independent implementation in Python with
// two-dimensional kernels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "compare/flip.h"

namespace poinsot::compare {
namespace {

using Color = std::array<int, 3>;
using Formula = std::function<Color(int x, int y)>;

constexpr image::PixelSize kSize{32, 24};

image::Image painted(const Formula& color) {
  image::Image picture(kSize, 3);
  for (int y = 0; y < kSize.height; ++y)
    for (int x = 0; x < kSize.width; ++x)
      std::ranges::transform(color(x, y), picture.at(x, y), [](int v) { return static_cast<std::uint8_t>(v); });
  return picture;
}

Formula noise(std::uint32_t seed) {
  return [seed](int x, int y) {
    const auto value = [&](std::uint32_t c) {
      std::uint32_t v = static_cast<std::uint32_t>(x) * 73856093U ^ static_cast<std::uint32_t>(y) * 19349663U ^
                        c * 83492791U ^ seed * 2654435761U;
      v = (v ^ v >> 13) * 1274126177U;
      return static_cast<int>((v ^ v >> 16) & 255);
    };
    return Color{value(0), value(1), value(2)};
  };
}

Color ramp(int x, int y) { return {8 * x, 10 * y, 255 - 4 * (x + y)}; }

Color rampOneUp(int x, int y) {
  Color color = ramp(x, y);
  for (int& v : color) v = std::min(v + 1, 255);
  return color;
}

Formula disc(int cx) {
  return [cx](int x, int y) {
    return (x - cx) * (x - cx) + (y - 12) * (y - 12) <= 49 ? Color{200, 40, 30} : Color{250, 250, 245};
  };
}

Color whiteDot(int x, int y) { return x == 20 && y == 9 ? Color{255, 255, 255} : ramp(x, y); }
Color dark(int, int) { return {3, 5, 9}; }

struct Pair {
  const char* name;
  Formula a, b;
  FlipFigures figures;  ///< as flip_oracle.py prints them
  double at20_9;
};

// Prints a pair's name in the output of GoogleTest and ctest.
void PrintTo(const Pair& pair, std::ostream* out) { *out << pair.name; }

class FlipPairs : public testing::TestWithParam<Pair> {};

// Measured: 4e-13 at most, which is the rounding to twelve digits. The smallest error of the disc, 3e-5, agrees to
// 3e-12.
TEST_P(FlipPairs, AgreeWithTheIndependentImplementation) {
  const auto& [name, a, b, expected, at20_9] = GetParam();
  const FlipMap map = flip(painted(a), painted(b));
  const FlipFigures figures = figuresOf(map);
  EXPECT_NEAR(figures.mean, expected.mean, 1e-10);
  EXPECT_NEAR(figures.min, expected.min, 1e-10);
  EXPECT_NEAR(figures.firstQuartile, expected.firstQuartile, 1e-10);
  EXPECT_NEAR(figures.median, expected.median, 1e-10);
  EXPECT_NEAR(figures.thirdQuartile, expected.thirdQuartile, 1e-10);
  EXPECT_NEAR(figures.max, expected.max, 1e-10);
  EXPECT_NEAR(map.error[9 * 32 + 20], at20_9, 1e-10);
}

INSTANTIATE_TEST_SUITE_P(
    Each, FlipPairs,
    testing::Values(
        Pair{"Noise",
             noise(1),
             noise(2),
             {0.470767466734, 0.125939748254, 0.410307655099, 0.508689540795, 0.614540319982, 0.96325384715},
             0.397501117859},
        Pair{"OneUp",
             ramp,
             rampOneUp,
             {0.0419466023793, 0.0248293819704, 0.0403247602973, 0.042415281272, 0.0441858947888, 0.0484706845209},
             0.0403247602973},
        Pair{"ShiftedDisc",
             disc(15),
             disc(16),
             {0.12453910612, 3.34463264183e-05, 0.19733061244, 0.39866897571, 0.570358071214, 0.652912760695},
             0.515970005582},
        Pair{"WhiteDot",
             ramp,
             whiteDot,
             {0.00794212699505, 0, 0.051315305817, 0.167652666228, 0.33325317392, 0.433782218786},
             0.433782218786},
        Pair{"DarkAndLight",
             dark,
             ramp,
             {0.972886553064, 0.957744774907, 0.965978792811, 0.971548052201, 0.980919020904, 0.989965406764},
             0.967351622946}),
    [](const auto& each) { return std::string(each.param.name); });

// flip() looks closely only at the part of two pictures that differs. The test compares the same pictures with and
// without differences in their far corners, whose errors do not reach the middle.
TEST(Flip, IsIndependentOfDifferencesFarAway) {
  image::Image a({120, 90}, 3), b = a;
  for (int y = 0; y < 90; ++y)
    for (int x = 0; x < 120; ++x)
      for (int c = 0; c < 3; ++c) {
        a.at(x, y)[c] = b.at(x, y)[c] = static_cast<std::uint8_t>(noise(3)(x, y)[static_cast<std::size_t>(c)]);
        if (x > 50 && x < 60 && y > 40 && y < 47) b.at(x, y)[c] ^= 16;
      }
  image::Image far = b;
  far.at(0, 0)[0] ^= 64;
  far.at(119, 89)[2] ^= 64;
  const FlipMap near = flip(a, b), whole = flip(a, far);
  for (std::size_t y = 15; y < 75; ++y)
    for (std::size_t x = 15; x < 105; ++x)
      EXPECT_EQ(near.error[y * 120 + x], whole.error[y * 120 + x]) << x << ' ' << y;
  EXPECT_GT(near.max(), 0.01);
}

TEST(Flip, IsTheSameForSixteenAndEightBits) {
  const image::Image a = painted(noise(4)), b = painted(noise(5));
  image::DeepImage deepA(kSize, 3), deepB(kSize, 3);
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    deepA.pixels[i] = static_cast<std::uint16_t>(257 * a.pixels[i]);
    deepB.pixels[i] = static_cast<std::uint16_t>(257 * b.pixels[i]);
  }
  EXPECT_NEAR(flip(deepA, deepB).mean(), flip(a, b).mean(), 1e-14);
}

// A picture of one pixel is flat, so that E is the colour error of its two colours, here green and blue.
TEST(Flip, IsTheColorErrorForOnePixel) {
  image::Image a({1, 1}, 3), b({1, 1}, 3);
  a.pixels = {0, 255, 0};
  b.pixels = {0, 0, 255};
  EXPECT_NEAR(flip(a, b).max(), 1, 1e-6);
}

}  // namespace
}  // namespace poinsot::compare
