// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "physics/driven_testing.h"

namespace poinsot::physics {
namespace {

// Constants of heavyTop(), from its closed form in extended precision.
constexpr double kNutationPeriod_s = 1.83064120697989845;
constexpr double kPrecessionPerNutation_rad = 0.958047879275758037;

// Over 1e4 nutations (1.7e5 rad) L_z must stay to the last bit, and the energy must have no trend.
TEST(DrivenLong, HeavyTopDoesNotDrift) {
  const double end = 1e4 * kNutationPeriod_s;
  const DrivenMotion motion = heavyTop(end).motion(1e-9);
  const RigidBodyState start = motion.at(0);
  const double E0 = motion.totalEnergy(start);
  double largest = 0, late = 0, early = 0;
  constexpr int kSamples = 4000;
  for (int i = 1; i <= kSamples; ++i) {
    const RigidBodyState state = motion.at(end / kSamples * i);
    ASSERT_EQ(state.L_W[2], start.L_W[2]);
    const double error = motion.totalEnergy(state) / E0 - 1;
    largest = std::max(largest, std::abs(error));
    (i > kSamples / 2 ? late : early) += error / (kSamples / 2);
  }
  expectResidual("energy", largest, 1e-14);                      // measured 1.9e-15
  expectResidual("  its trend", std::abs(late - early), 4e-15);  // measured 1.2e-15
  // After a whole number of nutations the axis is back at its start, turned by the precession.
  const Eigen::Vector3d before = start.q_WB.toRotationMatrix().col(2),
                        after = motion.at(end).q_WB.toRotationMatrix().col(2);
  const double precession = std::fmod(1e4 * kPrecessionPerNutation_rad, 2 * EIGEN_PI);
  const Eigen::Vector3d expected = Eigen::AngleAxisd(precession, Eigen::Vector3d::UnitZ()) * before;
  expectResidual("axis after 1e4 nutations", (after - expected).norm(), 1e-9);  // measured 4.1e-11
  EXPECT_LE(motion.report().estimatedAttitudeError_rad, 1e-9);
}

}  // namespace
}  // namespace poinsot::physics
