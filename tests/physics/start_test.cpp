// SPDX-License-Identifier: Apache-2.0
#include "physics/start.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "core/error.h"
#include "physics/free_motion.h"
#include "physics/herpolhode.h"
#include "physics/polhode.h"
#include "physics/random_bodies.h"
#include "physics/residual.h"

namespace poinsot::physics {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kDegree = 3.14159265358979323846 / 180;

std::string refusal(const PrincipalAxes& axes, const EnergyStart& start) {
  try {
    omegaFromEnergy(axes, start);
  } catch (const core::Error& error) {
    EXPECT_EQ(error.kind(), core::ErrorKind::kPhysics);
    return error.message();
  }
  return "accepted";
}

// The prolate top of the lecture's eq (20): Ip = 1.5, I3 = 0.9, |L| = 2, theta = 25 deg; omega_1 and omega_3 by
// hand.
TEST(Start, SpinWithATiltMatchesTheTopOfTheLecture) {
  const PrincipalAxes axes(PrincipalMoments({1.5, 1.5, 0.9}));
  const Vector3d omega = omegaFromSpin(axes, {2, 2.01401730452589, 25 * kDegree, 0});
  EXPECT_NEAR(omega[0], 0.563491015654266, 2e-15);  // 15 digits given
  EXPECT_EQ(omega[1], 0);
  EXPECT_EQ(omega[2], 2.01401730452589);
  EXPECT_NEAR(axes.angularMomentum(omega).norm(), 2, 8e-15);
}

/// Returns random principal axes, turned from the body axes.
PrincipalAxes randomAxes(Draw& draw) { return {draw.moments(), draw.attitude()}; }

// A spin is defined by the angle between L and the axis, the side to which L leans, and a component of
// omega.
TEST(Start, SpinHasTheGivenTiltSideAndComponent) {
  Draw draw(201);
  double angle = 0, side = 0;
  for (int i = 0; i < 300; ++i) {
    const PrincipalAxes axes = randomAxes(draw);
    const SpinStart start{i % 3, draw.sign() * draw.between(0.1, 9), draw.between(0.01, 1.5), draw.between(-3, 3)};
    const Vector3d omega_B = omegaFromSpin(axes, start);
    const auto unit = [&](int axis) { return axes.toB(Vector3d::Unit((start.axis + axis) % 3)); };
    const Vector3d L = axes.inertia_B() * omega_B, k = unit(0) * (start.spin < 0 ? -1 : 1);
    EXPECT_NEAR(omega_B.dot(unit(0)), start.spin, 4e-15 * omega_B.norm());
    angle = std::max(angle, std::abs(std::atan2(k.cross(L).norm(), k.dot(L)) - start.tilt_rad));
    const double leans = std::atan2(unit(2).dot(L), unit(1).dot(L));
    side = std::max(side, std::abs(std::remainder(leans - start.towards_rad, 360 * kDegree)) * start.tilt_rad);
  }
  expectResidual("angle of L and the axis, rad", angle, 1e-14);  // measured 4.4e-16
  expectResidual("side that L leans to, rad", side, 1e-14);      // measured 1.3e-15
}

TEST(Start, SpinWithoutTiltIsSteady) {
  const PrincipalMoments moments({2, 3, 4});
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_EQ(omegaFromSpin(moments, {axis, -1.5, 0, 0.7}), Vector3d(-1.5 * Vector3d::Unit(axis)));
}

TEST(Start, RejectsInvalidTiltsOfASpin) {
  const PrincipalMoments moments({2, 3, 4});
  for (const double tilt : {-0.1, 90 * kDegree, 2.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(omegaFromSpin(moments, {0, 1, tilt, 0}), core::Error) << tilt;
  EXPECT_THROW(omegaFromSpin(moments, {0, INFINITY, 0, 0}), core::Error);
  EXPECT_THROW(omegaFromSpin(moments, {3, 1, 0, 0}), std::logic_error);
  try {
    omegaFromSpin(moments, {0, 1, 120 * kDegree, 0});
  } catch (const core::Error& error) {
    EXPECT_EQ(error.message(), "the tilt of a spin must be at least 0 and below 90 deg, got 120 deg");
  }
}

TEST(Start, ConvertsOmegaAndMomentumFromSpace) {
  Draw draw(202);
  double velocity = 0, momentum = 0;
  for (int i = 0; i < 200; ++i) {
    const PrincipalAxes axes = randomAxes(draw);
    const Quaterniond q_WB = draw.attitude();
    const Matrix3d R_WB = q_WB.toRotationMatrix(), inertia_W = R_WB * axes.inertia_B() * R_WB.transpose();
    const Vector3d given_W = draw.direction();
    velocity = std::max(velocity, (R_WB * omegaFromSpace(q_WB, given_W) - given_W).norm());
    momentum = std::max(momentum, (inertia_W * R_WB * omegaFromMomentum(axes, q_WB, given_W) - given_W).norm());
  }
  expectResidual("omega_W", velocity, 4e-15);                // measured 8e-16
  expectResidual("L_W = R I R^T omega_W", momentum, 2e-14);  // measured 2.5e-15
}

// The herpolhode of this T and |L| has radii from 0.1404... to 0.2630... (tests/support/development_examples.h).
TEST(Start, PhaseZeroIsAtTheLargestHerpolhodeRadius) {
  const PrincipalAxes axes(PrincipalMoments({2, 3, 4}));
  const auto radius = [&](double phase) {
    const Vector3d omega = omegaFromEnergy(axes, {2.34375, 4.190763653560053, phase, false});
    const Vector3d L = axes.angularMomentum(omega);
    return omega.cross(L).norm() / L.norm();
  };
  EXPECT_NEAR(radius(0), 0.2630596897205497, 2e-15);
  EXPECT_NEAR(radius(0.25), 0.1404323099902769, 2e-15);
  EXPECT_NEAR(radius(0.5), 0.2630596897205497, 2e-15);
  EXPECT_NEAR(radius(0.75), 0.1404323099902769, 2e-15);
}

TEST(Start, HasTheGivenEnergyAndMomentum) {
  Draw draw(203);
  double energy = 0, momentum = 0, late = 0;
  for (int i = 0; i < 300; ++i) {
    const PrincipalAxes axes = randomAxes(draw);
    const Vector3d I = axes.moments().values();
    const double T = draw.decade(-3, 3), share = draw.unit();
    const double L = std::sqrt(2 * T * (I.minCoeff() + share * (I.maxCoeff() - I.minCoeff())));
    const EnergyStart start{T, L, draw.unit(), i % 2 == 1};
    const Vector3d omega_B = omegaFromEnergy(axes, start), L_B = axes.inertia_B() * omega_B;
    energy = std::max(energy, std::abs(omega_B.dot(L_B) / 2 / T - 1));
    momentum = std::max(momentum, std::abs(L_B.norm() / L - 1));
    // The motion from phase 0 must be there after `phase` periods.
    const Vector3d zero_B = omegaFromEnergy(axes, {T, L, 0, start.negative});
    const double period = Polhode(axes.moments(), axes.toP(zero_B)).period();
    const Vector3d there = FreeMotion(axes, zero_B, Quaterniond::Identity()).at(start.phase * period).omega_B;
    late = std::max(late, (there - omega_B).norm() / omega_B.norm());
  }
  expectResidual("T, relative", energy, 1e-14);                    // measured 1.3e-15
  expectResidual("|L|, relative", momentum, 1e-14);                // measured 6.7e-16
  expectResidual("omega after the phase, relative", late, 1e-14);  // measured 2e-15
}

// `negative` chooses the end of the axis that omega circles. At phase 0 omega has no middle component, and a
// positive one along the other extreme axis.
TEST(Start, BranchSelectsOneOfTwoPolhodes) {
  const Vector3d orders[] = {{2, 3, 4}, {2, 4, 3}, {3, 2, 4}, {3, 4, 2}, {4, 2, 3}, {4, 3, 2}};
  for (const Vector3d& I : orders) {
    const PrincipalMoments moments(I);
    int least, most;
    I.minCoeff(&least);
    I.maxCoeff(&most);
    const int middle = 3 - least - most;
    for (const bool negative : {false, true}) {
      const double sign = negative ? -1 : 1;
      const Vector3d aboutLargest = omegaFromEnergy(moments, {1, std::sqrt(7.0), 0, negative});
      EXPECT_GT(sign * aboutLargest[most], 0);
      EXPECT_GT(aboutLargest[least], 0);
      EXPECT_EQ(aboutLargest[middle], 0);
      const Vector3d aboutSmallest = omegaFromEnergy(moments, {1, std::sqrt(5.0), 0, negative});
      EXPECT_GT(sign * aboutSmallest[least], 0);
      EXPECT_GT(aboutSmallest[most], 0);
      EXPECT_EQ(aboutSmallest[middle], 0);
      EXPECT_GT(sign * omegaFromEnergy(moments, {1, std::sqrt(7.0), 0.3, negative})[most], 0);
      EXPECT_GT(sign * omegaFromEnergy(moments, {1, std::sqrt(5.0), 0.7, negative})[least], 0);
    }
  }
}

TEST(Start, EnergyOfASteadySpinGivesTheSpin) {
  const PrincipalMoments moments({2, 3, 4});
  // At 3 rad/s about the smallest or the largest axis, 2T = I w² and L = I w.
  EXPECT_EQ(omegaFromEnergy(moments, {9, 6, 0.3, false}), Vector3d(3, 0, 0));
  EXPECT_EQ(omegaFromEnergy(moments, {9, 6, 0, true}), Vector3d(-3, 0, 0));
  EXPECT_EQ(omegaFromEnergy(moments, {18, 12, 0, true}), Vector3d(0, 0, -3));
  // With decimals, 2 T I differs from L² in the last bits, but the start must still be a steady spin.
  const PrincipalMoments tenths({0.1, 0.15, 0.2});
  EXPECT_LE(
      (omegaFromEnergy(tenths, {0.02, 0.2 * std::sqrt(0.2), 0, false}) - Vector3d(0, 0, std::sqrt(0.2))).norm(),
      2e-16);
  EXPECT_EQ(omegaFromEnergy(moments, {0, 0, 0, false}), Vector3d(0, 0, 0));
  // A sphere could spin about any direction and spins about z. A symmetric body spins about an axis in its
  // equator.
  EXPECT_EQ(omegaFromEnergy(PrincipalMoments({2, 2, 2}), {9, 6, 0.4, true}), Vector3d(0, 0, -3));
  EXPECT_EQ(omegaFromEnergy(PrincipalMoments({2, 2, 3}), {9, 6, 0.4, false}), Vector3d(3, 0, 0));
  EXPECT_EQ(omegaFromEnergy(PrincipalMoments({1.5, 2, 2}), {9, 6, 0.4, false}), Vector3d(0, 0, 3));
}

TEST(Start, EnergyOnTheSeparatrixNeedsPhaseZero) {
  const PrincipalMoments moments({1, 2, 2.25});
  // L² = 2 T I2: m1² = I1 (2 T I3 - L²)/(I3 - I1) with 2T = 5, L² = 10, by hand m1² = 1 and m3² = 9.
  const Vector3d omega = omegaFromEnergy(moments, {2.5, std::sqrt(10.0), 0, true});
  EXPECT_NEAR(omega[0], 1, 1e-15);
  EXPECT_EQ(omega[1], 0);
  EXPECT_NEAR(omega[2], -3 / 2.25, 1e-15);
  // 2T = 8, L = 4 exactly.
  EXPECT_EQ(refusal(moments, {4, 4, 0.25, false}),
            "on the separatrix (L² = 2 T I, where I is the middle moment), the motion has no period; the phase "
            "must be 0, got 0.25");
  EXPECT_EQ(refusal(moments, {4, 4, 0, false}), "accepted");
}

TEST(Start, RejectsImpossibleEnergyAndMomentum) {
  const PrincipalMoments moments({2, 8, 8});
  EXPECT_EQ(
      refusal(moments, {4, 3, 0, false}),
      "with a kinetic energy of 4 J the angular momentum must lie between 4 and 8 kg·m²/s (sqrt(2 T I) of the "
      "smallest and the largest moment), got 3");
  EXPECT_NE(refusal(moments, {4, 8.0001, 0, false}), "accepted");
  EXPECT_NE(refusal(moments, {4, 3.9999999999, 0, false}), "accepted");
  EXPECT_NE(refusal(moments, {1e300, 1e-300, 0, false}), "accepted");
  EXPECT_NE(refusal(moments, {0, 1, 0, false}), "accepted");
  EXPECT_NE(refusal(moments, {1, 0, 0, false}), "accepted");
  EXPECT_EQ(refusal(moments, {-1, 1, 0, false}), "kinetic energy must not be negative, got -1 J");
  EXPECT_EQ(refusal(moments, {4, -5, 0, false}),
            "the magnitude of the angular momentum must not be negative, got -5 kg·m²/s");
  EXPECT_EQ(refusal(moments, {4, 5, 1, false}), "the phase must be at least 0 and below 1, got 1");
  EXPECT_EQ(refusal(moments, {INFINITY, 5, 0, false}), "kinetic energy must be finite, got inf");
}

TEST(Start, EnergyDoesNotDependOnUnits) {
  const PrincipalMoments moments({2, 3, 4});
  const Vector3d omega = omegaFromEnergy(moments, {2.25, 4, 0.3, false});
  for (const int n : {-400, 400}) {
    const Vector3d scaled = omegaFromEnergy(moments, {std::ldexp(2.25, 2 * n), std::ldexp(4, n), 0.3, false});
    EXPECT_EQ(scaled, Vector3d(omega * std::ldexp(1, n)));
  }
}

}  // namespace
}  // namespace poinsot::physics
