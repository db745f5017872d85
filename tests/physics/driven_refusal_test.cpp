// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <limits>

#include "core/error.h"
#include "core/interruption.h"
#include "physics/driven_testing.h"

namespace poinsot::physics {
namespace {

using testing::HasSubstr;

template <typename Action>
std::string refusal(const Action& action) {
  try {
    action();
  } catch (const core::Error& error) {
    EXPECT_THAT(error.kind(), testing::AnyOf(core::ErrorKind::kPhysics, core::ErrorKind::kLimit));
    return error.message();
  }
  return "not refused";
}

std::string refusalOf(const Forcing& forcing) {
  return refusal([&] { validate(forcing); });
}

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInf = std::numeric_limits<double>::infinity();

TEST(ForcingValidation, ReportsValuesThatAreNotFinite) {
  Forcing f;
  validate(f);
  f.gravity_B[1] = kNaN;
  EXPECT_THAT(refusalOf(f), HasSubstr("gravity (M g r in body axes, N·m) must be finite, got (0, nan, 0)"));
  f = {};
  f.torque_B[0] = kInf;
  EXPECT_THAT(refusalOf(f), HasSubstr("the torque in body axes (N·m) must be finite, got (inf, 0, 0)"));
  f = {};
  f.torque_W[2] = -kInf;
  EXPECT_THAT(refusalOf(f), HasSubstr("the torque in space axes (N·m) must be finite, got (0, 0, -inf)"));
}

TEST(ForcingValidation, RefusesNegativeRates) {
  Forcing f;
  f.dragRate_P = {0.1, -0.2, 0};
  EXPECT_THAT(refusalOf(f), HasSubstr("drag rates must not be negative, got (0.1, -0.2, 0) 1/s"));
  f = {};
  f.dissipation = -0.5;
  EXPECT_THAT(refusalOf(f), HasSubstr("alpha must be finite and not negative, got -0.5 s/(kg·m²)"));
  f.dissipation = kNaN;
  EXPECT_THAT(refusalOf(f), HasSubstr("got nan"));
}

TEST(ForcingValidation, RefusesTablesThatDoNotAscend) {
  Forcing f;
  f.torqueHistory_W.t_s = {0, 1, 1};
  f.torqueHistory_W.torque.assign(3, Eigen::Vector3d::UnitX());
  EXPECT_THAT(refusalOf(f), HasSubstr("the torque table in space axes must ascend, time 3 is 1 s after 1 s"));
  f.torqueHistory_W.t_s = {0, kNaN, 2};
  EXPECT_THAT(refusalOf(f), HasSubstr("must be finite, time 2 is nan s"));
  f.torqueHistory_W.t_s = {0, 1};
  EXPECT_THAT(refusalOf(f), HasSubstr("needs one torque for each time, got 2 times and 3 torques"));
  f = {};
  f.torqueHistory_B.t_s = {0};
  f.torqueHistory_B.torque = {{0, kInf, 0}};
  EXPECT_THAT(refusalOf(f), HasSubstr("the torque table in body axes must be finite"));
}

TEST(DrivenRefusal, RejectsInfiniteSpanAndZeroTolerance) {
  DrivenCase c;
  EXPECT_THAT(refusal([&] { c.motion(0); }), HasSubstr("tolerance must be positive and finite, got 0 rad"));
  c.span = {0, kInf};
  EXPECT_THAT(refusal([&] { c.motion(); }), HasSubstr("span of a driven motion must be finite, got 0 s to inf s"));
}

TEST(DrivenRefusal, RejectsInvalidStarts) {
  DrivenCase c;
  c.forcing.torque_B = {1, 0, 0};
  c.omega0[0] = kNaN;
  EXPECT_THAT(refusal([&] { c.motion(); }), HasSubstr("finite"));
  c = {};
  c.q0 = Eigen::Quaterniond(0, 0, 0, 0);
  EXPECT_THAT(refusal([&] { c.motion(); }), HasSubstr("nonzero, finite quaternion"));
}

TEST(DrivenRefusal, RejectsRunsOfTooManySteps) {
  DrivenCase c = heavyTop(1e9);
  EXPECT_THAT(refusal([&] { c.motion(); }), HasSubstr("more than the 2000000 steps allowed in a run"));
  c = {};
  c.forcing.dragRate_P = {1, 2, 1};
  c.span = {-1e4, 0};
  EXPECT_THAT(refusal([&] { c.motion(); }), HasSubstr("weaken what drives the body"));
}

// The caller allows the steps that the run needs, then one fewer.
TEST(DrivenRefusal, ObeysTheStepLimitOfTheCaller) {
  const DrivenCase c = heavyTop(1);
  const PrincipalAxes axes{PrincipalMoments(c.I)};
  const auto made = [&](double allowed) {
    return DrivenMotion(axes, c.omega0, c.q0, c.forcing, c.span, DrivenMotion::kDefaultTolerance_rad, allowed);
  };
  const auto steps = static_cast<double>(made(DrivenMotion::kDefaultSteps).report().steps);
  EXPECT_EQ(made(steps).report().steps, steps);
  try {
    made(steps - 1);
    FAIL();
  } catch (const core::Error& error) {
    EXPECT_EQ(error.kind(), core::ErrorKind::kLimit);
    EXPECT_THAT(error.message(), HasSubstr("steps, more than the"));
  }
}

// The torque would turn this needle by 2e9 rad in 20 s. With energy loss, alpha L²/I is 5e6 per second.
TEST(DrivenRefusal, RejectsNeedlesWithinSeconds) {
  DrivenCase c;
  c.I = {1e-8, 1, 1};
  c.forcing.torque_B = {0.1, 0.2, 0.3};
  const std::clock_t begin = std::clock();
  EXPECT_THAT(refusal([&] { c.motion(); }), HasSubstr("shorten the run, or weaken what drives the body"));
  c.forcing = {};
  c.forcing.gravity_B = {1e140, 0, 0};
  EXPECT_THAT(refusal([&] { c.motion(); }), HasSubstr("shorten the run, or weaken what drives the body"));
  c.forcing = {};
  c.forcing.dissipation = 0.01;
  EXPECT_THAT(refusal([&] { c.motion(); }), HasSubstr("more than the 400000 steps allowed in a run"));
  const double used_s = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;  // processor time
  EXPECT_LE(used_s, 10);  // measured 0.4; was 12 or endless before long drifts were abandoned
}

// Strong drag of unequal rates stops the body after 7 ms, for any span. The body keeps its attitude until a later
// torque turns it.
TEST(DrivenRest, NeedsNoIntegrationSteps) {
  DrivenCase c;
  c.forcing.dragRate_P = {1e5, 2e5, 1e5};
  c.span = {0, 1e9};
  const std::clock_t begin = std::clock();
  const DrivenMotion motion = c.motion();
  EXPECT_LE(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 5);  // measured 0.15; once 60 for 1 s
  const RigidBodyState rest = motion.at(1e-2);
  for (const double t : {1.0, 1e9}) {
    EXPECT_EQ(motion.at(t).q_WB.coeffs(), rest.q_WB.coeffs());
    EXPECT_EQ(motion.at(t).omega_B.norm(), 0);
  }
  // To first order in omega/rate each component turns by omega/rate.
  EXPECT_NEAR(2 * rest.q_WB.x(), 0.5 / 1e5, 1e-9);
  EXPECT_NEAR(2 * rest.q_WB.y(), 1 / 2e5, 1e-9);
  EXPECT_NEAR(2 * rest.q_WB.z(), 2 / 1e5, 1e-9);
}

TEST(DrivenRest, EndsAtTheNextTorque) {
  DrivenCase c;
  c.forcing.dragRate_P = {1e3, 2e3, 1e3};
  c.forcing.torqueHistory_B = {{0, 2, 2.01}, {{0, 0, 0}, {0, 0, 400}, {0, 0, 0}}, false};
  c.span = {0, 3};
  const DrivenMotion motion = c.motion();
  EXPECT_EQ(motion.at(1.5).omega_B.norm(), 0);
  // Torque and drag balance at omega = torque/(rate I3), with I3 = 2.
  EXPECT_NEAR(motion.at(2.01).omega_B[2], 0.2 * (1 - std::exp(-10)), 1e-9);
  EXPECT_EQ(motion.at(3).omega_B.norm(), 0);
}

TEST(DrivenRefusal, RejectsDecayTracedBackTooFar) {
  DrivenCase c;
  c.forcing.dragRate_P.setConstant(1);
  c.span = {-1000, 0};
  EXPECT_THAT(refusal([&] { c.motion(); }), HasSubstr("start the run later"));
}

// 1e5 s of a heavy top take more than half a minute. The pilot run and then the main runs call the check every
// 50 ms.
TEST(DrivenRefusal, InterruptionEndsTheIntegration) {
  struct Enough : std::exception {};
  for (const int calls : {1, 20}) {
    int left = calls;
    const core::InterruptionCheck check([&] {
      if (--left == 0) throw Enough();
    });
    EXPECT_THROW(heavyTop(1e5).motion(), Enough);
  }
}

TEST(DrivenRefusal, RejectsTimesOutsideTheSpan) {
  DrivenCase c;
  c.forcing.torque_B = {0.1, 0, 0};
  c.span = {-1, 2};
  const DrivenMotion motion = c.motion();
  motion.at(2);
  motion.at(-1);
  EXPECT_EQ(refusal([&] { motion.at(2.001); }),
            "t = 2.001 s: this driven motion was computed only from -1 s to 2 s");
  EXPECT_THAT(refusal([&] { motion.at(-1.001); }), HasSubstr("computed only from -1 s"));
}

}  // namespace
}  // namespace poinsot::physics
