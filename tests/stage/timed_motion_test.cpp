// SPDX-License-Identifier: Apache-2.0
#include "stage/timed_motion.h"

#include <gtest/gtest.h>

#include <memory>

#include "physics/driven_motion.h"

namespace poinsot::stage {
namespace {

TEST(TimedMotion, ReturnsTheStatesOfTheMotionItTimes) {
  physics::Forcing forcing;
  forcing.dissipation = 0.05;
  const auto motion = std::make_shared<const physics::DrivenMotion>(
      physics::PrincipalMoments({1, 2, 3}), Eigen::Vector3d(0.3, 2, 0.1), Eigen::Quaterniond::Identity(), forcing,
      physics::TimeSpan{0, 2});
  core::StepLedger steps;
  const auto timedMotion = timed(motion, &steps);
  const physics::RigidBodyState state = timedMotion->at(2);
  EXPECT_EQ(state.omega_B, motion->at(2).omega_B);
  EXPECT_EQ(timedMotion->dissipation(), 0.05);
  EXPECT_EQ(timedMotion->driven(), motion.get());
  EXPECT_EQ(physics::turningRate_B(*timedMotion, state), physics::turningRate_B(*motion, state));
  EXPECT_EQ(physics::turningRate_W(*timedMotion, state), physics::turningRate_W(*motion, state));
}

}  // namespace
}  // namespace poinsot::stage
