// SPDX-License-Identifier: Apache-2.0
#include "compare/difference.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <random>
#include <stdexcept>

#include "compare/near_rule.h"
#include "core/error.h"
#include "core/interruption.h"

namespace poinsot::compare {
namespace {

image::Image flat(image::PixelSize size, int channels, std::uint8_t value) {
  image::Image picture(size, channels);
  picture.pixels.assign(picture.pixels.size(), value);
  return picture;
}

/// Returns noise of mid-tones, so that steps of a few levels stay in range.
image::Image noise(image::PixelSize size, unsigned seed) {
  image::Image picture(size, 3);
  std::mt19937 random(seed);
  for (auto& v : picture.pixels) v = static_cast<std::uint8_t>(100 + random() % 50);
  return picture;
}

TEST(Difference, IsZeroForEqualPictures) {
  const image::Image a = noise({9, 7}, 1);
  const ImageDifference d = compare(a, a).difference;
  EXPECT_EQ(d.differingPixels, 0);
  EXPECT_EQ(d.maxAbs, 0);
  EXPECT_EQ(d.meanAbs, 0);
  EXPECT_EQ(d.rmse, 0);
  EXPECT_FALSE(d.psnr_dB);
  EXPECT_FALSE(d.ssim);  // too small
  EXPECT_EQ(d.flip.max, 0);
  EXPECT_TRUE(d.worst.empty());
  EXPECT_EQ(verdict(d), Verdict::kIdentical);
}

// Worked out by hand: 10 x 10 RGB pixels are 300 values. Two pixels differ, one by 10 in one channel, the other by
// 4 and 3 in two channels.
TEST(Difference, CountsAndFindsTheWorstPixel) {
  const image::Image a = flat({10, 10}, 3, 100);
  image::Image b = a;
  b.at(7, 2)[1] = 110;
  b.at(3, 4)[0] = 96;
  b.at(3, 4)[2] = 103;
  const ImageDifference d = compare(a, b).difference;
  EXPECT_EQ(d.differingPixels, 2);
  EXPECT_DOUBLE_EQ(d.differingShare, 0.02);
  EXPECT_EQ(d.maxAbs, 10);
  EXPECT_DOUBLE_EQ(d.meanAbs, 17.0 / 300);
  EXPECT_DOUBLE_EQ(d.rmse, std::sqrt(125.0 / 300));
  EXPECT_DOUBLE_EQ(*d.psnr_dB, 10 * std::log10(255.0 * 255 * 300 / (100 + 16 + 9)));
  ASSERT_EQ(d.worst.size(), 2u);
  EXPECT_EQ(d.worst[0].x, 7);
  EXPECT_EQ(d.worst[0].y, 2);
  EXPECT_EQ(d.worst[0].b[1], 110);
  EXPECT_EQ(d.worst[1].difference, 4);
  EXPECT_EQ(verdict(d), Verdict::kDifferent);
}

TEST(Difference, CountsAlpha) {
  const image::Image a = flat({4, 4}, 4, 200);
  image::Image b = a;
  b.at(1, 1)[3] = 199;
  EXPECT_EQ(compare(a, b).difference.differingPixels, 1);
  EXPECT_DOUBLE_EQ(compare(a, b).difference.meanAbs, 1.0 / 64);
}

TEST(Difference, RejectsPicturesOfDifferentShape) {
  const image::Image a = flat({4, 4}, 3, 0);
  for (const image::Image& b : {flat({4, 5}, 3, 0), flat({4, 4}, 4, 0)}) {
    EXPECT_THROW(compare(a, b), core::Error);
    EXPECT_THROW(amplifiedDifference(a, b), core::Error);
  }
}

Verdict verdictOf(const image::Image& a, const image::Image& b, const NearRule& rule = {}) {
  return verdict(compare(a, b).difference, rule);
}

TEST(Difference, EndsWhenItsCallerIsInterrupted) {
  const image::Image a = noise({4000, 2000}, 1), b = noise({4000, 2000}, 2);
  const core::InterruptionCheck check([] { throw std::runtime_error("stop"); });
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_THROW(compare(a, b), std::runtime_error);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(500));  // measured 60; whole: 3 s
}

// Each limit of the rule alone decides at least one case that a comparison must accept or reject.
TEST(Verdict, DependsOnEveryLimit) {
  const image::Image a = noise({200, 100}, 2);  // 20 000 pixels: 0.5 % are 100
  image::Image wobble = a, tooMany = a, tooMuch = a;
  for (int i = 0; i < 100; ++i) wobble.at(2 * i, i)[i % 3] += 1;
  for (int i = 0; i < 101; ++i) tooMany.at(i, i % 100)[0] += 1;
  tooMuch.at(50, 50)[1] += 3;
  EXPECT_EQ(verdictOf(a, wobble), Verdict::kNear);
  EXPECT_EQ(verdictOf(a, tooMany), Verdict::kDifferent);
  EXPECT_EQ(verdictOf(a, tooMuch), Verdict::kDifferent);

  const ImageDifference legal = compare(a, wobble).difference;
  EXPECT_EQ(verdict(legal, NearRule{.flipMean = legal.flip.mean / 2}), Verdict::kDifferent);
  EXPECT_EQ(verdict(legal, NearRule{.flipMax = legal.flip.max / 2}), Verdict::kDifferent);
  EXPECT_EQ(verdictOf(a, tooMuch, NearRule{.maxAbs = 3}), Verdict::kNear);
  EXPECT_EQ(toString(Verdict::kNear), "near");
}

// A picture that is one level brighter everywhere stays below the maximum, and must not pass.
TEST(Verdict, RejectsAUniformShiftOfOneLevel) {
  const image::Image a = noise({64, 64}, 3);
  image::Image b = a;
  for (auto& v : b.pixels) ++v;
  EXPECT_EQ(verdictOf(a, b), Verdict::kDifferent);
}

// A limit may be a count instead of a share; the count does not depend on the size of the picture.
TEST(Verdict, CountsPixelsIfTheRuleHasACount) {
  const image::Image a = flat({10, 10}, 3, 100);
  image::Image b = a;
  for (int x = 0; x < 3; ++x) b.at(x, 5)[0] = 101;
  EXPECT_EQ(verdictOf(a, b), Verdict::kDifferent);  // 3 %
  EXPECT_EQ(verdictOf(a, b, NearRule{.flipMean = 1, .flipMax = 1}), Verdict::kDifferent);
  EXPECT_EQ(verdict(compare(a, b).difference, {.differingPixels = 3, .flipMean = 1, .flipMax = 1}),
            Verdict::kNear);
  EXPECT_EQ(excesses(compare(a, b).difference, {.differingPixels = 2, .flipMean = 1, .flipMax = 1}),
            std::vector<std::string>{"differing pixels 3 (limit 2)"});
}

// 16-bit pictures are compared in their own steps: one of 65535 is 255/65535 of a level. Eight bits count as v *
// 257.
TEST(Difference, ComparesSixteenBitsWithoutRounding) {
  image::DeepImage a({8, 8}, 3);
  a.pixels.assign(a.pixels.size(), 257 * 90);
  image::DeepImage b = a;
  b.at(2, 3)[1] += 1;
  const ImageDifference d = compare(a, b).difference;
  EXPECT_DOUBLE_EQ(d.maxAbs, 255.0 / 65535);
  EXPECT_EQ(d.differingPixels, 1);
  EXPECT_EQ(d.worst[0].b[1], 257 * 90 + 1);
  EXPECT_EQ(verdict(d), Verdict::kDifferent);  // 1.6 % of the pixels
  EXPECT_EQ(compare(image::AnyImage(a), image::AnyImage(flat({8, 8}, 3, 90))).difference.differingPixels, 0);
}

// Ten pixels are reported, the largest difference first; equal differences are listed from the top left.
TEST(Difference, ReportsTheTenWorstPixels) {
  const image::Image a = flat({20, 2}, 3, 50);
  image::Image b = a;
  for (int x = 0; x < 12; ++x) b.at(x, 1)[2] = 52;
  b.at(15, 1)[0] = 60;
  const auto worst = compare(a, b).difference.worst;
  ASSERT_EQ(worst.size(), 10u);
  EXPECT_EQ(worst[0].x, 15);
  for (int i = 1; i < 10; ++i) EXPECT_EQ(worst[static_cast<std::size_t>(i)].x, i - 1);
}

TEST(Difference, CanBeDrawnAmplifiedAndClamped) {
  image::Image a = flat({2, 1}, 4, 10), b = a;
  b.at(0, 0)[0] = 13;
  b.at(1, 0)[2] = 200;
  b.at(1, 0)[3] = 5;  // alpha: 5 x 16 in all three
  const image::Image shown = amplifiedDifference(a, b, nullptr, 16);
  EXPECT_EQ(shown.channels, 3);
  EXPECT_EQ(shown.pixels, (std::vector<std::uint8_t>{48, 0, 0, 80, 80, 255}));
}

// Expected by hand: 10 x 10 pixels less 3 ignored rows are 70. Two of the three differing pixels are among them.
TEST(Difference, LeavesOutIgnoredPixels) {
  const image::Image a = flat({10, 10}, 3, 100);
  image::Image b = a;
  b.at(4, 1)[0] = 255;
  b.at(4, 5)[0] = 107;
  b.at(5, 5)[0] = 93;
  IgnoreMask ignored({10, 10});
  ignored.add(image::PixelRect{-5, 0, 100, 3});
  const auto [d, flip] = compare(a, b, {.ignored = &ignored});
  EXPECT_EQ(d.comparedPixels, 70);
  EXPECT_EQ(d.differingPixels, 2);
  EXPECT_DOUBLE_EQ(d.differingShare, 2.0 / 70);
  EXPECT_EQ(d.maxAbs, 7);
  EXPECT_DOUBLE_EQ(d.meanAbs, 14.0 / 210);
  EXPECT_DOUBLE_EQ(d.rmse, std::sqrt(98.0 / 210));
  EXPECT_DOUBLE_EQ(d.flip.mean, flip.mean() * 100 / 70);
  EXPECT_EQ(amplifiedDifference(a, b, &ignored).at(4, 1)[0], 0);
  EXPECT_EQ(amplifiedDifference(a, b, &ignored).at(4, 5)[0], 7 * 16);

  // Errors do not reach into ignored pixels, so that the mean is at most the largest error.
  image::Image large = flat({64, 64}, 3, 100);
  const image::Image before = large;
  large.at(40, 40)[0] = 200;
  IgnoreMask most({64, 64});
  most.add(image::PixelRect{0, 0, 64, 40});
  most.add(image::PixelRect{0, 41, 64, 64});
  most.add(image::PixelRect{0, 40, 39, 41});
  most.add(image::PixelRect{42, 40, 64, 41});  // three pixels are left
  const Comparison few = compare(before, large, {.ignored = &most});
  EXPECT_EQ(few.difference.comparedPixels, 3);
  EXPECT_LE(few.difference.flip.mean, few.difference.flip.max);
  EXPECT_EQ(std::ranges::count_if(few.flip.error, [](double e) { return e > 0; }), 3);
  ASSERT_TRUE(few.difference.ssim);
  EXPECT_LT(few.difference.ssim->mean, 0.9);  // three windows, all of which hold the change

  ignored.add(image::PixelRect{0, 5, 10, 6});
  EXPECT_EQ(verdict(compare(a, b, {.ignored = &ignored}).difference), Verdict::kIdentical);
}

// Differences of 1, 2, ... 9 appear in one pixel each.
TEST(Difference, CountsPixelsBeyondALevel) {
  const image::Image a = flat({20, 20}, 3, 100);
  image::Image b = a;
  for (int k = 1; k < 10; ++k) b.at(k, 7)[1] = static_cast<std::uint8_t>(100 + k);
  for (int level = 0; level < 10; ++level) {
    const ImageDifference d = compare(a, b, {.level = static_cast<double>(level)}).difference;
    EXPECT_EQ(d.countedPixels, 9 - level);
    EXPECT_EQ(d.differingPixels, 9);
  }
  const NearRule rule{.maxAbs = 255, .differingPixels = 2, .flipMean = 1, .flipMax = 1, .level = 7};
  EXPECT_EQ(verdict(compare(a, b, {.level = 7}).difference, rule), Verdict::kNear);
  EXPECT_EQ(excesses(compare(a, b, {.level = 6}).difference, rule),
            std::vector<std::string>{"pixels beyond level 7 3 (limit 2)"});
}

/// Returns a picture whose alpha is `alpha` in the left half and opaque in the right half.
image::Image holed(image::PixelSize size, std::uint8_t value, std::uint8_t alpha) {
  image::Image picture = flat(size, 4, value);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) picture.at(x, y)[3] = x < size.width / 2 ? alpha : 255;
  return picture;
}

