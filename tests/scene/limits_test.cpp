// SPDX-License-Identifier: Apache-2.0
// Tests each limit of docs/scene.md at the limit and one beyond it.
#include <gmock/gmock.h>

#include <cmath>

#include "physics/free_motion.h"
#include "scene/document/document.h"
#include "scene/limits.h"
#include "scene_testing.h"

namespace poinsot::scene {
namespace {

using testing::HasSubstr;
using testing::Not;

std::size_t usualOf(Limit limit) { return static_cast<std::size_t>(rowOf(limit).usual); }

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

void expectRefusal(const std::string& text, const std::string& message) {
  EXPECT_THAT(messagesOf(text), HasSubstr(message));
}

TEST(Limits, RejectTooLargeSceneFiles) {
  const std::string start = std::string(kMinimal) + "#";
  EXPECT_EQ(messagesOf(start + std::string(usualOf(Limit::kSceneBytes) - start.size(), 'x')), "");
  expectRefusal(start + std::string(usualOf(Limit::kSceneBytes) + 1 - start.size(), 'x'),
                "a scene file may have at most 4 MiB");
}

TEST(Limits, RejectTooLongStrings) {
  const std::string message = "a string may have at most 64 KiB; --limit string_bytes=N raises the limit";
  for (const char* quote : {"\"", "'", "\"\"\"", "'''"}) {
    const auto text = [&](std::size_t length) {
      return "x = " + (quote + std::string(length, 'a')) + quote + "\n";
    };
    EXPECT_THAT(messagesOf(text(usualOf(Limit::kStringBytes))), Not(HasSubstr(message)));
    expectRefusal(text(usualOf(Limit::kStringBytes) + 1), message);
  }
}

TEST(Limits, RejectTooDeepNesting) {
  const std::string message = "nested at most 64 deep";
  const auto arrays = [](int n) { return "x = " + repeated("[", n) + repeated("]", n) + "\n"; };
  const auto tables = [](int n) { return "x = " + repeated("{ a = ", n) + "1" + repeated("}", n) + "\n"; };
  const auto keys = [](int n) { return "x" + repeated(".a", n) + " = 1\n"; };
  const auto headers = [](int n) { return "[x" + repeated(".a", n) + "]\n"; };
  const auto mixed = [](int n) {
    return "x = " + repeated("[", n - 62) + "{" + "a" + repeated(".a", 61) + " = 1}" + repeated("]", n - 62) +
           "\n";
  };
  for (const auto& make : std::vector<std::function<std::string(int)>>{arrays, tables, keys, headers, mixed}) {
    EXPECT_THAT(messagesOf(make(64)), Not(HasSubstr(message))) << make(64);
    EXPECT_THAT(messagesOf(make(64)), HasSubstr("unknown key"));
    expectRefusal(make(65), message);
  }
}

// These texts would overflow the stack of a recursive parser or destructor.
TEST(Limits, RejectAMillionLevelsWithoutStackOverflow) {
  const int n = 1'000'000;
  expectRefusal("x = " + repeated("[", n), "nested at most 64 deep");
  expectRefusal("x = " + repeated("{a=", n), "nested at most 64 deep");
  expectRefusal("a" + repeated(".a", n) + " = 1", "nested at most 64 deep");
  expectRefusal("[a" + repeated(".a", n) + "]", "nested at most 64 deep");
  // A string that ends in an extra quote must not hide the text after it.
  expectRefusal("x = {a = \"\"\"b\"\"\"\", c" + repeated(".c", n) + " = 1}", "nested at most 64 deep");
  expectRefusal("x = {a = '''b''''', c" + repeated(".c", n) + " = 1}", "nested at most 64 deep");
}

TEST(Limits, ErrorPointsAtTheFirstTooDeepBracket) {
  const auto problems = problemsOf("# ω\nx = \"\"\"\n\\\n\"\"\" \ny = \"ω\" \nz = " + repeated("[", 65));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].where.line, 6);
  EXPECT_EQ(problems[0].where.column, 4 + 65);  // the 65th bracket
}

TEST(Limits, RejectTooManyValues) {
  const auto array = [](int n) { return "x = [0" + repeated(",0", n - 1) + "]\n"; };  // the array counts, too
  const auto kMost = static_cast<int>(usualOf(Limit::kValues));
  const std::string message = "a scene may hold at most 100000 values";
  EXPECT_THAT(messagesOf(array(kMost - 1)), Not(HasSubstr(message)));
  expectRefusal(array(kMost), message);
  expectRefusal(repeated("a=1\n", kMost + 1), message);
  expectRefusal(repeated("[[a]]\n", kMost + 1), message);
}

