// SPDX-License-Identifier: Apache-2.0
// The ways to give a start. Expected values by hand from L = I omega and the definition of the tilt.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "scene/make_motion.h"
#include "scene_testing.h"

namespace poinsot::scene {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

const std::string kBody = "body.principal_moments=[2, 4, 5]\n[motion]\n";

Scene sceneWith(const std::string& motion) { return parseScene(kBody + motion, "test.toml"); }
std::string problems(const std::string& motion) { return messagesOf(kBody + motion); }

Vector3d omegaOf(const std::string& motion) { return sceneWith(motion).motion.omega_B; }

// A quarter turn about z takes the body's x to the world's y. Measured: 1.4e-15, the rounding of the quaternion.
TEST(Start, MayBeGivenInSpace) {
  const std::string turned = "orientation=[1, 0, 0, 1]\n";
  EXPECT_LE((omegaOf(turned + "omega_space=[0, 3, 0.5]") - Vector3d(3, 0, 0.5)).norm(), 1e-14);
  EXPECT_LE((omegaOf(turned + "L_space=[-8, 6, 0.5]") - Vector3d(3, 2, 0.1)).norm(), 1e-14);
  EXPECT_EQ(omegaOf("L_space=[6, 8, 0.5]"), Vector3d(3, 2, 0.1));  // without an orientation the axes agree
  EXPECT_EQ(startOrientation(sceneWith("omega_space=[1, 2, 3]")).coeffs(), Eigen::Vector4d(0, 0, 0, 1));
}

TEST(Start, MayBeGivenAsL) {
  EXPECT_EQ(omegaOf("L_body=[6, '8 kg m^2/s', 0.5]"), Vector3d(3, 2, 0.1));
  // L still goes to the vertical.
  EXPECT_FALSE(sceneWith("L_body=[6, 8, 0.5]").motion.orientation_WB);
}

// L off axis 3 by the tilt, towards axis 1: L_1 = L_3 tan(tilt). Measured: 2.2e-16.
TEST(Start, MayBeASpinWithATilt) {
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

// T and |L| of what comes out. Measured: 2e-16.
TEST(Start, MayBeAnEnergyAndAMomentum) {
  const physics::PrincipalMoments moments(Vector3d(2, 4, 5));
  for (const char* more : {"", "phase=0.3\n", "phase=0.7\nbranch='negative'\n"}) {
    const Vector3d omega = omegaOf("energy='9 J'\nL=8.7\n" + std::string(more));
    EXPECT_NEAR(moments.kineticEnergy(omega) / 9, 1, 1e-14) << more;
    EXPECT_NEAR(moments.angularMomentum(omega).norm() / 8.7, 1, 1e-14) << more;
  }
  // L² = 75.69 > 2 T I2 = 72: round axis 3, on the side that the branch says.
  EXPECT_GT(omegaOf("energy=9\nL=8.7")[2], 0);
  EXPECT_LT(omegaOf("energy=9\nL=8.7\nbranch='negative'")[2], 0);
}

TEST(Start, IsGivenInOneWay) {
  const std::string ways =
      "; a start is given in one way: omega_body, omega_space, L_body, L_space, spin and "
      "spin_axis, or energy and L\n";
  EXPECT_EQ(problems("omega_body=[1, 0, 0]\nL_body=[1, 0, 0]"),
            "motion.L_body: motion.omega_body is given too" + ways);
  EXPECT_EQ(problems("tilt=0.1\nL=3\nenergy=2"), "motion.energy: motion.tilt is given too" + ways);
}

TEST(Start, SaysWhatItLacks) {
  EXPECT_EQ(problems("spin=3"),
            "motion.spin: motion.spin_axis is missing: spin and spin_axis give a start together\n");
  EXPECT_EQ(problems("tilt=0.3"),
            "motion.tilt: motion.spin is missing: spin and spin_axis give a start together\n");
  EXPECT_EQ(problems("L=3"), "motion.L: motion.energy is missing: energy and L give a start together\n");
}

TEST(Start, ThatCannotBeIsRefusedWithItsPlace) {
  EXPECT_THAT(problems("energy=9\nL=30"), HasSubstr("motion.energy: "));  // above sqrt(2 T I3) = 9.49
  EXPECT_THAT(problems("spin=0\nspin_axis='1'"), HasSubstr("motion.spin: must not be zero, got 0 rad/s"));
  EXPECT_THAT(problems("L_space=[0, 0, 0]"), HasSubstr("motion.L_space: must not be zero, got (0, 0, 0) kg·m²/s"));
  EXPECT_THAT(problems("spin=3\nspin_axis='1'\ntilt='90 deg'"), HasSubstr("motion.tilt: must be from 0 to"));
  EXPECT_THAT(messagesOf("body.principal_moments=[1e-60, 1e-60, 1e-60]\nmotion.L_body=[1, 0, 0]"),
              HasSubstr("motion.L_body: with these moments the angular velocity is"));
}

}  // namespace
}  // namespace poinsot::scene
