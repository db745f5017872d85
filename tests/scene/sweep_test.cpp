// SPDX-License-Identifier: Apache-2.0
// Ranges after -D: the values that they stand for, and the errors of malformed ranges.
#include "scene/sweep.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iterator>
#include <random>
#include <string_view>

#include "core/error.h"

namespace poinsot::scene {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> overridesOf(const std::string& word) {
  const auto axis = sweepAxis(word);
  std::vector<std::string> all;
  for (std::size_t i = 0; axis && i < axis->values.size(); ++i) all.push_back(axis->override(i));
  return all;
}

std::vector<std::string> numbersOf(const std::string& word) {
  const auto axis = sweepAxis(word);
  std::vector<std::string> all;
  for (std::size_t i = 0; axis && i < axis->values.size(); ++i) all.push_back(axis->values[i].number);
  return all;
}

std::string refusal(const std::string& word) {
  try {
    sweepAxis(word);
  } catch (const core::Error& error) {
    EXPECT_EQ(error.kind(), core::ErrorKind::kUsage);
    return error.what();
  }
  return "none";
}

TEST(SweepAxis, IncludesBothEndsInEqualSteps) {
  EXPECT_THAT(overridesOf("time.speed=1..2:3"), ElementsAre("time.speed=1.0", "time.speed=1.5", "time.speed=2.0"));
  EXPECT_THAT(overridesOf(" time.speed = 2 .. -1 : 2 "), ElementsAre(" time.speed =2", " time.speed =-1"));
  EXPECT_THAT(overridesOf("camera.azimuth=-10..10 deg:3"),
              ElementsAre("camera.azimuth=-10 deg", "camera.azimuth=0 deg", "camera.azimuth=10 deg"));
  EXPECT_THAT(overridesOf("camera.azimuth='10 deg..20 deg:2'"),
              ElementsAre("camera.azimuth='10 deg'", "camera.azimuth='20 deg'"));
}

TEST(SweepAxis, MayBeAnElementOfAVector) {
  EXPECT_THAT(overridesOf("motion.omega_body=[0.01..0.03:3, 4.2, 0]"),
              ElementsAre("motion.omega_body=[0.01, 4.2, 0]", "motion.omega_body=[0.02, 4.2, 0]",
                          "motion.omega_body=[0.03, 4.2, 0]"));
  // Within an array a number with a unit must be text.
  EXPECT_THAT(overridesOf("motion.omega_body=[0, 1..3 rpm:2, 0]"),
              ElementsAre("motion.omega_body=[0,\"1 rpm\", 0]", "motion.omega_body=[0,\"3 rpm\", 0]"));
  EXPECT_THAT(overridesOf("motion.omega_body=[0, '1..3 rpm:2', 0]"),
              ElementsAre("motion.omega_body=[0, '1 rpm', 0]", "motion.omega_body=[0, '3 rpm', 0]"));
  EXPECT_EQ(sweepAxis("motion.omega_body=[0, 1..3:2, 0]")->element, 1);
  EXPECT_EQ(sweepAxis("motion.omega_body=[0,1,1..3:2]")->element, 2);
  EXPECT_EQ(sweepAxis("time.speed=1..3:2")->element, std::nullopt);
}

TEST(SweepAxis, MayBeLogarithmicOrAList) {
  EXPECT_THAT(numbersOf("time.speed=0.01..100:5:log"), ElementsAre("0.01", "0.1", "1", "10", "100"));
  EXPECT_THAT(numbersOf("time.speed=1..2:3:log"), ElementsAre("1", "1.41", "2"));  // sqrt 2
  EXPECT_THAT(numbersOf("time.speed=5|0.25|1e3"), ElementsAre("5", "0.25", "1e3"));
  EXPECT_THAT(overridesOf("time.start=1 s|2 s"), ElementsAre("time.start=1 s", "time.start=2 s"));
}

// A third of 1 has infinitely many digits. The rounded value, within a hundredth of a step, is written and drawn.
TEST(SweepAxis, MayBeWordsOfItsKey) {
  const auto axis = sweepAxis("motion.spin_axis=smallest|middle | largest").value();
  EXPECT_TRUE(axis.isWords);
  ASSERT_EQ(axis.values.size(), 3u);
  EXPECT_EQ(axis.values[1].number, "middle");
  EXPECT_EQ(axis.override(1), "motion.spin_axis=\"middle\"");
  EXPECT_EQ(sweepAxis("motion.spin_axis=\"1|3\"")->override(1), "motion.spin_axis=\"3\"");
  EXPECT_EQ(sweepAxis("show.cones.visible=true|false")->override(0), "show.cones.visible=true");
  EXPECT_EQ(sweepAxis("motion.precession=slow|fast")->override(1), "motion.precession=\"fast\"");
  EXPECT_FALSE(sweepAxis("motion.precession=1|2 rpm")->isWords);
  EXPECT_FALSE(hasRange("motion.spin_axis=middle"));
}

TEST(SweepAxis, WritesEnoughDecimalsToDistinguishValues) {
  EXPECT_THAT(numbersOf("time.speed=0..1:4"), ElementsAre("0.000", "0.333", "0.667", "1.000"));
  EXPECT_THAT(numbersOf("time.speed=0.01..0.41:9"),
              ElementsAre("0.01", "0.06", "0.11", "0.16", "0.21", "0.26", "0.31", "0.36", "0.41"));
  EXPECT_THAT(numbersOf("time.speed=-1..1:3"), ElementsAre("-1", "0", "1"));
  EXPECT_THAT(numbersOf("body.mass=1e-20..3e-20:3"), ElementsAre("1e-20", "2e-20", "3e-20"));
  EXPECT_THAT(numbersOf("body.mass=1e24..3e24:3"), ElementsAre("1e+24", "2e+24", "3e+24"));
}

TEST(SweepAxis, UsesTheGivenUnitOrTheUnitOfItsKey) {
  EXPECT_EQ(sweepAxis("camera.azimuth=1..2 deg:2")->unit, "deg");
  EXPECT_EQ(sweepAxis("time.start=1..2:2")->unit, "s");
  EXPECT_EQ(sweepAxis("time.speed=1..2:2")->unit, "");
}

TEST(SweepAxis, IsAbsentForTextsAndUnknownKeys) {
  for (const char* word : {"show.title=1..2:3", "show.title='|L| or 1|2'", "time.strat=1..2:3", "time.speed=1",
                           "x", "", "=1..2:3", "style.theme=dark"})
    EXPECT_EQ(sweepAxis(word), std::nullopt) << word;
}

TEST(SweepAxis, ExplainsMistakesInRanges) {
  for (const char* word : {"time.speed=1..2", "time.speed=1..:3", "time.speed=..2:3", "time.speed=a..b:3",
                           "time.speed=1..2:x", "time.speed=1..2:3:lin", "time.speed=nan..2:3"})
    EXPECT_THAT(refusal(word), HasSubstr("a range is FROM..TO:COUNT, such as 10..50 rpm:5")) << word;
  for (const char* word : {"time.speed=1:2:3", "time.speed=1 to 3", "time.speed=1\u20263", "time.speed=[1:3:5]"})
    EXPECT_THAT(refusal(word), HasSubstr("a range is FROM..TO:COUNT, such as 10..50 rpm:5")) << word;
  EXPECT_THAT(refusal("time.speed=1..2"), HasSubstr("the number of values is missing"));
  EXPECT_THAT(refusal("time.speed=1...2:3"), HasSubstr("write two dots"));
  for (const char* count : {"1", "0", "-3", "101", "99999999999999999999"})
    EXPECT_THAT(refusal(std::string("time.speed=1..2:") + count), HasSubstr("a range has from 2 to 100 values"));
  EXPECT_THAT(refusal("time.speed=1..2:100"), "none");
  EXPECT_THAT(refusal("time.speed=2..2:3"), HasSubstr("both ends are the same"));
  EXPECT_THAT(refusal("time.speed=0..2:3:log"), HasSubstr("of the same sign, neither of them 0"));
  EXPECT_THAT(refusal("time.speed=-1..2:3:log"), HasSubstr("of the same sign"));
  EXPECT_THAT(refusal("time.start=1 s..2 min:3"), HasSubstr("all values must have the same unit, got s and min"));
  EXPECT_THAT(refusal("time.speed=1|x"), HasSubstr("expected numbers between the bars"));
  EXPECT_THAT(refusal("time.speed=|"), HasSubstr("expected numbers between the bars"));
  EXPECT_THAT(refusal("motion.omega_body=[1..2:2, 1..2:2, 0]"), HasSubstr("a key may have only one range"));
  EXPECT_THAT(refusal("time.speed=1..2\x1b"), HasSubstr("\\x1b"));  // control characters are escaped
}

// Any text must give a range with its values, no range, or an error.
TEST(SweepAxis, AcceptsOrRejectsAnyText) {
  constexpr std::string_view kPieces[] = {"..", "|", ":", "1", "-2", "3e5", "log", "rpm", "[", "]", ",", "\"",
                                          "'",  " ", "=", "0", "9",  "nan", "\0",  "é",   "{", "}", ".", "5 deg"};
  std::mt19937 random(5);
  int ranges = 0;
  for (int i = 0; i < 20'000; ++i) {
    std::string word = i % 2 == 0 ? "time.speed=" : "motion.omega_body=[";
    for (unsigned n = random() % 9; n > 0; --n) word += kPieces[random() % std::size(kPieces)];
    try {
      const auto axis = sweepAxis(word);
      if (!axis) continue;
      ++ranges;
      EXPECT_GE(axis->values.size(), 2u) << word;
      EXPECT_LE(axis->values.size(), word.size() + 100) << word;
      for (std::size_t k = 0; k < axis->values.size(); ++k) EXPECT_EQ(axis->override(k).find(axis->before), 0u);
    } catch (const core::Error& error) {
      EXPECT_EQ(error.kind(), core::ErrorKind::kUsage) << word;
    }
  }
  EXPECT_GT(ranges, 20);
}

}  // namespace
}  // namespace poinsot::scene
