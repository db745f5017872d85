// SPDX-License-Identifier: Apache-2.0
// Messages about a wrong -D. An override has no line, so that the message names the override itself.
#include <gmock/gmock.h>

#include "scene/document/problem.h"
#include "scene_testing.h"

namespace poinsot::scene {
namespace {

using testing::HasSubstr;

// Without columns, an override's two wrong numbers have equal messages, which are reported once.
TEST(Overrides, ReportEqualMistakesOnce) {
  EXPECT_EQ(
      messagesOf(kMinimal, {"output.size=[100000, 100000]"}),
      "output.size: each side must be from 16 to 8192 pixels, got 100000; --limit side=N raises the limit\n");
  EXPECT_EQ(problemsOf(kMinimal, {"output.size=[100000, 100001]"}).size(), 2U);
}

TEST(Overrides, ErrorsQuoteTheOverride) {
  const auto problems = problemsOf(kMinimal, {"body.mass=abc", "time.fps", "camera.zom=2", "output.size=[1, 2"});
  std::string text;
  for (const Problem& problem : problems) text += toString(problem) + "\n";
  EXPECT_THAT(
      text,
      HasSubstr("-D body.mass=abc: error: body.mass: expected a mass in one of kg, g, mg, t, lb, oz, slug, u "
                "(poinsot explain units lists all), got \"abc\"\n"));
  EXPECT_THAT(text, HasSubstr("-D time.fps: error: expected -D key.path=value\n"));
  EXPECT_THAT(text, HasSubstr("-D camera.zom=2: error: camera.zom: unknown key; did you mean camera.zoom?\n"));
  EXPECT_THAT(text, HasSubstr("-D output.size=[1, 2: error: not TOML: "));
}

TEST(Overrides, SuggestTheNearestTableForAnUnknownOne) {
  EXPECT_EQ(messagesOf(kMinimal, {"tim.x=3"}), "tim.x: unknown table [tim]; did you mean [time]?\n");
  EXPECT_EQ(messagesOf(kMinimal, {"show.plan.grid=true"}),
            "show.plan.grid: unknown table [show.plan]; did you mean [show.plane]?\n");
  EXPECT_EQ(messagesOf(kMinimal, {"show.labels.x=3"}),
            "show.labels.x: unknown key; show.labels is true or false, and has no keys below it\n");
  EXPECT_THAT(
      messagesOf(kMinimal, {"show.qqqqqqqqqqqq.q=3"}),
      HasSubstr("unknown table [show.qqqqqqqqqqqq]; [show] has the tables body, principal_axes, L, omega"));
  EXPECT_EQ(messagesOf(kMinimal, {"qqqqqqqqqqqq.fps=3"}),
            "qqqqqqqqqqqq.fps: unknown key; did you mean time.fps?\n");
  EXPECT_EQ(messagesOf(kMinimal, {"qqqqqqqqqqqq.zzz=3"}),
            "qqqqqqqqqqqq.zzz: unknown table [qqqqqqqqqqqq]; a scene has the tables body, motion, time, camera, "
            "show, mark, view, label, vector, angle, plot, readout, note, timeline, style, output\n");
  EXPECT_EQ(messagesOf(kMinimal, {"motion.omega_body.x=3"}),
            "motion.omega_body.x: unknown key; motion.omega_body is an array of three angular velocities, and has "
            "no keys below it\n");
}

TEST(Overrides, CannotSetASingleElementOfAVector) {
  EXPECT_EQ(messagesOf(kMinimal, {"motion.omega_body[1]=3"}),
            "motion.omega_body[1]: a single element cannot be set; give the whole array, such as "
            "motion.omega_body=[0.01, \"3 rpm\", 0]\n");
}

TEST(Overrides, MayHaveBlanksAroundTheEqualsSign) {
  EXPECT_FALSE(parseScene(kMinimal, "test.toml", {"show.plane = false"}).show.plane.visible);
  EXPECT_EQ(parseScene(kMinimal, "test.toml", {" style.theme = dark "}).style.theme, Theme::kDark);
  EXPECT_EQ(messagesOf(kMinimal, {" = 3"}), "expected -D key.path=value\n");
}

TEST(Overrides, CannotSetASecondKey) {
  EXPECT_THAT(messagesOf(kMinimal, {"time.duration=1\nv2 = 3"}), HasSubstr("time.duration"));
  EXPECT_THAT(messagesOf(kMinimal, {"\"time.duration\"=1"}), HasSubstr("unknown table"));
  EXPECT_THAT(messagesOf("\"time.duration\" = 3\n" + std::string(kMinimal)),
              HasSubstr("\"time.duration\": unknown key"));
}

}  // namespace
}  // namespace poinsot::scene
