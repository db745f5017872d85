// SPDX-License-Identifier: Apache-2.0
#include "physics/polhode.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/error.h"
#include "physics/free_motion.h"
#include "physics/poinsot_construction.h"
#include "physics/random_bodies.h"
#include "physics/residual.h"

namespace poinsot::physics {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Polhode, SamplesLieOnThePathOfOmega) {
  Draw draw(71);
  double worst = 0;
  for (int i = 0; i < 100; ++i) {
    const PrincipalMoments moments = draw.moments();
    const Vector3d omega0 = draw.direction() * draw.between(0.3, 3);
    const FreeMotion motion(moments, omega0, draw.attitude());
    for (const PolhodeSample& sample : Polhode(moments, omega0).samples(32))
      worst = std::max(worst, (motion.at(sample.t_s).omega_B - sample.omega_P).norm() / omega0.norm());
  }
  expectResidual("sample against the motion, relative", worst, 4e-14);  // measured 4.8e-15
}

TEST(Polhode, SamplesCoverTheCurveOnceFromTheStart) {
  Draw draw(72);
  for (int i = 0; i < 100; ++i) {
    const PrincipalMoments moments = draw.moments();
    const Vector3d omega0 = draw.direction();
    const Polhode polhode(moments, omega0);
    const auto samples = polhode.samples(40);
    ASSERT_EQ(samples.size(), 40u);
    EXPECT_EQ(samples.front().t_s, 0);
    EXPECT_LE((samples.front().omega_P - omega0).norm(), 1e-15);
    for (std::size_t j = 1; j < samples.size(); ++j) EXPECT_GT(samples[j].t_s, samples[j - 1].t_s);
    EXPECT_LT(samples.back().t_s, polhode.period());
  }
}

TEST(Polhode, SamplesAreOnBothEllipsoids) {
  Draw draw(73);
  double energy = 0, momentum = 0;
  for (int i = 0; i < 100; ++i) {
    const PrincipalMoments moments = draw.moments();
    const Vector3d omega0 = draw.direction();
    for (const PolhodeSample& sample : Polhode(moments, omega0).samples(24)) {
      energy =
          std::max(energy, std::abs(moments.kineticEnergy(sample.omega_P) / moments.kineticEnergy(omega0) - 1));
      const double L = moments.angularMomentum(omega0).norm();
      momentum = std::max(momentum, std::abs(moments.angularMomentum(sample.omega_P).norm() / L - 1));
    }
  }
  expectResidual("on the energy ellipsoid", energy, 4e-15);      // measured 6.7e-16
  expectResidual("on the momentum ellipsoid", momentum, 4e-15);  // measured 4.4e-16
}

// Near the separatrix the motion spends nearly all its time near the middle axis. The samples must not.
TEST(Polhode, SamplesAreWellSpreadNearTheSeparatrix) {
  const PrincipalMoments moments({1, 2, 3});
  const auto samples = Polhode(moments, {1e-6, 1, 0}).samples(100);
  double shortest = kInfinity, longest = 0;
  for (std::size_t j = 0; j < samples.size(); ++j) {
    const double gap = (samples[(j + 1) % samples.size()].omega_P - samples[j].omega_P).norm();
    shortest = std::min(shortest, gap);
    longest = std::max(longest, gap);
  }
  EXPECT_LE(longest / shortest, 2.5);  // measured 1.7, the ratio of the axes
}

TEST(Polhode, SeparatrixIsHalfACurveBetweenTheMiddlePoles) {
  const PrincipalMoments moments({1, 2, 2.25});
  const Vector3d omega0(-.75, .5, 1);
  const Polhode polhode(moments, omega0);
  const auto samples = polhode.samples(33);
  EXPECT_EQ(polhode.period(), kInfinity);
  ASSERT_EQ(samples.size(), 33u);
  EXPECT_EQ(samples.front().t_s, -kInfinity);
  EXPECT_EQ(samples.back().t_s, kInfinity);
  const double pole = 1.286953767623375;  // L/I2
  // The curve runs from +2 to -2 because omega_2' = (I3 - I1) omega_3 omega_1/I2 < 0.
  EXPECT_LE((samples.front().omega_P - Vector3d(0, pole, 0)).norm(), 5e-16);
  EXPECT_LE((samples.back().omega_P - Vector3d(0, -pole, 0)).norm(), 5e-16);
  const FreeMotion motion(moments, omega0, Quaterniond::Identity());
  for (std::size_t j = 1; j + 1 < samples.size(); ++j) {
    EXPECT_GT(samples[j].t_s, samples[j - 1].t_s);
    EXPECT_LE((motion.at(samples[j].t_s).omega_B - samples[j].omega_P).norm(), 2e-15);
  }
}

TEST(Polhode, SteadySpinIsAPoint) {
  for (const Vector3d& omega0 :
       {Vector3d(0, 0, 2), Vector3d(0, -3, 0), Vector3d(1e-30, 0, 0), Vector3d(0, 0, 0)}) {
    const Polhode polhode(PrincipalMoments({2, 3, 4}), omega0);
    EXPECT_EQ(polhode.regime(), PolhodeRegime::kSteady);
    EXPECT_EQ(polhode.period(), 0);
    const auto samples = polhode.samples(10);
    ASSERT_EQ(samples.size(), 1u);
    EXPECT_EQ(samples[0].omega_P, omega0);
  }
  EXPECT_EQ(Polhode(PrincipalMoments({2, 2, 2}), {1, 2, 3}).regime(), PolhodeRegime::kSteady);
  EXPECT_EQ(Polhode(PrincipalMoments({2, 2, 3}), {1, 2, 0}).regime(), PolhodeRegime::kSteady);
}

TEST(Polhode, RegimeIsRightForAnyOrderOfMoments) {
  EXPECT_EQ(Polhode(PrincipalMoments({4, 2, 3}), {1, .1, .1}).regime(), PolhodeRegime::kAboutLargest);
  EXPECT_EQ(Polhode(PrincipalMoments({4, 2, 3}), {.1, 1, .1}).regime(), PolhodeRegime::kAboutSmallest);
}

TEST(Polhode, RejectsFewerThanFourSamples) {
  EXPECT_THROW(Polhode(PrincipalMoments({2, 3, 4}), {1, 2, 3}).samples(3), std::logic_error);
}

TEST(PoinsotConstruction, RefusesABodyAtRest) {
  try {
    PoinsotConstruction(PrincipalMoments({2, 3, 4}), Vector3d::Zero());
    FAIL() << "accepted";
  } catch (const core::Error& error) {
    EXPECT_EQ(error.kind(), core::ErrorKind::kPhysics);
    EXPECT_EQ(error.message(),
              "the body is at rest: the Poinsot construction needs an angular velocity other than 0");
  }
}

// In any units, the height of the plane lies between the semi-axes and does not exceed |omega|.
TEST(PoinsotConstruction, PlaneIsNotBeyondTheContactPoint) {
  Draw draw(74);
  for (int i = 0; i < 200; ++i) {
    const Vector3d omega = draw.direction() * draw.decade(-150, 150);
    const PoinsotConstruction construction(draw.moments(), omega);
    EXPECT_LE(construction.planeHeight(), omega.stableNorm() * (1 + 4e-16));
    EXPECT_GE(construction.planeHeight(), construction.semiAxes_P().minCoeff() * (1 - 4e-16));
    EXPECT_LE(construction.planeHeight(), construction.semiAxes_P().maxCoeff() * (1 + 4e-16));
  }
}

}  // namespace
}  // namespace poinsot::physics
