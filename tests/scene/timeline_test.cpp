// SPDX-License-Identifier: Apache-2.0
// Timelines: their keys, the figures that they show, and errors with their places.
#include "scene/timeline.h"

#include <gmock/gmock.h>

#include <numbers>

#include "scene_testing.h"

namespace poinsot::scene {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr double kOneDegree = std::numbers::pi / 180;
const std::string kTop = "[body]\nprincipal_moments = [2, 2, 3]\n[motion]\nomega_body = [0.5, 0, 1]\n";  // 4 lines

Scene sceneWith(const std::string& extra, const std::vector<std::string>& overrides = {}) {
  return parseScene(kTop + extra, "test.toml", overrides);
}

std::string messagesWith(const std::string& extra) { return messagesOf(kTop + extra, {}); }

std::vector<std::string> namesOf(const std::vector<int>& things) {
  std::vector<std::string> names;
  for (const int thing : things) names.push_back(timelineThings()[static_cast<std::size_t>(thing)]);
  return names;
}

TEST(Timeline, ReadsAllKeys) {
  const Scene scene = sceneWith(
      "[[timeline]]\nat = 4\nover = \"2 s\"\nshow = [\"ellipsoid\", \"plane\"]\nhide = [\"body\"]\nspeed = 0.2\n"
      "hold = 1.5\ncamera.azimuth = \"400 deg\"\ncamera.elevation = \"60 deg\"\ncamera.zoom = 1.5\n");
  ASSERT_EQ(scene.timeline.entries.size(), 1u);
  const TimelineEntry& entry = scene.timeline.entries[0];
  EXPECT_EQ(entry.at_s, 4);
  EXPECT_EQ(entry.over_s, 2);
  EXPECT_THAT(namesOf(entry.shown), ElementsAre("ellipsoid", "plane"));
  EXPECT_THAT(namesOf(entry.hidden), ElementsAre("body"));
  EXPECT_EQ(entry.speed, 0.2);
  EXPECT_EQ(entry.hold_s, 1.5);
  EXPECT_DOUBLE_EQ(*entry.azimuth_rad, 400 * kOneDegree);
  EXPECT_DOUBLE_EQ(*entry.elevation_rad, 60 * kOneDegree);
  EXPECT_EQ(entry.zoom, 1.5);
  EXPECT_EQ(entry.turn_rad, 0);
}

TEST(Timeline, IsEmptyByDefault) {
  EXPECT_TRUE(sceneWith("").timeline.entries.empty());
  EXPECT_TRUE(sceneWith("").timeline.captions.empty());
}

TEST(Timeline, IsSortedByTime) {
  const Scene scene = sceneWith("[[timeline]]\nat = 7\n[[timeline]]\nat = 2\n[[timeline]]\nat = 7\nover = 3\n",
                                {"timeline[0].over=0.5"});
  ASSERT_EQ(scene.timeline.entries.size(), 3u);
  EXPECT_EQ(scene.timeline.entries[0].at_s, 2);
  EXPECT_EQ(scene.timeline.entries[0].over_s, 0.8);
  EXPECT_EQ(scene.timeline.entries[1].over_s, 0.5);
  EXPECT_EQ(scene.timeline.entries[2].over_s, 3);
}

TEST(Timeline, EnablesTheFiguresThatItShows) {
  const Scene scene = sceneWith("[[timeline]]\nat = 1\nshow = [\"cones\", \"theta\"]\n");
  EXPECT_TRUE(scene.views[0].show.figures.cones.visible);
  EXPECT_TRUE(scene.views[0].show.figures.theta.visible);
  EXPECT_FALSE(scene.views[0].show.figures.trace.visible);
  const Scene said = sceneWith("[show]\ncones = false\n[[timeline]]\nat = 1\nshow = [\"cones\"]\n");
  EXPECT_FALSE(said.views[0].show.figures.cones.visible);
}

TEST(Timeline, AppliesOnlyToViewsThatShowTheFigure) {
  const Scene scene =
      sceneWith("[[view]]\n[[view]]\nshow.cones = false\n[[timeline]]\nat = 1\nshow = [\"cones\"]\n");
  EXPECT_TRUE(scene.views[0].show.figures.cones.visible);
  EXPECT_FALSE(scene.views[1].show.figures.cones.visible);
}

TEST(Timeline, KeepsCaptionsUntilTheNextOne) {
  const Scene scene = sceneWith(
      "[[timeline]]\nat = 1\ncaption = \"A\"\n[[timeline]]\nat = 3\ncaption = \"B\"\ncaption_for = 2\n"
      "[[timeline]]\nat = 7\ncaption = \"C\"\n[[timeline]]\nat = 8\ncaption = \"\"\n"
      "[[timeline]]\nat = 9\ncaption = \"D\"\ncaption_for = 5\n");
  const std::vector<Caption>& captions = scene.timeline.captions;
  ASSERT_EQ(captions.size(), 4u);
  const std::vector<std::array<double, 2>> expected = {{1, 3}, {3, 5}, {7, 8}, {9, 10}};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(captions[i].from_s, expected[i][0]);
    EXPECT_EQ(captions[i].to_s, expected[i][1]);
    EXPECT_EQ(captions[i].text, std::string(1, static_cast<char>('A' + i)));
  }
}

