// SPDX-License-Identifier: Apache-2.0
// Ways to give a start. Expected values are worked by hand from L = I omega and the definition of the tilt.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "scene/motion/make_motion.h"
#include "scene_testing.h"

namespace poinsot::scene {
namespace {

using Eigen::Vector3d;
using testing::AllOf;
using testing::HasSubstr;

const std::string kBody = "body.principal_moments=[2, 4, 5]\n[motion]\n";

Scene sceneWith(const std::string& motion) { return parseScene(kBody + motion, "test.toml"); }
std::string problems(const std::string& motion) { return messagesOf(kBody + motion); }

Vector3d omegaOf(const std::string& motion) { return sceneWith(motion).motion.omega_B; }

// A quarter turn about z takes the body's x to the world's y. Measured: 1.4e-15, the rounding of the quaternion.
TEST(Start, MayBeGivenInSpaceAxes) {
  const std::string turned = "orientation=[1, 0, 0, 1]\n";
  EXPECT_LE((omegaOf(turned + "omega_space=[0, 3, 0.5]") - Vector3d(3, 0, 0.5)).norm(), 1e-14);
  EXPECT_LE((omegaOf(turned + "L_space=[-8, 6, 0.5]") - Vector3d(3, 2, 0.1)).norm(), 1e-14);
  EXPECT_EQ(omegaOf("L_space=[6, 8, 0.5]"), Vector3d(3, 2, 0.1));  // without an orientation the axes agree
  EXPECT_EQ(startOrientation(sceneWith("omega_space=[1, 2, 3]")).coeffs(), Eigen::Vector4d(0, 0, 0, 1));
}

TEST(Start, MayBeGivenAsAngularMomentum) {
  EXPECT_EQ(omegaOf("L_body=[6, '8 kg m^2/s', 0.5]"), Vector3d(3, 2, 0.1));
  // L is still turned onto the vertical.
  EXPECT_FALSE(sceneWith("L_body=[6, 8, 0.5]").motion.orientation_WB);
}

// L leans from axis 3 by the tilt, towards axis 1: L_1 = L_3 tan(tilt). Measured: 2.2e-16.
TEST(Start, MayBeGivenAsATiltedSpin) {
  const double tangent = std::tan(0.2);
  EXPECT_EQ(omegaOf("spin=3\nspin_axis='3'"), Vector3d(0, 0, 3));
  EXPECT_LE((omegaOf("spin=3\nspin_axis='3'\ntilt=0.2") - Vector3d(15 * tangent / 2, 0, 3)).norm(), 1e-14);
  EXPECT_LE(
      (omegaOf("spin=3\nspin_axis='largest'\ntilt=0.2\ntilt_towards='90 deg'") - Vector3d(0, 15 * tangent / 4, 3))
          .norm(),
      1e-14);
  EXPECT_EQ(omegaOf("spin=-3\nspin_axis='smallest'"), Vector3d(-3, 0, 0));
  EXPECT_EQ(omegaOf("spin='1 rad/s'\nspin_axis='middle'"), Vector3d(0, 1, 0));
}

// The start must have the given T and |L|. Measured: 2e-16.
TEST(Start, MayBeGivenAsEnergyAndMomentum) {
  const physics::PrincipalMoments moments(Vector3d(2, 4, 5));
  for (const char* more : {"", "phase=0.3\n", "phase=0.7\nbranch='negative'\n"}) {
    const Vector3d omega = omegaOf("energy='9 J'\nL=8.7\n" + std::string(more));
    EXPECT_NEAR(moments.kineticEnergy(omega) / 9, 1, 1e-14) << more;
    EXPECT_NEAR(moments.angularMomentum(omega).norm() / 8.7, 1, 1e-14) << more;
  }
  // L² = 75.69 > 2 T I2 = 72, so that omega circles axis 3, on the side of the branch.
  EXPECT_GT(omegaOf("energy=9\nL=8.7")[2], 0);
  EXPECT_LT(omegaOf("energy=9\nL=8.7\nbranch='negative'")[2], 0);
}

TEST(Start, ReportsMissingKeys) {
  EXPECT_EQ(problems("spin=3"),
            "motion.spin: motion.spin_axis is missing: give spin and spin_axis together. For example:\n    "
            "spin_axis = \"largest\"\n");
  EXPECT_EQ(problems("tilt=0.3"),
            "motion.tilt: motion.spin is missing: give spin and spin_axis together. For example:\n    spin = "
            "\"3 rev/s\"\n");
  EXPECT_EQ(
      problems("L=3"),
      "motion.L: motion.energy is missing: give energy and L together. For example:\n    energy = \"4.5 J\"\n");
}

TEST(Start, ReportsImpossibleStartsAtTheirKey) {
  EXPECT_THAT(problems("energy=9\nL=30"), HasSubstr("motion.energy: "));  // above sqrt(2 T I3) = 9.49
  EXPECT_THAT(problems("spin=0\nspin_axis='1'"), HasSubstr("motion.spin: must not be zero, got 0 rad/s"));
  EXPECT_THAT(problems("L_space=[0, 0, 0]"), HasSubstr("motion.L_space: must not be zero, got (0, 0, 0) kg·m²/s"));
  EXPECT_THAT(problems("spin=3\nspin_axis='1'\ntilt='90 deg'"), HasSubstr("motion.tilt: must be from 0 to"));
  EXPECT_THAT(messagesOf("body.principal_moments=[1e-60, 1e-60, 1e-60]\nmotion.L_body=[1, 0, 0]"),
              HasSubstr("motion.L_body: with these moments the angular velocity is"));
}

const std::string kSpinUnderGravity = "gravity.mgr_body=[0, 0, 1]\nspin=3\nspin_axis='3'\n";

/// Returns the numbers of the first "[...]" after `name`.
std::vector<double> pastedAfter(const std::string& message, const std::string& name) {
  std::istringstream text(message.substr(message.find(name + " = [") + name.size() + 4));
  std::vector<double> values;
  double value = 0;
  for (char comma = ','; comma == ',' && text >> value; text >> comma) values.push_back(value);
  return values;
}

TEST(TiltUnderGravity, ErrorSuggestsALean) {
  EXPECT_THAT(
      problems(kSpinUnderGravity + "tilt='60 deg'\ntilt_towards=1\n"),
      HasSubstr("motion.tilt: cannot tilt L under gravity, whose vertical is fixed; to lean the body, give "
                "motion.lean instead of tilt and tilt_towards"));
  EXPECT_EQ(problems(kSpinUnderGravity + "tilt=0\n"), "");
  EXPECT_EQ(problems(kSpinUnderGravity + "orientation=[0.866, 0.5, 0, 0]\n"), "");
}

// L of axis 3 is 15; L_1 = 15 tan(tilt), and I_1 = 2.
TEST(TiltUnderGravity, ErrorSuggestsOmegaIfAnOrientationIsGiven) {
  const std::string message = problems(kSpinUnderGravity + "orientation=[0.866, 0.5, 0, 0]\ntilt=0.2\n");
  EXPECT_THAT(message, HasSubstr("leave out tilt; for the same nutation"));
  EXPECT_THAT(message, HasSubstr("instead of spin, spin_axis and tilt"));
  const auto omega = pastedAfter(message, "motion.omega_body");
  ASSERT_EQ(omega.size(), 3u) << message;
  EXPECT_LE((Vector3d(omega[0], omega[1], omega[2]) - Vector3d(15 * std::tan(0.2) / 2, 0, 3)).norm(), 1e-11);
}

TEST(TiltUnderGravity, IsReportedTogetherWithOtherErrors) {
  EXPECT_THAT(problems("gravity.g=9.81\nspin=3\nspin_axis='3'\ntilt=0.2\n"),
              AllOf(HasSubstr("motion.gravity.g: "), HasSubstr("motion.tilt: cannot tilt L")));
  EXPECT_THAT(messagesOf("[motion]\n" + kSpinUnderGravity + "tilt=0.2\n"),
              HasSubstr("motion.tilt: cannot tilt L under gravity"));
}

// Under torques, drag and dissipation L leans from the axis as in free motion.
TEST(Tilt, IsAllowedIfItTiltsL) {
  const Vector3d leaning(15 * std::tan(0.2) / 2, 0, 3);
  const std::string tilted = "spin=3\nspin_axis='3'\ntilt=0.2\n";
  for (const char* acts :
       {"torque.body=[0, 0, 1]\n", "torque.space=[0, 0, 1]\n", "drag.rate=0.1\n", "dissipation.alpha=0.01\n",
        "gravity.mgr_body=[0, 0, 0]\n", "orientation=[1, 1, 0, 0]\n"})
    EXPECT_LE((omegaOf(acts + tilted) - leaning).norm(), 1e-14) << acts;
}

TEST(Tilt, IsRejectedIfItHasNoEffect) {
  const std::string rest = "spin=0\nspin_axis='3'\ntilt=0.2\n";
  for (const char* acts : {"torque.body=[0, 0, 1]\n", "orientation=[1, 1, 0, 0]\n"})
    EXPECT_THAT(
        problems(acts + rest),
        HasSubstr(
            "motion.tilt: has no effect if motion.spin is 0, because L is 0; leave it out, or give a spin\n"));
  EXPECT_EQ(
      problems("spin=3\nspin_axis='3'\ntilt_towards=0.2\n"),
      "motion.tilt_towards: motion.tilt is missing: a direction of tilt needs an angle; give both or neither\n");
  EXPECT_EQ(problems("spin=3\nspin_axis='3'\ntilt=0\ntilt_towards=0.2\n"), "") << "a cell of a sweep";
}

}  // namespace
}  // namespace poinsot::scene