TEST(Limits, BoundTheSizeAndQualityOfTheOutput) {
  const auto refused = [](const std::string& override_) { return messagesOf(kMinimal, {override_}); };
  EXPECT_EQ(refused("output.size=[16, 16]"), "");
  EXPECT_THAT(refused("output.size=[14, 16]"), HasSubstr("each side must be from 16 to 8192 pixels, got 14"));
  EXPECT_EQ(refused("output.size=[8192, 16]"), "");
  EXPECT_THAT(refused("output.size=[16, 8194]"), HasSubstr("each side must be from 16 to 8192 pixels, got 8194"));
  EXPECT_EQ(refused("output.size=[8192, 8192]"), "");
  EXPECT_THAT(refused("output.size=[9223372036854775807, 16]"), HasSubstr("each side must be"));
  EXPECT_EQ(refused("output.crf=0") + refused("output.crf=51"), "");
  EXPECT_THAT(refused("output.crf=52"), HasSubstr("output.crf: must be from 0 to 51, got 52"));
}

TEST(Limits, RejectTooManyFrames) {
  const auto refused = [](const std::string& duration, const std::string& fps) {
    return messagesOf(kMinimal, {"time.duration=" + duration, "time.fps=" + fps});
  };
  EXPECT_EQ(refused("1200", "30"), "");
  EXPECT_EQ(refused("3600", "10"), "");
  EXPECT_EQ(refused("36", "1000"), "");
  EXPECT_THAT(refused("1200.01", "30"), HasSubstr("36001 frames"));
  EXPECT_THAT(refused("3600.1", "1"), HasSubstr("time.duration: must be"));
  EXPECT_THAT(refused("1", "1000.1"),
              HasSubstr("time.fps: must be from 0.001 to 1000 frames per second, got 1000.1"));
  EXPECT_THAT(
      refused("1", "3.141592653589793"),
      HasSubstr("time.fps: has too many digits to be kept exactly, got 3.141592653589793; write a fraction"));
  EXPECT_THAT(refused("1", "0"), HasSubstr("time.fps: must be"));
  EXPECT_THAT(refused("1", "-30"), HasSubstr("time.fps: must be"));
  EXPECT_THAT(refused("1", "nan"), HasSubstr("time.fps: must be"));
  EXPECT_THAT(refused("1", "\"30/0\""), HasSubstr("time.fps: expected a number or a fraction"));
}

TEST(Limits, BoundPhysicalQuantities) {
  const auto refused = [](const std::string& override_) { return messagesOf(kMinimal, {override_}); };
  EXPECT_EQ(refused("motion.omega_body=[1e40, -1e-40, 0]"), "");
  EXPECT_THAT(refused("motion.omega_body=[1.1e40, 0, 0]"),
              HasSubstr("zero, or in magnitude from 1e-40 to 1e+40 rad/s"));
  EXPECT_THAT(refused("motion.omega_body=[9e-41, 1, 0]"),
              HasSubstr("zero, or in magnitude from 1e-40 to 1e+40 rad/s"));
  EXPECT_EQ(refused("body.principal_moments=[1e60, 1e60, 1e60]"), "");
  EXPECT_EQ(refused("body.principal_moments=[1e-60, 1e-60, 1e-60]"), "");
  EXPECT_THAT(refused("body.principal_moments=[1.1e60, 1e60, 1e60]"), HasSubstr("1e+60 kg·m²"));
  EXPECT_EQ(refused("body.principal_moments=[1e-20, 1, 1]"), "");
  EXPECT_THAT(refused("body.principal_moments=[9e-21, 1, 1]"),
              HasSubstr("body.principal_moments: the largest moment may be at most 1e+20 times the smallest"));
  EXPECT_EQ(refused("motion.orientation=[1e-6, 0, 0, 0]") + refused("motion.orientation=[0, 1e6, 0, 0]"), "");
  EXPECT_THAT(refused("motion.orientation=[9e-7, 0, 0, 0]"), HasSubstr("its norm must be from 1e-06 to 1e+06"));
  EXPECT_THAT(refused("motion.orientation=[2e6, 0, 0, 0]"), HasSubstr("its norm must be"));
  EXPECT_THAT(refused("motion.orientation=[1e308, 1e308, 0, 0]"), HasSubstr("its norm must be"));
  EXPECT_NE(messagesOf(std::string(kMinimal) + "[time]\nstart = 1e400\n"), "");
  EXPECT_NE(messagesOf(std::string(kMinimal) + "[time]\nstart = 99999999999999999999\n"), "");
}

