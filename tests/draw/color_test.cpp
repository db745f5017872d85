// SPDX-License-Identifier: Apache-2.0
#include "draw/color.h"

#include <gtest/gtest.h>

#include <cmath>

namespace poinsot::draw {
namespace {

// Returns the light of a value from 0 to 255, by the curve of IEC 61966-2-1.
double linear(double v) {
  const double c = v / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

TEST(Color, DecodesEveryEightBitSrgbValue) {
  for (int v = 0; v < 256; ++v)
    EXPECT_NEAR(linearFromSrgb8(static_cast<std::uint8_t>(v)), linear(v), 1e-7) << v;  // measured 3e-8: one float
}

TEST(Color, EncodesBackToTheSameValue) {
  for (int v = 0; v < 256; ++v) EXPECT_EQ(srgb8FromLinear(linearFromSrgb8(static_cast<std::uint8_t>(v))), v);
}

TEST(Color, EncodesRoundedToNearestAndClamped) {
  EXPECT_EQ(srgb8FromLinear(-1), 0);
  EXPECT_EQ(srgb8FromLinear(2), 255);
  // Half way in sRGB, a little to either side.
  const auto between = static_cast<float>(std::pow((100.5 / 255 + 0.055) / 1.055, 2.4));
  EXPECT_EQ(srgb8FromLinear(between * 0.9999f), 100);
  EXPECT_EQ(srgb8FromLinear(between * 1.0001f), 101);
}

TEST(Color, UsesTheSameCurveForSixteenBits) {
  for (int v = 0; v < 256; ++v)
    EXPECT_EQ(linearFromSrgb16(static_cast<std::uint16_t>(257 * v)),
              linearFromSrgb8(static_cast<std::uint8_t>(v)));
  for (int v = 0; v < 65536; ++v) {
    const float light = linearFromSrgb16(static_cast<std::uint16_t>(v));
    ASSERT_NEAR(light, linear(v / 257.0), 1e-7) << v;  // measured 3e-8: one float
    ASSERT_EQ(srgb16FromLinear(light), v);
  }
}

TEST(Color, EncodesSixteenBitsRoundedToNearestAndClamped) {
  EXPECT_EQ(srgb16FromLinear(-1), 0);
  EXPECT_EQ(srgb16FromLinear(std::nanf("")), 0);
  EXPECT_EQ(srgb16FromLinear(2), 65535);
  const double between = linear(30000.5 / 257);
  EXPECT_EQ(srgb16FromLinear(static_cast<float>(between * 0.999999)), 30000);
  EXPECT_EQ(srgb16FromLinear(static_cast<float>(between * 1.000001)), 30001);
}

TEST(Color, ReadsTheChannelsOfAHexadecimalValue) {
  const Color c = fromSrgb(0x0072B2);
  EXPECT_EQ(srgb8FromLinear(c.r), 0x00);
  EXPECT_EQ(srgb8FromLinear(c.g), 0x72);
  EXPECT_EQ(srgb8FromLinear(c.b), 0xB2);
}

}  // namespace
}  // namespace poinsot::draw
