// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/scene_file.h"
#include "scene_testing.h"

// [[vector]], [[angle]], [label] and figures with options. Columns were counted by hand.

namespace poinsot::scene {
namespace {

const std::string kFile = "[body]\nprincipal_moments = [1, 2, 2.5]\n[motion]\nomega_body = [0.1, 3, 0]\n";

std::string problemsOf(const std::string& text) {
  try {
    parseScene(kFile + text, "s.toml");
  } catch (const SceneErrors& errors) {
    return errors.what();
  }
  return "";
}

TEST(NamedFigures, AreReadFromVectorAndAngleTables) {
  const Scene scene =
      parseScene(kFile +
                     "[[vector]]\nname = '$\\mathbf{r}$'\nposition_of = [\"20 cm\", 0, 1]\ncolor = "
                     "\"omega\"\n[[vector]]\ncomponents = [0, 1, 0]\nframe = \"principal\"\n"
                     "[[angle]]\nbetween = [\"omega\", \"z\"]\nname = '$\\alpha$'\nscale = 2\n",
                 "s.toml");
  ASSERT_EQ(scene.vectors.size(), 2u);
  EXPECT_EQ(std::get<PositionVector>(scene.vectors[0].what).point_B, Eigen::Vector3d(0.2, 0, 1));
  EXPECT_EQ(scene.vectors[0].color, Meaning::kOmega);
  EXPECT_EQ(std::get<FixedVector>(scene.vectors[1].what).frame, VectorFrame::kPrincipal);
  ASSERT_EQ(scene.angles.size(), 1u);
  EXPECT_EQ(scene.angles[0].from, Direction::kOmega);
  EXPECT_EQ(scene.angles[0].to, Direction::kZ);
  EXPECT_EQ(scene.angles[0].scale, 2);
}

TEST(NamedFigures, ReportMistakesWithLineAndColumn) {
  using ::testing::HasSubstr;
  EXPECT_THAT(problemsOf("[[vector]]\nname = 'r'\n"),
              HasSubstr("vector[0].components: a vector needs components, position_of or velocity_of"));
  EXPECT_THAT(
      problemsOf("[[vector]]\ncomponents = [1, 0, 0]\nvelocity_of = [1, 0, 0]\n"),
      HasSubstr("s.toml:7:15: error: vector[0].velocity_of: cannot be combined with vector[0].components"));
  EXPECT_THAT(problemsOf("[[vector]]\ncomponents = [0, 0, 0]\n"),
              HasSubstr("s.toml:6:14: error: vector[0].components: must not all be zero"));
  EXPECT_THAT(problemsOf("[[vector]]\nposition_of = [1, 0, 0]\nframe = \"body\"\n"),
              HasSubstr("s.toml:7:9: error: vector[0].frame: only components have a frame"));
  EXPECT_THAT(problemsOf("[[angle]]\nbetween = [\"L\"]\n"),
              HasSubstr("s.toml:6:11: error: angle[0].between: an angle lies between two directions, got 1"));
  EXPECT_THAT(problemsOf("[[angle]]\nname = 'a'\n"), HasSubstr("angle[0].between: is required"));
  EXPECT_THAT(problemsOf("[show.ghosts]\ntimes = []\n"), HasSubstr("s.toml:6:9: error: show.ghosts.times"));
}

TEST(NamedFigures, RejectAxesIJKThatDoNotExist) {
  using ::testing::HasSubstr;
  const std::string top = "[body]\nprincipal_moments = [2, 2, 1]\n[motion]\nomega_body = ";
  const auto problems = [&](const std::string& text) {
    try {
      parseScene(text, "s.toml");
    } catch (const SceneErrors& errors) {
      return std::string(errors.what());
    }
    return std::string();
  };
  const std::string vector = "[[vector]]\ncomponents = [1, 0, 0]\nframe = \"precession\"\n";
  const std::string tilted = top + "[0.5, 0, 1]\n", upright = top + "[0, 0, 1]\n";
  EXPECT_EQ(problems(tilted + vector + "[show]\ntriad = true\nL_parts = true\n"), "");
  EXPECT_THAT(
      problemsOf(vector),
      HasSubstr("s.toml:7:9: error: vector[0].frame: \"precession\" does not exist: only a symmetric body"));
  EXPECT_THAT(problems(upright + vector), HasSubstr("does not exist: L lies along the axis k here"));
  EXPECT_THAT(
      problems(upright + "[show]\ntriad = true\n"),
      HasSubstr("s.toml:6:9: error: show.triad: L lies along the axis k here, and they have no common plane"));
  EXPECT_EQ(problems(upright + "[show]\nL_parts = true\n"), "");
  EXPECT_THAT(problemsOf("[show]\nL_parts = true\n"),
              HasSubstr("show.L_parts: only a symmetric body precesses steadily"));
  EXPECT_THAT(problems(tilted + "[motion.torque]\nbody = [0, 0, 1]\n[show]\ntriad = true\n"),
              HasSubstr("show.triad: only free motion"));
}

// (I1 - I2) I1 w1² + (I3 - I2) I3 w3² = -3·4 + 2·6 = 0 on the separatrix.
TEST(NamedFigures, RejectConesOfSteadyMotionAndOnTheSeparatrix) {
  using ::testing::HasSubstr;
  const auto problems = [](const std::string& omega) {
    try {
      parseScene(
          "[body]\nprincipal_moments = [3, 4, 6]\n[motion]\nomega_body = " + omega + "\n[show]\ncones = true\n",
          "s.toml");
    } catch (const SceneErrors& errors) {
      return std::string(errors.what());
    }
    return std::string();
  };
  EXPECT_EQ(problems("[2, 1, 0.9]"), "");
  EXPECT_THAT(problems("[2, 1, 1]"), HasSubstr("s.toml:6:9: error: show.cones: this start is on the separatrix"));
  EXPECT_THAT(problems("[0, 1, 0]"), HasSubstr("show.cones: a spin about a principal axis is steady"));
}

TEST(LabelTexts, HaveDefaultsAndMayBeEmpty) {
  const Scene scene = parseScene(kFile + "[label]\nL = ''\ntheta = '$\\vartheta$'\n", "s.toml");
  EXPECT_EQ(scene.labels[LabelName::kL], "");
  EXPECT_EQ(scene.labels[LabelName::kTheta], "$\\vartheta$");
  EXPECT_EQ(scene.labels[LabelName::kOmega], "$\\boldsymbol{\\omega}$");
}

}  // namespace
}  // namespace poinsot::scene