TEST(Timeline, RefusesATimeBeyondTheFilm) {
  EXPECT_THAT(messagesWith("[[timeline]]\nat = 10.5\n"),
              StartsWith("timeline[0].at: must lie within the film, which ends at 10 s, got 10.5 s"));
  EXPECT_EQ(messagesWith("[[timeline]]\nat = 10\n"), "");
}

TEST(Timeline, SkipsTheCheckOfTimesIfTheDurationIsWrong) {
  for (const char* time : {"[Time]\nduration = 60\n", "[time]\ndurtion = 60\n", "[time]\nduration = \"60\"\n"}) {
    const std::string messages = messagesWith(std::string(time) + "[[timeline]]\nat = 30\nhold = 40\n");
    EXPECT_THAT(messages, HasSubstr("ime")) << time;
    EXPECT_THAT(messages, Not(HasSubstr("timeline"))) << time;
  }
}

TEST(Timeline, RefusesAnEntryWithoutATime) {
  EXPECT_THAT(messagesWith("[[timeline]]\ncaption = \"A\"\n"), HasSubstr("timeline[0]: at is required"));
}

TEST(Timeline, SuggestsTheFigureForAMisspeltName) {
  try {
    sceneWith("[[timeline]]\nat = 1\nshow = [\"plane\", \"elipsoid\"]\n");
    FAIL() << "accepted";
  } catch (const SceneErrors& errors) {
    ASSERT_EQ(errors.problems().size(), 1u);
    EXPECT_EQ(errors.problems()[0].where.line, 7);
    EXPECT_EQ(errors.problems()[0].where.column, 18);
    EXPECT_THAT(errors.problems()[0].message, HasSubstr("did you mean \"ellipsoid\"?"));
  }
}

TEST(Timeline, RefusesContradictions) {
  EXPECT_THAT(messagesWith("[[timeline]]\nat = 1\nshow = [\"plane\"]\nhide = [\"plane\"]\n"),
              HasSubstr("timeline[0].hide: \"plane\" is in both show and hide of this entry"));
  EXPECT_THAT(messagesWith("[[timeline]]\nat = 1\ncaption_for = 3\n"),
              HasSubstr("has no effect without a caption"));
  EXPECT_THAT(messagesWith("[[timeline]]\nat = 1\ncamera = {azimuth = 1, turn = 1}\n"),
              HasSubstr("timeline[0].camera.turn: cannot be combined with camera.azimuth"));
}

TEST(Timeline, ChecksCaptionsAsTex) {
  const auto check = [](std::string_view text) { return text == "wrong" ? std::string("no such command") : ""; };
  EXPECT_THROW(parseScene(kTop + "[[timeline]]\nat = 1\ncaption = \"wrong\"\n", "test.toml", {}, check),
               SceneErrors);
  EXPECT_NO_THROW(parseScene(kTop + "[[timeline]]\nat = 1\ncaption = \"right\"\n", "test.toml", {}, check));
}

TEST(Timeline, AcceptsTheNameOfEveryFigure) {
  EXPECT_THAT(timelineThings(),
              testing::IsSupersetOf({"body", "principal_axes", "L", "omega", "ellipsoid", "plane", "contact",
                                     "polhode", "herpolhode", "height", "cones", "trace", "labels", "title"}));
}

TEST(Camera, ReadsTheOrbitAngle) {
  EXPECT_DOUBLE_EQ(sceneWith("[camera]\norbit = \"-20 deg\"\n").camera.orbit_rad, -20 * kOneDegree);
}

}  // namespace
}  // namespace poinsot::scene