// A hole in a black picture shows over white paper only, and a hole in a white picture over black only. Expected:
// FLIP of the two pictures as they look over that paper, made by hand.
TEST(Difference, ComparesTransparencyOverBlackAndWhite) {
  const image::PixelSize size{32, 16};
  for (const std::uint8_t value : {std::uint8_t{0}, std::uint8_t{255}}) {
    const image::Image whole = holed(size, value, 255), hole = holed(size, value, 0);
    image::Image seen = flat(size, 3, value);
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width / 2; ++x)
        std::fill_n(seen.at(x, y), 3, static_cast<std::uint8_t>(255 - value));
    const Comparison c = compare(whole, hole);
    EXPECT_EQ(c.flip.error, flip(flat(size, 3, value), seen).error);
    EXPECT_GT(c.difference.flip.mean, 0.3);
    EXPECT_EQ(c.difference.differingPixels, 32 * 16 / 2);
    EXPECT_LT(c.difference.ssim->mean, 0.6);
  }
}

// Colours under alpha 0 do not count. Grey, opaque alpha and 16 bits are other ways to store the same values.
TEST(Difference, ComparesValuesIndependentOfTheirStorage) {
  image::Image hidden = holed({8, 8}, 90, 0), other = hidden;
  for (int y = 0; y < 8; ++y) std::fill_n(other.at(0, y), 3, std::uint8_t{200});
  EXPECT_EQ(compare(image::AnyImage(hidden), image::AnyImage(other)).difference.maxAbs, 0);
  EXPECT_EQ(
      compare(image::AnyImage(flat({8, 8}, 3, 90)), image::AnyImage(holed({8, 8}, 90, 255))).difference.maxAbs, 0);
  image::DeepImage deep({8, 8}, 3);
  deep.pixels.assign(deep.pixels.size(), 257 * 90);
  EXPECT_EQ(compare(image::AnyImage(deep), image::AnyImage(holed({8, 8}, 90, 255))).difference.maxAbs, 0);

  image::Image changed = holed({8, 8}, 90, 255);
  changed.at(2, 2)[1] = 93;  // 3 of 255 in one of 192 values: alpha, which is opaque in both, does not count
  const ImageDifference d = compare(image::AnyImage(flat({8, 8}, 3, 90)), image::AnyImage(changed)).difference;
  EXPECT_EQ(d.channels, 3);
  EXPECT_DOUBLE_EQ(d.meanAbs, 3.0 / 192);
  EXPECT_THROW(compare(image::AnyImage(flat({8, 8}, 3, 0)), image::AnyImage(flat({8, 9}, 3, 0))), core::Error);
}

