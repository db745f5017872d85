// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "physics/free_motion.h"
#include "physics/precession_cones.h"
#include "physics/random_bodies.h"
#include "physics/residual.h"

// The free symmetric top from space: the lecture's eq (18) to (21). symmetric_top_test.cpp tests (19) and (20)
// along random motions.

namespace poinsot::physics {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kDegree = 3.14159265358979323846 / 180;
constexpr double kDigits = 1e-14;  // values near 1 given to 15 digits, or angles near 30 deg

/// Returns omega of a top with moments Ip, Ip, I3 whose L is tilted from its axis z, by default |L| = 2 at 25 deg.
Vector3d tilted(double Ip, double I3, double theta = 25 * kDegree, double L = 2) {
  return {L * std::sin(theta) / Ip, 0, L * std::cos(theta) / I3};
}

// Eq (18): R I omega stays L.
TEST(Equation18, AngularMomentumInSpaceIsConstant) {
  Draw draw(221);
  double worst = 0;
  for (int i = 0; i < 100; ++i) {
    const PrincipalAxes axes(draw.moments(), draw.attitude());
    const FreeMotion motion(axes, draw.direction(), draw.attitude());
    const Eigen::Matrix3d inertia_B = axes.inertia_B();
    for (int j = 0; j < 5; ++j) {
      const RigidBodyState s = motion.at(draw.sign() * draw.decade(-1, 6));
      const Vector3d L_W = s.q_WB * (inertia_B * s.omega_B);
      worst = std::max(worst, (L_W - motion.L_W()).norm() / motion.L_W().norm());
    }
  }
  expectResidual("R I omega - L, relative", worst, 1e-14);  // measured 1.1e-15
}

TEST(Equation20And21, GiveRatesAndConesOfAProlateTop) {
  const auto cones = precessionCones(PrincipalMoments({1.5, 1.5, 0.9}), tilted(1.5, 0.9));
  ASSERT_TRUE(cones);
  EXPECT_EQ(cones->axis, 2);
  EXPECT_EQ(cones->sense, RollingSense::kOutside);
  EXPECT_NEAR(cones->tilt_rad / kDegree, 25, kDigits);
  EXPECT_NEAR(cones->spinRate, 2.01401730452589, kDigits);
  EXPECT_NEAR(cones->precessionRate, 4.0 / 3, kDigits);
  EXPECT_NEAR(cones->handFinchSpin(), 0.805606921810356, kDigits);
  EXPECT_NEAR(cones->bodyCone_rad / kDegree, 15.6308012665084, 5 * kDigits);
  EXPECT_NEAR(cones->spaceCone_rad / kDegree, 9.36919873349163, kDigits);
}

TEST(Equation21, GivesRatesAndConesOfAnOblateTop) {
  const auto cones = precessionCones(PrincipalMoments({1.5, 1.5, 2.1}), tilted(1.5, 2.1));
  ASSERT_TRUE(cones);
  EXPECT_EQ(cones->sense, RollingSense::kInside);
  EXPECT_NEAR(cones->tilt_rad / kDegree, 25, kDigits);
  EXPECT_NEAR(cones->spinRate, 0.863150273368238, kDigits);
  EXPECT_NEAR(cones->handFinchSpin(), -0.345260109347295, kDigits);
  EXPECT_NEAR(cones->bodyCone_rad / kDegree, 33.137736561917, 5 * kDigits);
  EXPECT_NEAR(cones->spaceCone_rad / kDegree, 8.13773656191702, kDigits);
}

// The lecture: "A strange notion of the spin, since it goes to zero for a spinning sphere."
TEST(Equation21, SphereHasNoSpin) {
  const Vector3d omega(1, -2, 3);
  const auto cones = precessionCones(PrincipalMoments({1.5, 1.5, 1.5}), omega);
  ASSERT_TRUE(cones);
  EXPECT_EQ(cones->handFinchSpin(), 0);
  EXPECT_EQ(cones->sense, RollingSense::kNone);
  EXPECT_EQ(cones->spaceCone_rad, 0);
  EXPECT_NEAR(cones->precessionRate, omega.norm(), 1e-15);
  EXPECT_EQ(cones->wobblePeriod(), INFINITY);
}

// Feynman's plate, with I3 = 2 Ip and k at 5 deg from L, wobbles twice in a turn.
TEST(Equation20, FeynmansPlateWobblesTwiceInATurn) {
  const auto cones = precessionCones(PrincipalMoments({1, 1, 2}), tilted(1, 2, 5 * kDegree));
  ASSERT_TRUE(cones);
  EXPECT_NEAR(cones->precessionRate / cones->spinRate, 2.00763967508669, kDigits);
  EXPECT_NEAR(cones->bodyCone_rad / kDegree, 9.92498503922732, kDigits);
  EXPECT_NEAR(cones->spaceCone_rad / kDegree, 4.92498503922732, kDigits);
}

// A football as a solid ellipsoid of semi-axes 0.14 m and 0.085 m: I3/Ip = 2 b²/(a² + b²).
TEST(Equation20, GivesThePrecessionOfAFootball) {
  const double a = 0.14, b = 0.085, Ip = a * a + b * b, I3 = 2 * b * b;
  EXPECT_NEAR(I3 / Ip, 0.538676607642125, 1e-15);
  const double theta = 20 * kDegree;
  const auto cones = precessionCones(PrincipalMoments({Ip, Ip, I3}), tilted(Ip, I3, theta));
  ASSERT_TRUE(cones);
  EXPECT_NEAR(cones->precessionRate / cones->spinRate, 0.538676607642125 / std::cos(theta), 2e-15);
}

// Explorer 1 as a uniform cylinder, 13.97 kg, 2.03 m long, 15.2 cm thick: 750 rpm about the long axis becomes a
// flat spin of 6.28 rpm with the same L, and 0.84 % of the energy.
TEST(Equation18, Explorer1KeepsLAndLosesEnergy) {
  const double m = 13.97, length = 2.03, r = 0.076;
  const double I3 = m * r * r / 2, Ip = m * (3 * r * r + length * length) / 12;
  EXPECT_NEAR(I3, 0.04034536, 1e-16);
  EXPECT_NEAR(Ip, 4.81758709666667, 5e-15);
  const double spin = 750 * 2 * 180 * kDegree / 60, flat = spin * I3 / Ip;
  const PrincipalMoments moments({Ip, Ip, I3});
  const FreeMotion before(moments, {0, 0, spin}, Quaterniond::Identity());
  const FreeMotion after(moments, {flat, 0, 0}, Quaterniond::Identity());
  EXPECT_NEAR(flat * 60 / (2 * 180 * kDegree), 6.28094923721, 6e-12);
  EXPECT_NEAR(after.L_W().norm(), before.L_W().norm(), 1e-15);
  EXPECT_NEAR(after.kineticEnergy() / before.kineticEnergy(), 0.00837459898295, 6e-15);
}

TEST(PrecessionCones, AreFoundForEveryAxisAndSense) {
  for (int axis = 0; axis < 3; ++axis)
    for (const double sense : {1.0, -1.0}) {
      Vector3d I = Vector3d::Constant(1.5), omega = Vector3d::Zero();
      I[axis] = 0.9;
      const Vector3d example = tilted(1.5, 0.9);
      omega[axis] = sense * example[2];
      omega[(axis + 1) % 3] = example[0];
      const auto cones = precessionCones(PrincipalMoments(I), omega);
      ASSERT_TRUE(cones);
      EXPECT_EQ(cones->axis, axis);
      EXPECT_EQ(cones->k_P, Vector3d(sense * Vector3d::Unit(axis)));
      EXPECT_NEAR(cones->tilt_rad / kDegree, 25, kDigits);
      EXPECT_NEAR(cones->bodyRate, -0.805606921810356, kDigits);
    }
}

TEST(PrecessionCones, AreRightForSpinsAlongAndAcrossTheAxis) {
  const PrincipalMoments moments({2, 2, 3});
  const auto along = precessionCones(moments, {0, 0, 2});
  ASSERT_TRUE(along);
  EXPECT_EQ(along->tilt_rad, 0);
  EXPECT_EQ(along->bodyCone_rad, 0);
  EXPECT_EQ(along->spaceCone_rad, 0);
  EXPECT_EQ(along->precessionRate, 3);  // L/I1, although no axis precesses
  const auto across = precessionCones(moments, {0, 2, 0});
  ASSERT_TRUE(across);
  EXPECT_NEAR(across->tilt_rad, 90 * kDegree, 1e-15);
  EXPECT_NEAR(across->bodyCone_rad, 90 * kDegree, 1e-15);
  EXPECT_EQ(across->spaceCone_rad, 0);
  EXPECT_EQ(across->bodyRate, 0);
  EXPECT_EQ(across->wobblePeriod(), INFINITY);
}

TEST(PrecessionCones, AreAbsentWithoutSymmetryOrSpin) {
  EXPECT_FALSE(precessionCones(PrincipalMoments({2, 3, 4}), {1, 1, 1}));
  EXPECT_FALSE(precessionCones(PrincipalMoments({2, 2, 3}), {0, 0, 0}));
  EXPECT_THROW(precessionCones(PrincipalMoments({2, 2, 3}), {NAN, 0, 0}), core::Error);
}

// Spins of any magnitude have the same angles, and rates in proportion.
TEST(PrecessionCones, ScaleWithTheSpin) {
  const PrincipalMoments moments({2, 2, 3});
  const Vector3d omega(0.3, 0.4, 1.7);
  const auto cones = precessionCones(moments, omega);
  for (const int n : {-900, 900}) {
    const auto scaled = precessionCones(moments, omega * std::ldexp(1, n));
    EXPECT_EQ(scaled->spaceCone_rad, cones->spaceCone_rad);
    EXPECT_EQ(scaled->bodyRate, std::ldexp(cones->bodyRate, n));
  }
}

}  // namespace
}  // namespace poinsot::physics
