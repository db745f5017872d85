// SPDX-License-Identifier: Apache-2.0
#include "job/progress.h"

#include <gtest/gtest.h>

#include <vector>

namespace poinsot::job {
namespace {

constexpr ProgressState kHalf{150, 300, 5.0, 37.5}, kFirst{1, 300, 0.5, 0}, kAll{300, 300, 9.0, 37.5};

TEST(Progress, TimesAreRoundedUpToSeconds) {
  EXPECT_EQ(clockText(0), "0:00");
  EXPECT_EQ(clockText(6.2), "0:07");
  EXPECT_EQ(clockText(59.5), "1:00");
  EXPECT_EQ(clockText(754), "12:34");
  EXPECT_EQ(clockText(3723), "1:02:03");
  EXPECT_EQ(clockText(-1), "-:--");
}

TEST(Progress, LinesGiveRateAndTimeLeft) {
  EXPECT_EQ(plainLine(kHalf), "150 of 300 frames (50 %), 37.5 frames/s, 0:04 left");
  EXPECT_EQ(plainLine(kFirst), "1 of 300 frames (0 %), 0.0 frames/s, -:-- left");
  EXPECT_EQ(
      jsonLine(kHalf),
      R"({"event":"progress","done":150,"total":300,"elapsed_s":5.000,"frames_per_second":37.500,"left_s":4.000})");
  EXPECT_EQ(
      jsonLine(kFirst),
      R"({"event":"progress","done":1,"total":300,"elapsed_s":0.500,"frames_per_second":0.000,"left_s":null})");
}

TEST(Progress, EventOfAFailureNamesFileAndErrno) {
  const core::FileError error(core::ErrorKind::kIo, "full", "a\"\xff.mp4", 28);  // U+00FF stands for the byte 0xff
  EXPECT_EQ(jsonLine(error), R"({"event":"failed","errno":28,"file":"a\"ÿ.mp4"})");
}

TEST(Progress, BarFillsAndFitsTheTerminal) {
  // 79 columns less 48 for the figures and 2 for the brackets leave 29 cells, of which half are 14.
  EXPECT_EQ(barLine(kHalf, 79), "[==============>              ]  50 %  150/300 frames  37.5 frames/s  0:04 left");
  EXPECT_EQ(barLine(kAll, 200).substr(0, 43), "[" + std::string(40, '=') + "] ");
  EXPECT_EQ(barLine(kHalf, 59), " 50 %  150/300 frames  37.5 frames/s  0:04 left");
  for (int columns = 0; columns < 120; ++columns)
    EXPECT_LE(barLine(kHalf, columns).size(), static_cast<std::size_t>(columns));
}

TEST(Progress, StyleFollowsTheTerminal) {
  EXPECT_EQ(progressStyle("auto", true), ProgressStyle::kBar);
  EXPECT_EQ(progressStyle("auto", false), ProgressStyle::kPlain);
  EXPECT_EQ(progressStyle("plain", true), ProgressStyle::kPlain);
  EXPECT_EQ(progressStyle("json", true), ProgressStyle::kJson);
  EXPECT_EQ(progressStyle("none", true), ProgressStyle::kNone);
}

/// Returns what is written if the first of ten frames takes two seconds and each other frame takes one. 10 frames
/// in 11 s are 0.9 a second.
std::vector<std::string> tenSeconds(ProgressStyle style) {
  std::vector<std::string> written;
  Progress progress(style, 10, 80, [&](std::string_view text) { written.emplace_back(text); });
  for (int done = 1; done <= 10; ++done) progress.update(done, 0, done + 1);
  progress.end();
  progress.end();
  return written;
}

TEST(Progress, PlainStyleWritesEveryFiveSecondsAndAtTheEnd) {
  EXPECT_EQ(tenSeconds(ProgressStyle::kPlain),
            (std::vector<std::string>{"poinsot: 4 of 10 frames (40 %), 1.0 frames/s, 0:06 left\n",
                                      "poinsot: 9 of 10 frames (90 %), 1.0 frames/s, 0:01 left\n",
                                      "poinsot: 10 of 10 frames (100 %), 0.9 frames/s, 0:00 left\n"}));
}

TEST(Progress, BarRedrawsInPlaceAndEndsItsLineOnce) {
  const auto written = tenSeconds(ProgressStyle::kBar);
  ASSERT_EQ(written.size(), 11u);
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_EQ(written[i].front(), '\r');
    EXPECT_EQ(written[i].find('\n'), std::string::npos);
  }
  EXPECT_EQ(written.back(), "\n");
}

TEST(Progress, NoneStyleIsSilentAndJsonStyleWritesLines) {
  EXPECT_TRUE(tenSeconds(ProgressStyle::kNone).empty());
  const auto lines = tenSeconds(ProgressStyle::kJson);
  ASSERT_EQ(lines.size(), 10u);
  EXPECT_EQ(lines.back().back(), '\n');
}

TEST(Progress, LastFrameIsAlwaysShown) {
  std::vector<std::string> written;
  Progress progress(ProgressStyle::kPlain, 2, 80, [&](std::string_view text) { written.emplace_back(text); });
  progress.update(1, 0, 0.1);
  progress.update(2, 0, 0.25);
  EXPECT_EQ(written, std::vector<std::string>{"poinsot: 2 of 2 frames (100 %), 8.0 frames/s, 0:00 left\n"});
}

}  // namespace
}  // namespace poinsot::job
