// SPDX-License-Identifier: Apache-2.0
// Arrows of forces at points of the body, compared with the points and vectors of the scene.
#include "stage/figures/forces_figure.h"

#include <gtest/gtest.h>

#include "scene_samples.h"
#include "scenery.h"
#include "stage/stage.h"
#include "stage/timed_motion.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

const std::string kBox =
    "[body]\nshape = 'box'\nsize = [3, 2, 1]\nmass = 4\n[motion]\nomega_body = [0.2, 0.3, 1]\n"
    "[time]\nduration = 4\nspeed = 1\n";

std::string force(const std::string& keys) { return "[[motion.force]]\n" + keys; }

// The point is 1.5 m from the centre along x. The second force is the largest, so that the first is 3/4 as long.
TEST(ForcesFigure, BeginsAtThePointOfTheTurningBody) {
  const Scenery s(kBox + force("at = [1.5, 0, 0]\nspace = [0, 0, 3]\n") +
                  force("at = [0, 1, 0.5]\nbody = [4, 0, 0]\n"));
  const ForcesFigure figure(s.setting);
  ASSERT_EQ(figure.count(), 2u);
  for (const double t : {0.0, 1.3, 3.9}) {
    const PictureState state = s.motion.at(t);
    const auto space = figure.arrow(0, state), body = figure.arrow(1, state);
    EXPECT_LT((space.from_V - s.scales.body * (state.R_VB * Vector3d(1.5, 0, 0))).norm(), 1e-14);
    EXPECT_LT((body.from_V - s.scales.body * (state.R_VB * Vector3d(0, 1, 0.5))).norm(), 1e-14);
    const Vector3d alongSpace = space.tip_V - space.from_V, alongBody = body.tip_V - body.from_V;
    EXPECT_LT((alongSpace.normalized() - Vector3d::UnitZ()).norm(), 1e-14);
    EXPECT_LT((alongBody.normalized() - state.R_VB * Vector3d::UnitX()).norm(), 1e-14);
    EXPECT_NEAR(alongSpace.norm() / alongBody.norm(), 0.75, 1e-14);
  }
}

TEST(ForcesFigure, EndsAtThePointIfItLeadsIntoTheBody) {
  const Scenery s(kBox + force("at = [1.5, 0, 0]\nbody = [-3, 1, 0]\n") +
                  force("at = [1.5, 0, 0]\nbody = [3, 1, 0]\n") + force("at = [1.5, 0, 0]\nbody = [0, 1, 0]\n"));
  const ForcesFigure figure(s.setting);
  const PictureState state = s.motion.at(0.7);
  EXPECT_TRUE(figure.arrow(0, state).endsAtPoint);
  EXPECT_LT((figure.arrow(0, state).tip_V - s.scales.body * (state.R_VB * Vector3d(1.5, 0, 0))).norm(), 1e-14);
  EXPECT_FALSE(figure.arrow(1, state).endsAtPoint);
  EXPECT_FALSE(figure.arrow(2, state).endsAtPoint);
}

// A blow of 1 ms is between two of the states by which the camera is placed.
TEST(ForcesFigure, IsDrawnOnlyWhileItActsButAlwaysFramed) {
  const Scenery s(kBox + force("at = [1.5, 0, 0]\nbody = [0, 3, 0]\nfrom = 1\nto = 2.5\n") +
                  force("at = [0, 1, 0]\nbody = [3, 0, 0]\nfrom = 1.0011\nto = 1.0021\n"));
  const ForcesFigure figure(s.setting);
  EXPECT_FALSE(figure.acts(0, s.motion.at(0.999)));
  EXPECT_TRUE(figure.acts(0, s.motion.at(1)));
  EXPECT_FALSE(figure.acts(0, s.motion.at(2.5)));
  EXPECT_TRUE(figure.acts(1, s.motion.at(1.0015)));
  EXPECT_EQ(figure.outermostPoints(s.motion.at(0)).size(), 4u);
}

TEST(ForcesFigure, HasArmsIfTheSceneAsksForThem) {
  const auto names = [](const std::string& keys) {
    const std::string text = kBox + force("at = [1.5, 0, 0]\nbody = [0, 3, 0]\nto = 2\n") +
                             force("at = [0, 1, 0]\nbody = [3, 0, 0]\nfrom = 2\n") + keys;
    std::vector<std::string> found;
    const draw::Picture picture = Stage(scene::parseScene(text, "arms.toml")).compose(1, {960, 540});
    for (const draw::Text& label : picture.panels.at(0).list.texts)
      if (label.tex.find("mathbf{r}") != std::string::npos) found.push_back(label.tex);
    return found;
  };
  EXPECT_EQ(names(""), std::vector<std::string>());
  EXPECT_EQ(names("[show]\nforces.arms = true\n"), std::vector<std::string>{"$\\mathbf{r}_{1}$"});
}

// The body rests until a force acts. A thousandth of the final L is shorter than its label.
TEST(AngularMomentum, HasNoNameWhileItIsTooShortToSee) {
  const Stage stage(
      scene::parseScene("[body]\nshape = 'box'\nsize = [3, 2, 1]\nmass = 4\n[motion]\nomega_body = [0, 0, 0]\n"
                        "[time]\nduration = 4\nspeed = 1\n" +
                            force("at = [1.5, 0, 0]\nbody = [0, 3, 0]\nfrom = 2\n"),
                        "start.toml"));
  const auto hasName = [&](double t) {
    const draw::Picture picture = stage.compose(t, {960, 540});
    return std::ranges::any_of(picture.panels.at(0).list.texts,
                               [](const draw::Text& label) { return label.tex == "$\\mathbf{L}$"; });
  };
  EXPECT_FALSE(hasName(2.002));
  EXPECT_TRUE(hasName(3));
}

TEST(ForcesFigure, IsAnActorOnlyIfThereAreForces) {
  const auto has = [](const std::string& text) {
    const Scenery s(text);
    return std::ranges::any_of(makeActors(s.setting),
                               [](const ShownActor& actor) { return actor.name == "forces"; });
  };
  const std::string pushed = kBox + force("at = [1.5, 0, 0]\nspace = [0, 0, 3]\n");
  EXPECT_FALSE(has(kBox));
  EXPECT_TRUE(has(pushed));
  EXPECT_FALSE(has(pushed + "[show]\nforces = false\n"));
}

// V = F t/M of the force that acts, and the torque of the state is r × F (eq 1, 9).
TEST(ForcesFigure, MovesTheCentreOfMassOfAThrownBody) {
  const Scenery s(
      "[body]\nshape = 'box'\nsize = [3, 2, 1]\nmass = 4\n[motion]\nomega_body = [0, 0, 1]\n"
      "[motion.flight]\ngravity = [0, 0, 0]\n[time]\nduration = 4\nspeed = 1\n" +
      force("at = [1.5, 0, 0]\nspace = [0, 2, 0]\n"));
  const PictureState state = s.motion.at(3);
  EXPECT_LT((state.velocity_V - Vector3d(0, 1.5, 0)).norm(), 1e-14);
  EXPECT_LT((state.centre_V - Vector3d(0, 2.25, 0)).norm(), 1e-14);
  core::StepLedger steps;
  const PictureMotion measured(s.scene, timed(drawnMotion(s.scene), &steps));
  EXPECT_EQ(measured.at(3).velocity_V, state.velocity_V);
  EXPECT_LT((state.torque_V - (state.R_VB * Vector3d(1.5, 0, 0)).cross(Vector3d(0, 2, 0))).norm(), 1e-14);
}

}  // namespace
}  // namespace poinsot::stage
