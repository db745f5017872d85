// SPDX-License-Identifier: Apache-2.0
// After a syntax error, the rest of a scene is still checked. Lines were counted by hand.
#include <gmock/gmock.h>

#include "scene_testing.h"

namespace poinsot::scene {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// Returns "line: message" for each problem.
std::vector<std::string> found(const std::string& text) {
  std::vector<std::string> all;
  for (const Problem& problem : problemsOf(text))
    all.push_back(std::to_string(problem.where.line) + ": " + problem.message);
  return all;
}

TEST(SyntaxRecovery, ReportsMistakesBeforeAndAfterTheBrokenLine) {
  EXPECT_THAT(found("[camera]\n"
                    "fvo = 1\n"
                    "[time]\n"
                    "duration = 10 s\n"
                    "spede = 2\n"
                    "[body]\n"
                    "principal_moments = [0.1, 0.2, 0.9]\n"
                    "[motion]\n"
                    "omega_body = [1, 0]\n"),
              ElementsAre("2: camera.fvo: unknown key; did you mean camera.fov?", StartsWith("4: not TOML"),
                          "5: time.spede: unknown key; did you mean time.speed?",
                          StartsWith("7: body.principal_moments: I3 must not exceed I1 + I2"),
                          StartsWith("9: motion.omega_body: expected an array of three")));
}

TEST(SyntaxRecovery, DoesNotReportWhatTheBrokenLineGives) {
  const std::string body = "[body]\nprincipal_moments = [1, 2, 2.5]\n",
                    motion = "[motion]\nomega_body = [1, 0, 0]\n";
  for (const std::string& text :
       {std::string("[body]\nshape = box\nsize = 1\nmass = 1\n") + motion,  // no shape
        std::string("[body]\nshape = \"box\"\nsize = 1\nmass = 1 kg\n") + motion,
        "[body\nprincipal_moments = [1, 2, 2.5]\n" + motion, "[motion\nomega_body = [1, 0, 0]\n" + body,
        body + "[motion]\nomega_body = 0, 0, 5\n", body + "[motion]\nspin = 5 rpm\nspin_axis = 3\n",
        body + motion + "[time]\nduration = 60 s\n[[timeline]]\nat = 30\nhide = [\"L\"]\n",
        body + motion + "[[plot]]\nquantities = [T, \"E\"]\n"})
    EXPECT_THAT(found(text), ElementsAre(testing::AnyOf(HasSubstr("not TOML"), HasSubstr("not a TOML value"))))
        << text;
}

TEST(SyntaxRecovery, ChecksALineWithOneLikelyCorrection) {
  EXPECT_THAT(
      found("[body]\nprincipal_moments = [1, 2, 2.5]\n[motion]\nspin = 5 rpm\n"),
      ElementsAre(HasSubstr("motion.spin_axis is missing"), HasSubstr("For example:\n    spin = \"5 rpm\"")));
  for (const auto& [line, mended] : std::vector<std::pair<const char*, const char*>>{
           {"duration = 12,5", "duration = 12.5"},
           {"duration = 12 s  # short", "duration = \"12 s\"  # short"},
           {"duration: 12", "duration = 12"},
           {"duration = 12;", "duration = 12"},
           {"duration = pi/2", "duration = 1.570796"},
           {"loop = True", "loop = true"},
           {"still = auto", "still = \"auto\""},
           {"fps = 30000/1001", "fps = \"30000/1001\""}})
    EXPECT_THAT(found(std::string(kMinimal) + "[time]\n" + line + "\n"),
                ElementsAre(testing::EndsWith(std::string("For example:\n    ") + mended)))
        << line;
}

TEST(SyntaxRecovery, ReportsSeveralSyntaxErrors) {
  EXPECT_THAT(
      found("[body]\nshape = box\nsize = 1\nmass = 2 kg\n[motion]\nomega_body = [1, 0, 0\n\n[time]\nfsp = 3\n"),
      ElementsAre(StartsWith("2: not a TOML value"), StartsWith("4: not TOML"),
                  "6: not TOML: the array that begins here has no closing ]",
                  "9: time.fsp: unknown key; did you mean time.fps?"));
}

TEST(SyntaxRecovery, LeavesOutAllLinesOfABrokenArray) {
  EXPECT_THAT(
      found("[body]\ninertia = [\n  [1, 0, 0],\n  [0, 1 0],\n  [0, 0, 1]\n]\n[motion]\nomega_bdoy = [1, 0, 0]\n"),
      ElementsAre(StartsWith("4: not TOML"),
                  "8: motion.omega_bdoy: unknown key; did you mean motion.omega_body?"));
}

TEST(SyntaxRecovery, LeavesOutTheTableOfABrokenHeader) {
  EXPECT_THAT(
      found("[body]\nprincipal_moments = [1, 2, 2.5]\n[motion\nomega_body = [1, 0, 0]\nx = 1\n[time]\nfsp = 3\n"),
      ElementsAre(StartsWith("3: not TOML"), "7: time.fsp: unknown key; did you mean time.fps?"));
}

TEST(SyntaxRecovery, ReportsARepeatedKeyAndTheRest) {
  EXPECT_THAT(found(std::string(kMinimal) + "omega_body = [1, 0, 0]\n[time]\nfsp = 3\n"),
              ElementsAre(StartsWith("5: this key or table is given twice"),
                          "7: time.fsp: unknown key; did you mean time.fps?"));
}

TEST(SyntaxRecovery, StopsAfterTenSyntaxErrors) {
  std::string text = "[time]\n";
  for (int i = 0; i < 100; ++i) text += "x" + std::to_string(i) + " = a b\n";
  EXPECT_EQ(problemsOf(text + "fsp = 1\n").size(), 10u);
}

TEST(SyntaxRecovery, ReportsAnOpenTextAtTheEndOnce) {
  EXPECT_EQ(problemsOf(std::string(kMinimal) + "[show]\ntitle = \"\"\"\nA top\n[time]\nfsp = 1\n").size(), 1u);
}

}  // namespace
}  // namespace poinsot::scene
