// SPDX-License-Identifier: Apache-2.0
// Moments of a timeline: film times, motion times and events. A flight gives expected values on paper: with
// V_z = 4.905 m/s and g = 9.81 m/s², the highest point is at 0.5 s and the catch at 1 s. A change of speed that
// takes the film time `over` shows, by symmetry, as much motion as the mean of both speeds.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "scene/event_kinds.h"
#include "scene/motion/film_clock.h"
#include "scene/motion/make_motion.h"
#include "scene/motion/scene_events.h"
#include "scene_testing.h"

namespace poinsot::scene {
namespace {

using testing::HasSubstr;

constexpr double kRounding_s = 1e-14;  // measured: at most 2e-16
const std::string kThrow =
    "[body]\nshape = \"box\"\nsize = [0.3, 0.2, 0.1]\nmass = 1\n[motion]\nomega_body = [0, 0, 3]\n"
    "[motion.flight]\nvelocity = [0, 0, 4.905]\ngravity = [0, 0, -9.81]\n[time]\nspeed = 1\nduration = 6\n";
const std::string kFlips =
    "[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [0.01, 3, 0]\n[time]\nspeed = 1\n"
    "duration = 120\n";

std::string entry(const std::string& keys) { return "[[timeline]]\n" + keys; }

Scene sceneOf(const std::string& text) { return parseScene(text, "test.toml"); }

FilmClock clockOf(const Scene& scene) { return {scene.time.start_s, chosenSpeed(scene), scene.timeline}; }

/// Returns the entry that is number `place` in the scene file.
const TimelineEntry& entryOf(const Scene& scene, std::size_t place) {
  const auto found = std::ranges::find(scene.timeline.entries, place, &TimelineEntry::place);
  if (found == scene.timeline.entries.end()) throw std::runtime_error("no such entry");
  return *found;
}

double omegaMid(const Scene& scene, double motion_s) {
  return makeMotion(scene, scene.time.start_s, motion_s)->at(motion_s).omega_B.y();
}

TEST(Moments, OfEventsAreWhereTheFilmShowsThem) {
  const Scene scene =
      sceneOf(kThrow + entry("at = \"highest_point\"\nspeed = 0.5\nover = 0\n") + entry("at = \"catch 1\"\n"));
  EXPECT_NEAR(entryOf(scene, 0).at_s, 0.5, kRounding_s);
  EXPECT_NEAR(entryOf(scene, 1).at_s, 0.5 + 0.5 / 0.5, kRounding_s);
}

TEST(Moments, OfFlipsAreZerosOfOmegaAlongTheMiddleAxis) {
  const Scene scene = sceneOf(kFlips + entry("at = \"flip 3\"\n") + entry("at = \"flip 1\"\nspeed = 0.3\n") +
                              entry("at = \"flip 2\"\nspeed = 1\n"));
  EXPECT_LT(entryOf(scene, 1).at_s, entryOf(scene, 2).at_s);
  EXPECT_LT(entryOf(scene, 2).at_s, entryOf(scene, 0).at_s);
  for (const TimelineEntry& at : scene.timeline.entries) {
    const double motion_s = clockOf(scene).motionTime_s(at.at_s);
    EXPECT_LT(omegaMid(scene, motion_s - 1e-9) * omegaMid(scene, motion_s + 1e-9), 0) << at.place;
  }
}

TEST(Moments, AreThoseOfTheListOfEvents) {
  const Scene scene = sceneOf(kFlips + entry("at = \"flip 2\"\nspeed = 0.3\n") + entry("at = \"flip 3\"\n"));
  const FilmClock clock = clockOf(scene);
  const double end_s = clock.motionTime_s(scene.time.duration_s);
  std::vector<double> flips;
  for (const SceneEvent& event : sceneEvents(scene, *makeMotion(scene, 0, end_s), clock, {0, end_s}))
    if (eventKinds()[static_cast<std::size_t>(event.kind)].word == "flip") flips.push_back(event.film->from_s);
  ASSERT_GE(flips.size(), 3u);
  EXPECT_EQ(entryOf(scene, 0).at_s, flips[1]);
  EXPECT_EQ(entryOf(scene, 1).at_s, flips[2]);
}

TEST(Moments, AreCountedInTheDirectionOfTheFilm) {
  const std::string backwards = kFlips + "start = 20\n" + entry("at = \"flip 2\"\n");
  const Scene scene = parseScene(backwards, "test.toml", {"time.speed=-1"});
  const double motion_s = 20 - entryOf(scene, 0).at_s;
  int signs = 0;  // changes of sign from 20 s back to the moment
  for (double t_s = 20; t_s > motion_s + 1e-9; t_s -= 0.01)
    signs += omegaMid(scene, t_s) * omegaMid(scene, std::max(t_s - 0.01, motion_s + 1e-9)) < 0;
  EXPECT_EQ(signs, 1);
  EXPECT_LT(omegaMid(scene, motion_s - 1e-9) * omegaMid(scene, motion_s + 1e-9), 0);
}

TEST(Moments, OfMotionTimesFollowTheSpeed) {
  const Scene scene = sceneOf(kThrow + entry("at = 2\nspeed = 0.5\nover = 0\n") + entry("at_motion = 3.5\n") +
                              entry("at_motion = 0.25\n"));
  EXPECT_NEAR(entryOf(scene, 1).at_s, 2 + 1.5 / 0.5, kRounding_s);
  EXPECT_NEAR(entryOf(scene, 2).at_s, 0.25, kRounding_s);
}

TEST(Moments, BeginAtTheFirstFilmTimeOfAStandstill) {
  const Scene scene = sceneOf(kThrow + entry("at = 0.1\nover = 0\nhold = 2\n") + entry("at_motion = 0.1\n"));
  EXPECT_NEAR(entryOf(scene, 1).at_s, 0.1, kRounding_s);
}

TEST(Moments, AreInTheMiddleOfSlowMotionAround) {
  const Scene scene = sceneOf(kThrow + entry("around = \"catch\"\nspeed = 0.1\nover = 0.4\nspeed_for = 2\n"));
  const double shown = 0.4 * (1 + 0.1) / 2 + 0.1 * 1;  // motion from the begin to the middle
  const TimelineEntry& slow = entryOf(scene, 0);
  EXPECT_NEAR(slow.at_s, 1 - shown, kRounding_s);
  EXPECT_NEAR(clockOf(scene).motionTime_s(slow.at_s + 0.4 + 1), 1, kRounding_s);
  EXPECT_NEAR(clockOf(scene).pace(slow.at_s + 0.4 + 2 + 0.4), 1, kRounding_s);
}

TEST(Moments, StandStillInThePauseAround) {
  const Scene scene = sceneOf(kThrow + entry("around = \"catch\"\nhold = 2\nover = 0.4\n"));
  EXPECT_NEAR(entryOf(scene, 0).at_s, 1 - 0.4 / 2, kRounding_s);
  for (const double film_s : {1.21, 2.0, 3.19}) EXPECT_NEAR(clockOf(scene).motionTime_s(film_s), 1, kRounding_s);
}

TEST(Moments, AroundAFilmTimeNeedNoMotion) {
  const Scene scene = sceneOf(kThrow + entry("around = 3\nspeed = 0.1\nover = 0.4\n"));
  EXPECT_NEAR(entryOf(scene, 0).at_s, 3 - 0.4 - 1, kRounding_s);  // half of the default 2 s
}

TEST(Moments, ReturnToTheSpeedBefore) {
  const Scene scene = sceneOf(kThrow + entry("at = 1\nspeed = 2\nover = 0\n") +
                              entry("at = 2\nspeed = 0.25\nover = 0\nspeed_for = 1\n"));
  EXPECT_EQ(clockOf(scene).pace(2.5), 0.25);
  EXPECT_EQ(clockOf(scene).pace(3.5), 2);
  EXPECT_NEAR(clockOf(scene).motionTime_s(4), 1 + 2 + 0.25 + 2, kRounding_s);
}

TEST(Moments, MayBeReachedOnlyByFastMotion) {
  const Scene scene =
      sceneOf(kThrow + entry("at = \"catch\"\n") + entry("at = 0.5\nspeed = 0.01\nover = 0\nspeed_for = 4\n") +
              entry("at_motion = 0.545\nspeed = 10\nover = 0\n"));
  EXPECT_NEAR(entryOf(scene, 2).at_s, 4.5 + 0.005, kRounding_s);
  EXPECT_NEAR(entryOf(scene, 0).at_s, 4.505 + 0.455 / 10, kRounding_s);
}

TEST(Moments, PlaceCaptionsAndTheirEnds) {
  const Scene scene = sceneOf(kThrow + entry("at = \"catch\"\ncaption = \"caught\"\ncaption_for = 2\n") +
                              entry("at = \"highest_point\"\ncaption = \"highest\"\n"));
  ASSERT_EQ(scene.timeline.captions.size(), 2u);
  EXPECT_EQ(scene.timeline.captions[0].text, "highest");
  EXPECT_NEAR(scene.timeline.captions[0].to_s, 1, kRounding_s);
  EXPECT_NEAR(scene.timeline.captions[1].to_s, 3, kRounding_s);
}

TEST(Moments, HoldInALoop) {
  const std::string text = kFlips + "loop = true\n" + entry("around = \"flip 1\"\nspeed = 0.2\n") +
                           entry("at = \"flip 2\"\ncaption = \"again\"\n");
  const Scene scene = sceneOf(text);
  ASSERT_TRUE(scene.time.loop);
  const FilmClock clock = clockOf(scene);
  EXPECT_NEAR(std::abs(clock.motionTime_s(scene.time.duration_s)), scene.time.loop->period_s,
              1e-12 * scene.time.loop->period_s);  // measured 2e-16
  const TimelineEntry& slow = entryOf(scene, 0);
  for (const double film_s : {slow.at_s + slow.over_s + 1, entryOf(scene, 1).at_s}) {
    const double motion_s = clock.motionTime_s(film_s);
    EXPECT_LT(omegaMid(scene, motion_s - 1e-9) * omegaMid(scene, motion_s + 1e-9), 0);
  }
}

TEST(Moments, AreRefusedWithTheMomentsThatTheFilmHas) {
  const auto messages = [](const std::string& keys) { return messagesOf(kThrow + keys); };
  EXPECT_EQ(messages(entry("at = \"catch 9\"\n")),
            "timeline[0].at: the film has no catch 9; it has highest_point 1, catch 1\n");
  EXPECT_EQ(messages(entry("at = \"flip 1\"\n")),
            "timeline[0].at: the film has no flip 1; it has highest_point 1, catch 1\n");
  EXPECT_EQ(messagesOf("[body]\nprincipal_moments = [1, 1, 2]\n[motion]\nomega_body = [1, 0, 2]\n" +
                       entry("at = \"flip 2\"\n")),
            "timeline[0].at: the film has no flip 2; it has no events\n");
  EXPECT_THAT(
      messages(entry("at = \"flop 2\"\n")),
      HasSubstr("expected a time, or an event and its number, such as \"flip 1\" (events are flip, reversal, "
                "separatrix, least_tilt, largest_tilt, highest_point, catch), got \"flop 2\""));
  for (const char* wrong : {"\"flip 0\"", "\"flip -1\"", "\"flip two\"", "\"flip 1 2\"", "\"\"", "\" flip\""})
    EXPECT_THAT(messages(entry(std::string("at = ") + wrong + "\n")), HasSubstr("an event and its number"))
        << wrong;
  EXPECT_EQ(messages(entry("at_motion = 8\n")),
            "timeline[0].at_motion: the film shows the motion from 0 s to 6 s, got 8 s\n");
  EXPECT_EQ(messagesOf(kFlips + entry("at = \"flip 1\"\n"), {"time.speed=0"}),
            "timeline[0].at: the motion stands still, because time.speed is 0; give a film time\n");
}

TEST(Moments, AreRefusedIfKeysContradict) {
  const auto messages = [](const std::string& keys) { return messagesOf(kThrow + keys); };
  EXPECT_EQ(messages(entry("at = 1\naround = \"catch\"\nspeed = 0.5\n")),
            "timeline[0].around: timeline[0].at is given too; an entry has one moment\n");
  EXPECT_EQ(messages(entry("around = \"catch\"\ncaption = \"x\"\n")),
            "timeline[0].around: needs a slow motion or a pause to be in its middle; give speed or hold\n");
  EXPECT_EQ(messages(entry("at = 1\nspeed_for = 2\n")),
            "timeline[0].speed_for: has no effect without a speed; give speed too\n");
  EXPECT_EQ(messages(entry("at = 1\nspeed = 0.5\nspeed_for = 2\nhold = 1\n")),
            "timeline[0].hold: cannot be combined with speed_for; give one of the two\n");
  EXPECT_EQ(
      messages(entry("around = \"catch\"\nspeed = 0.5\nspeed_for = 5\n")),
      "timeline[0].around: would begin before the film, because its slow motion needs 3.3 s up to its middle; "
      "shorten speed_for or over\n");
  EXPECT_EQ(messages(entry("around = \"catch\"\nspeed = 0.1\nspeed_for = 2\nover = 0.4\n") +
                     entry("at = 3\nspeed = 3\n")),
            "timeline[1].at: changes the speed at 3 s, but the slow motion of timeline[0] lasts from 0.68 s to "
            "3.48 s\n");
}

// Each pair overlaps for some lengths only, so the result must not depend on how the search runs.
TEST(Moments, AroundDifferentEventsFollowEachOther) {
  for (const double speedFor_s : {1.0, 1.5, 2.0, 2.5, 3.0, 4.0})
    for (const double duration_s : {9.0, 9.3, 12.0}) {
      const Scene scene =
          parseScene(kThrow +
                         entry("around = \"highest_point\"\nspeed = 0.1\nover = 0.1\nspeed_for = " +
                               std::to_string(speedFor_s) + "\n") +
                         entry("around = \"catch\"\nhold = 2\nover = 0.2\n"),
                     "test.toml", {"time.duration=" + std::to_string(duration_s)});
      const TimelineEntry &slow = entryOf(scene, 0), &pause = entryOf(scene, 1);
      EXPECT_NEAR(clockOf(scene).motionTime_s(slow.at_s + 0.1 + speedFor_s / 2), 0.5, kRounding_s);
      EXPECT_NEAR(clockOf(scene).motionTime_s(pause.at_s + 0.2 + 1), 1, kRounding_s);
    }
}

TEST(Moments, DoNotBeginInAPause) {
  const std::string slow = entry("around = \"catch\"\nspeed = 0.1\nover = 0.1\n");
  EXPECT_EQ(messagesOf(kThrow + entry("at = 0\nhold = 2\n") + slow), "");
  EXPECT_EQ(
      messagesOf(kThrow + entry("at = 0.6\nover = 0.4\nhold = 2\n") + slow),
      "timeline[1].around: would begin while the slow motion or pause of timeline[0] lasts, from 0.6 s to 3.4 s; "
      "shorten one of the two\n");
  EXPECT_EQ(messagesOf(kThrow + entry("at = 1\nhold = 2\n") + entry("at = 2\nspeed = 0.5\n")),
            "timeline[1].at: changes the speed at 2 s, but the pause of timeline[0] lasts from 1 s to 4.6 s\n");
}

TEST(Moments, OfShortCaptionsAreNoted) {
  const std::string text = kThrow + entry("at = 0\ncaption = \"six words that nobody can read\"\n") +
                           entry("at = 1\ncaption = \"next\"\n");
  const Scene scene = sceneOf(text);
  ASSERT_EQ(scene.doubts.size(), 1u);
  EXPECT_THAT(scene.doubts[0].message,
              HasSubstr("timeline[0].caption: is shown for only 1 s, which is short for 6 words"));
}

TEST(Moments, AreNotLookedUpInAFaultyScene) {
  const std::string text =
      "[body]\nprincipal_moments = [1, 2, 9]\n[motion]\nomega_body = [0.01, 3, 0]\n" + entry("at = \"flip 9\"\n");
  EXPECT_EQ(problemsOf(text).size(), 1u) << messagesOf(text);
}

}  // namespace
}  // namespace poinsot::scene
