// SPDX-License-Identifier: Apache-2.0
#include "output/ordered_dither.h"

#include <gtest/gtest.h>

#include <array>

namespace poinsot::output {
namespace {

constexpr int kSide = 64;

image::Image flat(const Rgb& color) {
  image::Image picture({kSide, kSide}, 3);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) std::copy(color.begin(), color.end(), picture.at(x, y));
  return picture;
}

std::vector<std::uint8_t> dithered(OrderedDither& dither, const image::Image& picture) {
  std::vector<std::uint8_t> indices(picture.pixels.size() / 3);
  dither.apply(picture, indices, picture.size.width);
  return indices;
}

TEST(OrderedDither, KeepsColorsOfThePaletteUnchanged) {
  OrderedDither dither({{250, 250, 248}, {251, 250, 248}, {10, 20, 30}});
  for (std::size_t i = 0; i < 3; ++i)
    for (const std::uint8_t index : dithered(dither, flat(dither.palette()[i]))) ASSERT_EQ(index, i);
}

// The mean over the pattern is the wanted colour, to half of one of its 64 steps.
TEST(OrderedDither, MixesTheWantedMeanColor) {
  OrderedDither dither({{0, 0, 0}, {64, 64, 64}});
  for (const int grey : {9, 20, 31, 32, 33, 50}) {
    const auto level = static_cast<std::uint8_t>(grey);
    double sum = 0;
    for (const std::uint8_t index : dithered(dither, flat({level, level, level}))) sum += 64 * index;
    EXPECT_NEAR(sum / (kSide * kSide), grey, 0.5) << grey;
  }
}

// A pattern of one dark pixel in 64 would be more visible than the difference.
TEST(OrderedDither, DoesNotDitherASmallDifference) {
  OrderedDither dither({{0, 0, 0}, {64, 64, 64}});
  for (const std::uint8_t index : dithered(dither, flat({1, 1, 1}))) ASSERT_EQ(index, 0);
  for (const std::uint8_t index : dithered(dither, flat({63, 63, 63}))) ASSERT_EQ(index, 1);
}

// A pixel's index depends on its colour and place only, so that unchanged parts stay still.
TEST(OrderedDither, IsStableFromPictureToPicture) {
  OrderedDither dither({{0, 0, 0}, {255, 255, 255}, {200, 30, 30}});
  image::Image picture = flat({120, 90, 80});
  const auto before = dithered(dither, picture);
  for (int x = 0; x < kSide; ++x) picture.at(x, 5)[0] = 250;
  const auto after = dithered(dither, picture);
  for (std::size_t i = 0; i < after.size(); ++i)
    if (i / kSide != 5) {
      ASSERT_EQ(after[i], before[i]);
    }
  EXPECT_NE(after, before);
}

}  // namespace
}  // namespace poinsot::output