TEST(Limits, BoundTheMomentsOfAShape) {
  const auto refused = [](const std::string& size, const std::string& mass) {
    return messagesOf("motion.omega_body = [1, 0, 0]\nbody.shape = \"ellipsoid\"\nbody.mass = " + mass +
                      "\nbody.size = " + size + "\n");
  };
  EXPECT_EQ(refused("1e12", "1e30") + refused("1e-12", "1e-30"), "");
  EXPECT_THAT(refused("1e12", "1e60"), HasSubstr("body.size: with this mass the moments are"));
  EXPECT_THAT(refused("1e-12", "1e-60"), HasSubstr("they must be from 1e-60 to 1e+60 kg·m²"));
  EXPECT_THAT(refused("[1e12, 1e-12, 1e-12]", "1"), HasSubstr("body.size: the largest moment may be at most"));
}

/// Returns all combinations of the ends of moments, spin, start and speed, as overrides.
std::vector<std::vector<std::string>> corners() {
  std::vector<std::vector<std::string>> all;
  for (const char* moments : {"[1e60, 1e60, 1e60]", "[1e60, 1e60, 1e40]", "[1e-60, 1e-60, 1e-60]",
                              "[1e-60, 1e-40, 1e-40]", "[1e-60, 2e-60, 2.5e-60]", "[4e59, 8e59, 1e60]"})
    for (const char* spin : {"[1e40, 1e40, 1e40]", "[1e-40, 1e40, 1e-40]", "[1e-40, 1e-40, 1e-40]",
                             "[0, 1e-40, 0]", "[1e40, 0, -1e-40]"})
      for (const char* start : {"-1e20", "0", "1e20"})
        for (const char* speed : {"-1e20", "1e20"})
          all.push_back({"body.principal_moments=" + std::string(moments),
                         "motion.omega_body=" + std::string(spin), "time.start=" + std::string(start),
                         "time.speed=" + std::string(speed), "time.duration=3600", "time.fps=10"});
  return all;
}

bool finite(const physics::RigidBodyState& state) {
  return state.q_WB.coeffs().allFinite() && state.omega_B.allFinite();
}

// Accepted values must be drawable: the motion exists, and L^2 and T are neither zero nor infinite.
TEST(Limits, ExtremeAllowedValuesGiveAFiniteMotion) {
  for (const auto& corner : corners()) {
    SCOPED_TRACE(corner[0] + " " + corner[1] + " " + corner[2] + " " + corner[3]);
    const Scene scene = parseScene(kMinimal, "corner.toml", corner);
    const physics::FreeMotion motion(scene.body.axes.moments(), scene.motion.omega_B,
                                     Eigen::Quaterniond::Identity());
    EXPECT_TRUE(finite(motion.at(scene.time.start_s)));
    EXPECT_TRUE(finite(motion.at(scene.time.start_s + *scene.time.speed * scene.time.duration_s)));
    EXPECT_TRUE(std::isnormal(motion.L_W().squaredNorm()));
    EXPECT_TRUE(std::isnormal(motion.kineticEnergy()));
    EXPECT_TRUE(std::isnormal(2 * motion.kineticEnergy() / motion.L_W().norm()));
  }
}

TEST(Limits, RejectTooLongTitles) {
  EXPECT_EQ(messagesOf(kMinimal, {"show.title=" + std::string(200, 'x')}), "");
  EXPECT_THAT(messagesOf(kMinimal, {"show.title=" + std::string(201, 'x')}),
              HasSubstr("at most 200 characters, got 201"));
  EXPECT_THAT(messagesOf(kMinimal, {"show.title=\"a\\nb\""}), HasSubstr("line ends or other control characters"));
}

TEST(SceneText, ReportsTheLineOfInvalidCharacters) {
  const auto nul = problemsOf(kMinimal + std::string("x = 1\0", 6));
  ASSERT_EQ(nul.size(), 1u);
  EXPECT_EQ(nul[0].where.line, 5);
  const auto notUtf8 = problemsOf(kMinimal + std::string("[show]\ntitle = \"\xff\xfe\"\n"));
  ASSERT_EQ(notUtf8.size(), 1u);
  EXPECT_EQ(notUtf8[0].where.line, 6);
  EXPECT_EQ(problemsOf("\xff\xfe[\0b\0o\0d\0y\0]\0").size(), 1u);  // UTF-16
}

}  // namespace
}  // namespace poinsot::scene
