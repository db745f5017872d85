// SPDX-License-Identifier: Apache-2.0
#include "core/frame_clock.h"

#include <gtest/gtest.h>

namespace poinsot::core {
namespace {

constexpr Rational k30{30, 1}, kNtsc{30000, 1001};

TEST(FrameClock, RoundsTimesOnce) {
  EXPECT_EQ(filmTime_s(0, k30), 0.0);
  EXPECT_EQ(filmTime_s(1, k30), 1.0 / 30.0);
  EXPECT_EQ(filmTime_s(45, k30), 1.5);
  EXPECT_EQ(filmTime_s(30000, kNtsc), 1001.0);  // 30000 * 1001 / 30000
  EXPECT_EQ(filmTime_s(36000, {1000000000, 1}), 36000.0 / 1e9);
}

TEST(FrameClock, CountsFramesBelowTheDuration) {
  EXPECT_EQ(frameCount(10, k30), 300);
  EXPECT_EQ(frameCount(10.001, k30), 301);  // frame 300 is at 10 s, below 10.001
  EXPECT_EQ(frameCount(9.999, k30), 300);   // frame 299 is at 9.967
  EXPECT_EQ(frameCount(1e-300, k30), 1);
  EXPECT_EQ(frameCount(3600, {10, 1}), 36000);
  EXPECT_EQ(frameCount(1, {1, 1000}), 1);
  EXPECT_EQ(frameCount(1e9, {1, 1}), 1000000000);
}

TEST(FrameClock, CountsFramesOfDecimalDurationsExactly) {
  // The doubles 0.1, 0.7 and 2.3 differ from the decimals. By hand: 0.1 * 30 = 3, 0.7 * 30 = 21, 2.3 * 30 = 69.
  EXPECT_EQ(frameCount(0.1, k30), 3);
  EXPECT_EQ(frameCount(0.7, k30), 21);
  EXPECT_EQ(frameCount(2.3, k30), 69);
  EXPECT_EQ(frameCount(1.001, kNtsc), 30);  // 1.001 * 30000 / 1001 = 30 exactly
  EXPECT_EQ(frameCount(3.003, kNtsc), 90);
  EXPECT_EQ(frameCount(3.0031, kNtsc), 91);
}

TEST(FrameClock, FrameCountMatchesIntegerArithmetic) {
  // In hundredths of a second both sides of k / fps < d become integers: k * 100 * den < hundredths * num.
  for (const Rational fps : {k30, kNtsc, Rational{24, 1}, Rational{2997, 100}}) {
    for (std::int64_t hundredths = 1; hundredths <= 500; ++hundredths) {
      const std::int64_t n = frameCount(static_cast<double>(hundredths) / 100.0, fps);
      EXPECT_LT((n - 1) * 100 * fps.den, hundredths * fps.num) << hundredths;
      EXPECT_GE(n * 100 * fps.den, hundredths * fps.num) << hundredths;
    }
  }
}

TEST(FrameClock, RejectsDurationsThatAreNotPositive) {
  EXPECT_THROW(frameCount(0, k30), std::logic_error);
  EXPECT_THROW(frameCount(-1, k30), std::logic_error);
}

}  // namespace
}  // namespace poinsot::core
