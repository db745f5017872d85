// SPDX-License-Identifier: Apache-2.0
// Conversion of film time to motion time is compared with numerical quadrature of the pace.
#include "scene/motion/film_clock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

#include "core/error.h"
#include "support/extreme_times.h"

namespace poinsot::scene {
namespace {

TimelineEntry pace(double at_s, double over_s, double speed, double hold_s = 0) {
  TimelineEntry entry;
  entry.at_s = at_s;
  entry.over_s = over_s;
  entry.speed = speed;
  entry.hold_s = hold_s;
  return entry;
}

/// Returns a clock with slow motion, a hold, a change within a change, and a jump.
FilmClock variedClock() {
  return {5, -3, {{pace(2, 1, 0.2), pace(6, 0.5, 1, 2), pace(12, 2, 3), pace(13, 1, 0.5), pace(16, 0, 2)}, {}}};
}

/// Returns ∫ pace from 0 by Simpson's rule, in pieces that end where the pace's third derivative jumps.
double simpson(const FilmClock& clock, double to_s) {
  std::vector<double> ends = {0, 2, 3, 6, 6.5, 8.5, 9, 12, 13, 14, 16, to_s};
  std::sort(ends.begin(), ends.end());
  constexpr int kSteps = 4000;
  double sum = 0;
  for (std::size_t i = 1; i < ends.size() && ends[i] <= to_s; ++i) {
    const double h = (ends[i] - ends[i - 1]) / kSteps;
    for (int k = 0; k < kSteps; ++k) {
      const double a = ends[i - 1] + k * h;
      // At a jump the value from the left counts.
      sum += h / 6 * (clock.pace(a) + 4 * clock.pace(a + h / 2) + clock.pace(std::nextafter(a + h, 0)));
    }
  }
  return sum;
}

TEST(FilmClock, RunsExactlyLinearlyWithoutPaceChanges) {
  const FilmClock clock(0.25, 1.7, {});
  for (const double t : {0.0, 0.1, 1.0 / 3, 7.77, 3599.9}) {
    EXPECT_EQ(clock.played_s(t), t);
    EXPECT_EQ(clock.motionTime_s(t), 0.25 + 1.7 * t);
  }
}

TEST(FilmClock, PlayedTimeIsTheIntegralOfThePace) {
  const FilmClock clock = variedClock();
  for (const double t : {0.5, 2.0, 2.3, 3.0, 5.0, 6.2, 7.5, 8.7, 11.0, 12.5, 13.2, 15.0, 18.0}) {
    EXPECT_NEAR(clock.played_s(t), simpson(clock, t), 1e-11) << t;  // measured: at most 4.3e-12
    EXPECT_EQ(clock.motionTime_s(t), 5 - 3 * clock.played_s(t));
  }
}

// Worked by hand: a soft change from pace 1 to 0.2 has the mean pace 0.6, as a linear change.
TEST(FilmClock, MatchesValuesWorkedByHand) {
  const FilmClock slow(0, 1, {{pace(2, 1, 0.2)}, {}});
  EXPECT_NEAR(slow.played_s(3), 2 + 0.6, 1e-15);
  EXPECT_NEAR(slow.played_s(13), 2.6 + 10 * 0.2, 1e-14);
  EXPECT_DOUBLE_EQ(slow.pace(2.5), 0.6);
  EXPECT_DOUBLE_EQ(slow.pace(2.25), 1 - 0.8 * (0.15625 - 15 * 0.00390625 + 6 * 0.0009765625));  // x³(10-15x+6x²)
}

TEST(FilmClock, StopsDuringAHold) {
  const FilmClock clock = variedClock();
  for (double t = 6.5; t <= 8.5; t += 0.1) EXPECT_EQ(clock.played_s(t), clock.played_s(6.5)) << t;
  EXPECT_GT(clock.played_s(8.6), clock.played_s(8.5));
  EXPECT_EQ(clock.pace(10), 1);
}

TEST(FilmClock, NeverRunsBackwardsOrJumps) {
  const FilmClock clock = variedClock();
  const double h = 1e-3, fastest = clock.fastestPace();
  EXPECT_EQ(fastest, 3);
  for (double t = 0; t < 20; t += h) {
    const double step = clock.played_s(t + h) - clock.played_s(t);
    EXPECT_GE(step, 0) << t;
    EXPECT_LE(step, fastest * h * (1 + 1e-9)) << t;
    if (std::abs(t - 16) < 2 * h) continue;                                       // the jump
    EXPECT_NEAR(step, h * 0.5 * (clock.pace(t) + clock.pace(t + h)), 1e-8) << t;  // measured: at most 2.0e-9
  }
}

TEST(FilmClock, ChangesThePaceSmoothly) {
  const FilmClock clock(0, 1, {{pace(2, 1, 0.2), pace(5, 1, 1, 2)}, {}});
  constexpr double h = 1e-4;
  double last = 0, sharpest = 0;
  for (double t = h; t < 12; t += h) {
    const double slope = (clock.pace(t + h) - clock.pace(t)) / h;
    sharpest = std::max(sharpest, std::abs(slope - last));
    last = slope;
  }
  // The second derivative of x³ (10 - 15 x + 6 x²) is at most 10/√3. Measured: less by 4e-8 of that.
  EXPECT_LE(sharpest, (1 + 1e-6) * h * 10 / std::sqrt(3));
}

TEST(EasedTrack, StartsANewChangeFromTheCurrentValue) {
  EasedTrack track(1);
  track.turnTo(1, 2, 5);
  track.turnTo(2, 1, 0);
  EXPECT_DOUBLE_EQ(track.at(2), 3);
  EXPECT_DOUBLE_EQ(track.at(2.5), 1.5);
  EXPECT_EQ(track.at(3), 0);
  EXPECT_EQ(track.at(100), 0);
  EXPECT_EQ(track.greatest(), 5);
  EXPECT_EQ(track.target(), 0);
}

TEST(EasedTrack, RejectsChangesOutOfOrder) {
  EasedTrack track(0);
  track.turnTo(2, 1, 1);
  EXPECT_THROW(track.turnTo(1, 1, 0), std::logic_error);
  EXPECT_THROW(track.turnTo(3, -1, 0), std::logic_error);
}

// Film times may have any sign. Before 0 the film has the pace of time 0.
TEST(FilmClock, GivesFiniteTimesOrAnError) {
  const FilmClock fast(0, 1e20, {{pace(1, 0, 100)}, {}}), plain(5, -3, {}), still(0, 0, {{pace(1, 0, 100)}, {}});
  for (const FilmClock& clock : {variedClock(), fast, plain, still})
    for (const double t_s : extremeTimes()) {
      SCOPED_TRACE(t_s);
      try {
        EXPECT_TRUE(std::isfinite(clock.motionTime_s(t_s)));
      } catch (const core::Error& error) {
        EXPECT_EQ(error.kind(), core::ErrorKind::kLimit);
        EXPECT_GT(std::abs(t_s), 1e285);  // times 1e20 and 100 is beyond 1.8e308
      } catch (const std::logic_error&) {
        EXPECT_FALSE(std::isfinite(t_s));
      }
    }
}

/// Returns whether a span is one film time, to rounding.
void expectOnly(const std::optional<FilmSpan>& found, double film_s) {
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->from_s, film_s, 1e-13);
  EXPECT_NEAR(found->to_s, film_s, 1e-13);
}

// Without changes of speed, film time is (motion time - start)/speed.
TEST(FilmClock, InvertsAConstantSpeedOfEitherSign) {
  expectOnly(FilmClock(1, 0.25, {}).filmTimesOf(3, 20), 8);
  expectOnly(FilmClock(1, -0.25, {}).filmTimesOf(-1, 20), 8);
  expectOnly(FilmClock(1, -0.25, {}).filmTimesOf(1, 20), 0);
  expectOnly(FilmClock(1, 0.1, {}).filmTimesOf(1 + 0.1 * 7, 7), 7);  // the last frame, though 0.1 * 7 is rounded
  EXPECT_FALSE(FilmClock(1, 0.25, {}).filmTimesOf(0.99, 20));
  EXPECT_FALSE(FilmClock(1, -0.25, {}).filmTimesOf(1.01, 20));
  EXPECT_FALSE(FilmClock(1, 0.25, {}).filmTimesOf(6.01, 20));
}

// The clock holds the motion from film time 6.5 to 8.5, and again from 18 on.
TEST(FilmClock, InvertsSlowMotionAndHolds) {
  const FilmClock clock = variedClock();
  for (const double film_s : {0.0, 1.0, 2.7, 5.0, 6.2, 9.5, 12.5, 13.5, 17.0})
    expectOnly(clock.filmTimesOf(clock.motionTime_s(film_s), 20), film_s);
  const auto held = clock.filmTimesOf(clock.motionTime_s(7), 20);
  ASSERT_TRUE(held);
  EXPECT_NEAR(held->from_s, 6.5, 1e-4);  // the motion comes to rest smoothly
  EXPECT_NEAR(held->to_s, 8.5, 1e-4);
  EXPECT_EQ(clock.filmTimesOf(clock.motionTime_s(20), 20)->to_s, 20);
  EXPECT_FALSE(clock.filmTimesOf(clock.motionTime_s(20) - 0.1, 20));
}

TEST(FilmClock, ShowsOneMotionTimeInAFilmThatStandsStill) {
  const auto all = FilmClock(2, 0, {}).filmTimesOf(2, 5);
  ASSERT_TRUE(all);
  EXPECT_EQ(all->from_s, 0);
  EXPECT_EQ(all->to_s, 5);
  EXPECT_FALSE(FilmClock(2, 0, {}).filmTimesOf(2.1, 5));
}

}  // namespace
}  // namespace poinsot::scene