TEST(NearRule, ReportsWhetherItCanRejectAPicture) {
  for (const NamedRule& named : namedRules()) EXPECT_TRUE(named.rule.canRefuse()) << named.name;
  NearRule everything{.maxAbs = 255, .differingShare = 1, .flipMean = 1, .flipMax = 1};
  EXPECT_FALSE(everything.canRefuse());
  everything.differingPixels = 64;
  EXPECT_TRUE(everything.canRefuse());
  EXPECT_TRUE(everything.canRefuse(65));
  EXPECT_FALSE(everything.canRefuse(64));
  everything.flipMax = 0.99;
  EXPECT_TRUE(everything.canRefuse(64));
}

// Expected by hand: 4 over limits of 2 and 1 is ln 2 + ln 4. Figures within their limits subtract nothing.
TEST(NearRule, MeasuresHowFarAPictureExceedsTheLimits) {
  ImageDifference d;
  d.maxAbs = 4;
  d.comparedPixels = 100;
  d.countedPixels = 4;
  const NearRule rule{.maxAbs = 2, .differingPixels = 1, .flipMean = 0.5, .flipMax = 0.5};
  EXPECT_DOUBLE_EQ(distanceBeyond(d, rule), std::log(2) + std::log(4));
  d.flip.mean = 0.4;
  EXPECT_DOUBLE_EQ(distanceBeyond(d, rule), std::log(2) + std::log(4));
}

// A mask ignores painted pixels, which are neither black nor transparent.
TEST(IgnoreMask, IgnoresPaintedPixels) {
  image::Image painted({3, 1}, 4);
  std::fill_n(painted.at(0, 0), 4, std::uint8_t{255});  // white
  painted.at(1, 0)[3] = 255;                            // black
  painted.at(2, 0)[0] = 255;                            // red, but transparent
  IgnoreMask mask({3, 1});
  mask.add(image::AnyImage(painted));
  EXPECT_TRUE(mask.ignores(0, 0));
  EXPECT_FALSE(mask.ignores(1, 0));
  EXPECT_FALSE(mask.ignores(2, 0));
  mask.add(image::PixelRect{0, 0, 2, 1});
  EXPECT_EQ(mask.ignoredPixels(), 2);
  EXPECT_DOUBLE_EQ(mask.share(), 2.0 / 3);
}

}  // namespace
}  // namespace poinsot::compare
