// SPDX-License-Identifier: Apache-2.0
#include "physics/reference_point.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "physics/five_masses.h"

// The four terms of eq (4), for the five masses of five_masses.h. Expected values are sums over the masses and
// cross products, computed apart from the code.
namespace poinsot::physics {
namespace {

using Eigen::Vector3d;

constexpr double kRounding = 1e-14;

void expectNear(const Vector3d& measured, const Vector3d& expected, double bound = kRounding) {
  EXPECT_LE((measured - expected).norm(), bound) << measured.transpose() << " for " << expected.transpose();
}

MassProperties fiveMasses() {
  Eigen::Matrix3d inertia;
  inertia << 8.5045166015625, -0.052734375, 1.06787109375, -0.052734375, 7.9420166015625, 2.19287109375,
      1.06787109375, 2.19287109375, 8.54296875;
  return {6, FiveMasses().centre, inertia};
}

ReferencePointTerms termsOf(const Vector3d& K_B, const Quaternion& q_WB = Quaternion::Identity()) {
  const FiveMasses five;
  RigidBodyState state;
  state.q_WB = q_WB;
  state.omega_B = five.omega;
  state.omega_W = q_WB * five.omega;
  return referencePointTerms(fiveMasses(), K_B,
                             {.position_W = q_WB * five.centre, .velocity_W = q_WB * five.velocity}, state);
}

TEST(ReferencePoint, SplitsLIntoFourTermsForAPointOfTheBody) {
  const ReferencePointTerms terms = termsOf(FiveMasses().particles[0].position_W);
  expectNear(terms.position_W, {0.5, -1.25, 0.75});
  expectNear(terms.velocity_W, {1.47578125, -1.0109375, -0.234375});
  expectNear(terms.centre_W, {-0.15625, 1.34375, -0.7265625});
  expectNear(terms.displaced_W, {-6.2967041015625, -6.65321044921875, -10.950732421875});
  expectNear(terms.translation_W + terms.turningCentre_W + terms.rotation_W,
             {12.63515625, -1.0166015625, 13.894921875});
  expectNear(terms.sum_W(), {6.3384521484375, -7.66981201171875, 2.944189453125});
  EXPECT_FALSE(terms.mixedTermsVanish());
}

TEST(ReferencePoint, HasNoMixedTermsAtTheCentreOfMass) {
  const ReferencePointTerms terms = termsOf(FiveMasses().centre);
  expectNear(terms.translation_W, {0.3234375, -0.65625, -2.11875});
  expectNear(terms.rotation_W, {6.0150146484375, -7.01356201171875, 5.062939453125});
  EXPECT_EQ(terms.turningCentre_W, Vector3d(0, 0, 0));
  EXPECT_EQ(terms.displaced_W, Vector3d(0, 0, 0));
  EXPECT_TRUE(terms.mixedTermsVanish());
}

// The body turns about the origin of W, which is a point of it: eq (2).
TEST(ReferencePoint, HasOnlyTheRotationIfItRestsAtTheOrigin) {
  const FiveMasses five;
  RigidBodyState state;
  state.omega_B = state.omega_W = five.omega;
  const Flight pivoted{.position_W = five.centre, .velocity_W = five.omega.cross(five.centre)};
  const ReferencePointTerms terms = referencePointTerms(fiveMasses(), Vector3d::Zero(), pivoted, state);
  expectNear(terms.rotation_W, {6.22265625, -7.9236328125, 5.6578125});
  expectNear(terms.sum_W(), terms.rotation_W);
  EXPECT_TRUE(terms.mixedTermsVanish());
}

TEST(ReferencePoint, TurnsItsTermsWithTheBody) {
  const Quaternion quarter(1, 0, 0, 1);  // about z: (x, y, z) goes to (-y, x, z)
  const ReferencePointTerms terms = termsOf(FiveMasses().particles[0].position_W, quarter.normalized());
  expectNear(terms.displaced_W, {6.65321044921875, -6.2967041015625, -10.950732421875});
  expectNear(terms.sum_W(), {7.66981201171875, 6.3384521484375, 2.944189453125});
}

}  // namespace
}  // namespace poinsot::physics
