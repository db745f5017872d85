// SPDX-License-Identifier: Apache-2.0
// Times are written by hand, rounded as containers round them: WebM to 1 ms, GIF to 1/100 s, FFmpeg's APNG to 10
// us a frame.
#include "compare/film_times.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace poinsot::compare {
namespace {

constexpr double kExact_s = 1.0 / 15360;  // the time base of an MP4

FilmTimes film(int frames, double step_s, const std::function<double(int)>& start_s, double last_s = 0) {
  FilmTimes times(step_s);
  for (int i = 0; i < frames; ++i) times.add({{}, start_s(i), last_s});
  return times;
}

FilmTimes at30(int frames = 90) {
  return film(
      frames, kExact_s, [](int i) { return i / 30.0; }, 1 / 30.0);
}

double rounded(double t_s, double step_s) { return std::round(t_s / step_s) * step_s; }

TEST(FilmTimes, AllowTheRoundingOfContainers) {
  const auto thirtieth = [](int i) { return i / 30.0; };
  EXPECT_EQ(timesMismatch(at30(), film(
                                      90, 1e-3, [&](int i) { return rounded(thirtieth(i), 1e-3); }, 0.033)),
            "");
  EXPECT_EQ(timesMismatch(at30(), film(
                                      90, 1e-2, [&](int i) { return rounded(thirtieth(i), 1e-2); }, 0.03)),
            "");
  EXPECT_EQ(timesMismatch(at30(10000), film(
                                           10000, 1e-5, [](int i) { return i * 0.03333; }, 0.03333)),
            "");
  // An MP4 may start at another time, and have the milliseconds of a WebM.
  EXPECT_EQ(timesMismatch(at30(), film(90, kExact_s, [&](int i) { return 5 + rounded(thirtieth(i), 1e-3); })), "");
  EXPECT_EQ(timesMismatch(at30(), film(90, kExact_s, [](int) { return std::nan(""); })), "");
}

TEST(FilmTimes, NameTheFirstFrameWithAnotherTime) {
  const auto resting = film(90, kExact_s, [](int i) { return i / 30.0 + (i >= 45 ? 2 : 0); });
  EXPECT_EQ(timesMismatch(at30(), resting), "frame 45 is at 3.5 s, not 1.5 s");
  EXPECT_EQ(timesMismatch(resting, at30()), "frame 45 is at 1.5 s, not 3.5 s");
  // One frame is late by 0.9 of a frame, amid others that are right.
  EXPECT_EQ(timesMismatch(at30(), film(90, kExact_s, [](int i) { return (i == 7 ? 7.9 : i) / 30; })),
            "frame 7 is at 0.263 s, not 0.233 s");
}

TEST(FilmTimes, NameTheFrameRatesIfConstant) {
  EXPECT_EQ(timesMismatch(at30(), film(90, kExact_s, [](int i) { return i / 10.0; })),
            "the film has 10 frames a second, not 30");
  EXPECT_EQ(timesMismatch(at30(), film(90, kExact_s, [](int i) { return i * 1001.0 / 24000; })),
            "the film has 23.98 frames a second, not 30");
}

// In an AVI, or in an MP4 whose time scale is its rate, a frame is a single unit of time.
TEST(FilmTimes, DistinguishRatesIfAFrameIsOneUnitOfTime) {
  const auto steady = [](int frames, double fps) {
    return film(
        frames, 1 / fps, [=](int i) { return i / fps; }, 1 / fps);
  };
  EXPECT_EQ(timesMismatch(steady(10, 25), steady(10, 25)), "");
  EXPECT_EQ(timesMismatch(steady(10, 25), steady(10, 20)), "the film has 20 frames a second, not 25");
  EXPECT_EQ(timesMismatch(steady(10, 25), steady(10, 30)), "the film has 30 frames a second, not 25");
  EXPECT_EQ(timesMismatch(steady(45, 24), steady(45, 25)), "the film has 25 frames a second, not 24");
  EXPECT_EQ(timesMismatch(steady(10, 25), film(10, 1 / 25.0, [](int i) { return (i < 5 ? i : i + 1) / 25.0; })),
            "frame 5 is at 0.24 s, not 0.2 s");
  // Two GIFs of two pictures.
  EXPECT_NE(
      timesMismatch(film(2, 0.01, [](int i) { return 0.02 * i; }), film(2, 0.01, [](int i) { return 0.03 * i; })),
      "");
}

TEST(FilmTimes, CompareTheLastFrame) {
  const auto start_s = [](int i) { return i / 30.0; };
  EXPECT_EQ(timesMismatch(at30(), film(90, kExact_s, start_s, 2)), "the last frame is shown for 2 s, not 0.033 s");
  EXPECT_EQ(timesMismatch(at30(), film(90, kExact_s, start_s, 0)), "");  // duration unknown
  EXPECT_EQ(timesMismatch(at30(), film(80, kExact_s, start_s, 2)), "");  // the number of frames differs
  EXPECT_EQ(timesMismatch(film(1, kExact_s, start_s, 1), film(1, kExact_s, start_s, 3)),
            "the last frame is shown for 3 s, not 1 s");
}

}  // namespace
}  // namespace poinsot::compare
