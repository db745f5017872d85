// SPDX-License-Identifier: Apache-2.0
// Tests every error of a scene as a user sees it: exit code, place, caret and suggested repair. Lines and columns
// were counted by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/program_run.h"

namespace poinsot {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

struct BadScene {
  std::string name, text, says;
};

std::string sceneWith(const std::string& body, const std::string& motion, const std::string& rest = "") {
  return "schema = 1\n[body]\n" + body + "\n[motion]\n" + motion + "\n" + rest;
}

const std::string kBody = "principal_moments = [1, 2, 3]", kMotion = "omega_body = [0.1, 10, 0]";

std::vector<BadScene> badScenes() {
  return {
      {"unknown key", sceneWith(kBody, kMotion, "[time]\ndurration = 4\n"),
       "bad.toml:7:1: error: time.durration: unknown key; did you mean time.duration?"},
      {"wrong type", sceneWith(kBody, kMotion, "[time]\nduration = true\n"),
       "bad.toml:7:12: error: time.duration:"},
      {"out of range", sceneWith(kBody, kMotion, "[camera]\nfov = \"200 deg\"\n"),
       "bad.toml:7:7: error: camera.fov:"},
      {"impossible inertia", sceneWith("principal_moments = [1, 2, 9]", kMotion),
       "bad.toml:3:21: error: body.principal_moments: I3 must not exceed I1 + I2"},
      {"not a number", sceneWith(kBody, "omega_body = [0.1, nan, 0]"), "bad.toml:5:20: error: motion.omega_body"},
      {"no rotation", sceneWith(kBody, "omega_body = [0, 0, 0]"), "bad.toml:5:14: error: motion.omega_body"},
      {"odd size", sceneWith(kBody, kMotion, "[output]\nsize = [161, 90]\n"), "bad.toml:7:9: error: output.size"},
      {"another schema", "schema = 2\n[body]\n" + kBody + "\n[motion]\n" + kMotion + "\n",
       "bad.toml:1:10: error: schema: must be 1, got 2"},
      {"syntax", "schema = 1\n[body\n", "bad.toml:2:"},
      {"empty", "", "bad.toml"},
  };
}

TEST(BadScenes, AreRejectedWithLineAndColumn) {
  const ScratchFolder folder;
  for (const BadScene& bad : badScenes()) {
    folder.put("bad.toml", bad.text);
    for (const std::vector<std::string>& words : {std::vector<std::string>{"check", "bad.toml"},
                                                  {"render", "bad.toml", "-o", "bad.mp4"},
                                                  {"still", "bad.toml", "-o", "bad.png"}}) {
      const auto result = run(folder, words);
      EXPECT_EQ(result.exitCode, 2) << bad.name;
      EXPECT_THAT(result.err, StartsWith(bad.says)) << bad.name;
      EXPECT_THAT(result.out, IsEmpty());
    }
  }
  EXPECT_EQ(namesIn(folder.path()), std::vector<std::string>{"bad.toml"});
}

TEST(BadScenes, ArePrintedWithTheBadLineAndACaret) {
  const ScratchFolder folder;
  folder.put("bad.toml", sceneWith(kBody, "omega_bdoy = [0.1, 10, 0]"));
  EXPECT_THAT(run(folder, {"check", "bad.toml"}).err, HasSubstr("   5 | omega_bdoy = [0.1, 10, 0]\n"
                                                                "     | ^^^^^^^^^^"));
}

TEST(BadScenes, GetTheNearestEvenSizeSuggested) {
  const ScratchFolder folder;
  folder.put("bad.toml", sceneWith(kBody, kMotion, "[output]\nsize = [161, 90]\n"));
  EXPECT_THAT(run(folder, {"check", "bad.toml"}).err, HasSubstr("the nearest even size is 162"));
}

TEST(BadScenes, AreAllReportedInOneRun) {
  const ScratchFolder folder;
  folder.put("one.toml", sceneWith(kBody, "omega_bdoy = [1, 2, 3]", "[camera]\nfov = \"200 deg\"\n"));
  folder.put("two.toml", sceneWith("principal_moments = [1, 2, 9]", kMotion));
  folder.put("good.toml", kGoodScene);
  const auto result = run(folder, {"check", "one.toml", "missing.toml", "good.toml", "two.toml"});
  EXPECT_EQ(result.exitCode, 2);
  for (const char* said : {"one.toml:5:1: error:", "one.toml:7:7: error:", "two.toml:3:21: error:"})
    EXPECT_THAT(result.err, HasSubstr(said));
  EXPECT_THAT(result.err, HasSubstr("poinsot: error: missing.toml: cannot read the scene: No such file"));
  EXPECT_EQ(result.out, "good.toml: ok\n");
}

TEST(GoodScenes, GetANoteAboutALikelyMistake) {
  const ScratchFolder folder;
  folder.put("good.toml", sceneWith(kBody, kMotion, "[camera]\nazimuth = 2\n"));
  const auto result = run(folder, {"check", "good.toml"});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.out, "good.toml: ok\n");
  EXPECT_EQ(result.err,
            "good.toml:7:11: note: camera.azimuth: 2 is in radians (115 deg); for degrees write \"2 deg\"\n");
}

TEST(BadScenes, AreRejectedIfOptionDMakesThemBad) {
  const ScratchFolder folder;
  folder.put("good.toml", kGoodScene);
  const std::pair<std::string, std::string> cases[] = {
      {"time.duratoin=4", "did you mean time.duration?"},
      {"output.size=[161, 90]", "162"},
      {"body.principal_moments=[1, 2, 9]", "I3 must not exceed I1 + I2"},
      {"nonsense", "nonsense"},
  };
  for (const auto& [override, says] : cases) {
    const auto result = run(folder, {"check", "good.toml", "-D", override});
    EXPECT_EQ(result.exitCode, 2) << override;
    EXPECT_THAT(result.err, HasSubstr(says));
  }
  EXPECT_EQ(
      run(folder, {"check", "good.toml", "-D", "time.duration=6", "-D", "motion.omega_body=[1, 2, 3]"}).exitCode,
      0);
}

TEST(BadScenes, MissingFileIsASceneError) {
  const ScratchFolder folder;
  const auto result = run(folder, {"render", "no.toml", "-o", "a.mp4"});
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_EQ(result.err, "poinsot: error: no.toml: cannot read the scene: No such file or directory\n");
}

}  // namespace
}  // namespace poinsot
