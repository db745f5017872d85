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

TEST(LabelTexts, HaveDefaultsAndMayBeEmpty) {
  const Scene scene = parseScene(kFile + "[label]\nL = ''\ntheta = '$\\vartheta$'\n", "s.toml");
  EXPECT_EQ(scene.labels[LabelName::kL], "");
  EXPECT_EQ(scene.labels[LabelName::kTheta], "$\\vartheta$");
  EXPECT_EQ(scene.labels[LabelName::kOmega], "$\\boldsymbol{\\omega}$");
}

}  // namespace
}  // namespace poinsot::scene
