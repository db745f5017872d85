// SPDX-License-Identifier: Apache-2.0
// Cones that roll on a table, as scenes describe them, and cones that cannot.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "scene/motion/make_motion.h"
#include "scene/motion/quantity_basis.h"
#include "scene/motion/scene_events.h"
#include "scene_testing.h"

namespace poinsot::scene {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

// Worked by hand: slant height 1.25, sin alpha = 0.6, cos alpha = 0.8; the apex is 3/4 of the height above the
// origin.
const std::string kCone = "[body]\nshape='cone'\nradius=0.75\nheight=1\nmass=2\n";
const std::string kPivot = "pivot=[0, 0, 0.75]\n";
const std::string kRolling = "[motion.rolling]\nrate=1.5\n";

Scene sceneWith(const std::string& text) { return parseScene(text, "test.toml"); }

TEST(Rolling, SceneHasTheMotionOfTheCone) {
  const Scene scene = sceneWith(kCone + kPivot + kRolling);
  ASSERT_TRUE(scene.motion.rolling);
  EXPECT_FALSE(scene.motion.isFree());
  EXPECT_NEAR(scene.motion.rolling->centre_m, 0.75, 1e-15);
  EXPECT_EQ(scene.motion.rolling->g, 9.80665);
  const auto motion = makeMotion(scene, 0, 10);
  const physics::RigidBodyState start = motion->at(0);
  EXPECT_LT((start.omega_W - Vector3d(0, 2, 0)).norm(), 1e-14);  // the cone lies towards -y, omega = 1.5 cot alpha
  EXPECT_LT((start.q_WB * Vector3d(0, 0, -1) - Vector3d(0, -0.8, 0.6)).norm(), 1e-15);
  EXPECT_LT((scene.motion.omega_B - start.omega_B).norm(), 1e-15);
  EXPECT_LT((startOrientation(scene).coeffs() - start.q_WB.coeffs()).norm(), 1e-15);
  // T = (3/40) M h² Omega² (1 + 5 cos² alpha)
  EXPECT_NEAR(start.kineticEnergy, 3.0 / 40 * 2 * 2.25 * 4.2, 1e-14);
}

TEST(Rolling, TakesAHollowConeThatLiesInItsBodyAxes) {
  const Scene scene = sceneWith(
      "[[body.part]]\nshape='cone_shell'\nradius=0.75\nheight=1.5\nmass=2\naxis=[0, 1, 0]\nangle='90 deg'\n"
      "offset=[0.5, 0, 0]\n[body]\npivot=[1.5, 0, 0]\n[motion.rolling]\nrate='-6 rpm'\ng=1.62\n");
  const physics::RollingCone& cone = scene.motion.rolling->cone;
  EXPECT_LT((cone.axis_B - Vector3d(-1, 0, 0)).norm(), 1e-15);
  EXPECT_NEAR(cone.rate, -0.2 * std::numbers::pi, 1e-15);
  EXPECT_EQ(scene.motion.rolling->g, 1.62);
  EXPECT_NEAR(cone.along, 2 * 0.75 * 0.75 / 2, 1e-15);  // M r²/2
}

TEST(Rolling, RejectsConesThatCannotRoll) {
  const auto of = [](const std::string& text) { return messagesOf(text); };
  EXPECT_EQ(of(kCone + kPivot + kRolling), "");
  EXPECT_EQ(of("[body]\nshape='cylinder'\nradius=0.75\nheight=1\nmass=2\n" + kRolling),
            "motion.rolling: only a cone rolls on a table: the body must be one shape \"cone\" or \"cone_shell\"; "
            "change body.shape, or leave out [motion.rolling]\n");
  EXPECT_THAT(of("body.principal_moments=[1, 1, 1]\n" + kRolling), HasSubstr("only a cone rolls on a table"));
  EXPECT_EQ(
      of(kCone + kRolling),
      "motion.rolling: body.pivot is missing: a cone rolls about its apex; give body.pivot = [0, 0, 0.75]\n");
  EXPECT_EQ(of(kCone + "pivot=[0, 0, 0.7]\n" + kRolling),
            "body.pivot: a rolling cone turns about its apex, which is at [0, 0, 0.75] m; got [0, 0, 0.7] m; give "
            "body.pivot = [0, 0, 0.75]\n");
  EXPECT_EQ(
      of(kCone + kPivot + "[motion.rolling]\n"),
      "motion.rolling: motion.rolling.rate is missing: give the rate about the vertical, such as \"12 rpm\"\n");
  EXPECT_EQ(of(kCone + kPivot + "[motion.rolling]\nrate=0\n"),
            "motion.rolling.rate: the rate of a rolling cone must not be 0\n");
}

// Worked by hand (rolling_cone_test.cpp): the cone tips above sqrt(0.65·M g/0.945) = 3.67296 rad/s.
TEST(Rolling, RejectsARateAtWhichTheConeTips) {
  EXPECT_EQ(messagesOf(kCone + kPivot + "[motion.rolling]\nrate=3.67\n"), "");
  EXPECT_EQ(
      messagesOf(kCone + kPivot + "[motion.rolling]\nrate=4\n"),
      "motion.rolling.rate: at 4 rad/s (38.1972 rpm) this cone tips over the rim of its base; at most 3.67296 "
      "rad/s (35.0742 rpm) is possible; give a smaller rate\n");
}

TEST(Rolling, RejectsASecondStartOrTorque) {
  const auto of = [](const std::string& more) { return messagesOf(kCone + kPivot + kRolling + more); };
  const std::string rest =
      ": motion.rolling is given too, and a rolling cone has no other start or torque; leave out one of the two\n";
  EXPECT_EQ(of("[motion]\nomega_body=[0, 0, 1]\n"), "motion.omega_body" + rest);
  EXPECT_EQ(of("[motion.euler]\nspin=1\n"), "motion.euler" + rest);
  EXPECT_EQ(of("[motion]\nL_points='up'\n"), "motion.L_points" + rest);
  EXPECT_EQ(of("[motion.gravity]\ng=9.81\n"), "motion.gravity" + rest);
  EXPECT_EQ(of("[[motion.torque.step]]\nfrom=0\nbody=[0, 0, 1]\n"), "motion.torque" + rest);
}

TEST(Rolling, HidesPoinsotsConstructionAndHasNoLoop) {
  const std::string rolling = kCone + kPivot + kRolling;
  const Show show = sceneWith(rolling).views.at(0).show;
  EXPECT_FALSE(show.ellipsoid.visible || show.plane.visible || show.polhode.visible);
  EXPECT_TRUE(show.figures.table.visible);
  EXPECT_THAT(messagesOf(rolling + "[show]\nplane=true\n"), HasSubstr("for a rolling cone L is not constant"));
  EXPECT_EQ(messagesOf(rolling + "[show]\ndecomposition=true\n"), "");
  EXPECT_THAT(messagesOf(rolling + "[show]\ncones=true\n"), HasSubstr("show.cones: only free motion precesses"));
  EXPECT_THAT(messagesOf(rolling + "[time]\nloop=true\n"),
              HasSubstr("the loop of a rolling cone is not computed"));
  EXPECT_EQ(messagesOf(std::string(kMinimal) + "[show]\ntable=true\n"),
            "show.table: nothing rolls on a table: give [motion.rolling], or leave it out\n");
}

TEST(Rolling, QuantitiesHaveTheAxisFromTheApexToTheBase) {
  const Scene scene = sceneWith(kCone + kPivot + kRolling);
  const auto motion = makeMotion(scene, 0, 10);
  EXPECT_LT((quantityBasis(scene, *motion).k_P() - Vector3d(0, 0, -1)).norm(), 1e-15);
}

TEST(Rolling, HasNoEventsOfAFreeMotion) {
  const Scene scene = sceneWith(kCone + kPivot + kRolling);
  const auto motion = makeMotion(scene, 0, 100);
  EXPECT_TRUE(sceneEvents(scene, *motion, FilmClock(0, 1, scene.timeline), {0, 100}).empty());
}

}  // namespace
}  // namespace poinsot::scene
