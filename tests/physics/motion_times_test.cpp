// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/error.h"
#include "physics/driven_motion.h"
#include "physics/driven_testing.h"
#include "physics/flight.h"
#include "physics/free_motion.h"
#include "physics/random_bodies.h"
#include "physics/run_condition.h"

// Functions of the physics library that take a time. For any time they must give finite numbers that are a state
// of the motion, or throw the documented error.
namespace poinsot::physics {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Returns times in every decade that matters, and `more` random ones.
std::vector<double> times(int more = 60) {
  using Limits = std::numeric_limits<double>;
  std::vector<double> all{0.0, Limits::quiet_NaN()};
  for (const double t : {Limits::denorm_min(),
                         Limits::min(),
                         1e-300,
                         1e-20,
                         0.5,
                         1.0,
                         2.0,
                         1e3,
                         1e14,
                         0x1p53,
                         1e20,
                         1e100,
                         1e154,
                         1e250,
                         1e280,
                         1e289,
                         1e290,
                         1e291,
                         0x1p996,
                         1e300,
                         1e307,
                         1e308,
                         Limits::max(),
                         kInfinity})
    all.insert(all.end(), {t, -t});
  Draw draw(81);
  for (int i = 0; i < more; ++i) all.push_back(draw.sign() * draw.decade(-320, 308));
  return all;
}

struct Kind {
  std::string name;
  std::unique_ptr<const Motion> motion;
  bool free = true;  // known at every phase, and of constant energy
};

std::vector<Kind> freeKinds() {
  struct Case {
    const char* name;
    Vector3d I, omega;
  };
  const Vector3d different(1, 2, 3);
  const double middle = std::sqrt(3.0);  // L² = 2 T I2 at omega = (sqrt 3, y, 1)
  const Case cases[] = {{"sphere", {2, 2, 2}, {1, 2, 3}},
                        {"sphere at rest", {2, 2, 2}, {0, 0, 0}},
                        {"oblate top", {1, 1, 2}, {0.1, 0.2, 3}},
                        {"prolate top", {2, 2, 0.1}, {0.1, 0.2, 3}},
                        {"disc", {1, 1, 2}, {0, 1, 1}},
                        {"about the largest axis", different, {0.5, 0.1, 2}},
                        {"about the smallest axis", different, {2, 0.1, 0.2}},
                        {"spin about an axis", different, {0, 0, 2}},
                        {"spin about the middle axis", different, {0, 1, 0}},
                        {"next to the separatrix", different, {1e-12, 1, 0}},
                        {"on the separatrix", different, {middle, 1, 1}},
                        {"needle", {1e-8, 1, 1}, {1, 1e-3, 2e-3}},
                        {"nearly a sphere", {1, 1 + 1e-12, 1 + 2e-12}, {1, 2, 3}},
                        {"slow and light", {1e-60, 2e-60, 2.5e-60}, {1e-40, 2e-40, 0}},
                        {"fast and heavy", {1e60, 2e60, 2.5e60}, {1e40, 2e40, 1e39}}};
  std::vector<Kind> kinds;
  for (const Case& c : cases)
    kinds.push_back(
        {c.name, std::make_unique<FreeMotion>(PrincipalMoments(c.I), c.omega, Quaterniond(1, 2, 3, 4))});
  const PrincipalAxes tilted(PrincipalMoments(different), Quaterniond(0.5, 0.5, 0.5, 0.5));
  kinds.push_back(
      {"tilted axes", std::make_unique<FreeMotion>(tilted, Vector3d(1, 2, 3), Quaterniond::Identity())});
  return kinds;
}

std::vector<DrivenCase> drivenCases() {
  DrivenCase sleeping = heavyTop(2), torque, history, drag, even, loss;
  sleeping.q0 = Quaterniond::Identity();
  torque.forcing.torque_B = {0.1, 0.2, 0.3};
  history.forcing.torqueHistory_W = {{-1, 0, 1e-3, 1}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}, true};
  drag.forcing.dragRate_P = {0.1, 0.2, 0.3};
  even.forcing.dragRate_P.setConstant(0.5);
  loss.forcing.dissipation = 0.01;
  return {DrivenCase{}, heavyTop(2), sleeping, torque, history, drag, even, loss};
}

std::vector<Kind> kinds() {
  std::vector<Kind> all = freeKinds();
  for (DrivenCase& c : drivenCases()) {
    c.span = {-1, 2};
    all.push_back({"driven " + std::to_string(all.size()), std::make_unique<DrivenMotion>(c.motion(1e-9)), false});
  }
  return all;
}

/// Returns the message of the core::Error that `use` throws, or "" if it throws nothing.
std::string refusal(const std::function<void()>& use) {
  try {
    use();
    return "";
  } catch (const core::Error& error) {
    EXPECT_TRUE(error.kind() == core::ErrorKind::kLimit || error.kind() == core::ErrorKind::kPhysics);
    EXPECT_NE(error.message(), "");
    return error.message();
  }
}

/// Expects that the attitude carries L_B to L_W and that the energy follows from omega, both within rounding.
void expectState(const Motion& motion, const RigidBodyState& s, double t_s) {
  EXPECT_EQ(s.t_s, t_s);
  EXPECT_NEAR(s.q_WB.norm(), 1, 1e-14);
  const Vector3d m_B = motion.axes().angularMomentum(s.omega_B);
  EXPECT_LE((s.q_WB * m_B - s.L_W).norm(), 1e-13 * s.L_W.norm());
  EXPECT_LE((s.q_WB * s.omega_B - s.omega_W).norm(), 1e-13 * s.omega_W.norm());
  EXPECT_NEAR(0.5 * m_B.dot(s.omega_B), s.kineticEnergy, 1e-12 * s.kineticEnergy);
}

TEST(MotionTimes, GiveAStateOrAnError) {
  for (const Kind& kind : kinds()) {
    const double rate = kind.motion->at(0).omega_B.norm();
    for (const double t : times()) {
      SCOPED_TRACE(kind.name + " at " + std::to_string(t));
      RigidBodyState state;
      const std::string message = refusal([&] { state = kind.motion->at(t); });
      if (message.empty()) expectState(*kind.motion, state, t);
      if (!kind.free) continue;
      const double phase = rate * std::abs(t);
      // No rate of the closed form exceeds 2 |omega|; about the axis of largest moment one rate is |omega|.
      if (phase > kFarthestPhase_rad / 2 && phase < 2 * kFarthestPhase_rad) continue;
      EXPECT_EQ(message.empty(), std::isfinite(t) && phase <= kFarthestPhase_rad / 2) << message;
    }
  }
}

TEST(MotionTimes, ReachHalfTheLargestPhaseForAnyBody) {
  Draw draw(290);
  for (int i = 0; i < 2000; ++i) {
    const Vector3d omega_P = draw.decade(-14, 30) * draw.direction();
    const FreeMotion motion(draw.moments(), omega_P, Quaterniond::Identity());
    const double t_s = kFarthestPhase_rad / 2 / omega_P.norm() * (1 - 1e-15);
    expectState(motion, motion.at(t_s), t_s);
    EXPECT_FALSE(motion.reaches(4 * t_s));
  }
}

TEST(MotionTimes, GiveTheSameStatesInOneCallAsOneByOne) {
  const std::vector<double> times_s = {2, -1, 0, 0.5, 0.5};
  for (const Kind& kind : kinds()) {
    SCOPED_TRACE(kind.name);
    const std::vector<RigidBodyState> states = kind.motion->at(times_s);
    ASSERT_EQ(states.size(), times_s.size());
    for (std::size_t i = 0; i < states.size(); ++i) {
      const RigidBodyState one = kind.motion->at(times_s[i]);
      EXPECT_EQ(states[i].t_s, times_s[i]);
      EXPECT_EQ(states[i].q_WB.coeffs(), one.q_WB.coeffs());
      EXPECT_EQ(states[i].omega_B, one.omega_B);
    }
    EXPECT_TRUE(kind.motion->at(std::vector<double>()).empty());
  }
}

TEST(MotionTimes, ErrorsNameTheIndexOfARejectedTime) {
  for (const Kind& kind : kinds())
    for (const double t : {kInfinity, std::numeric_limits<double>::quiet_NaN(), 1e300}) {
      SCOPED_TRACE(kind.name + " at " + std::to_string(t));
      const std::string alone = refusal([&] { kind.motion->at(t); });
      const std::string among = refusal([&] { kind.motion->at(std::vector<double>{0, 1, t, 2, t}); });
      EXPECT_EQ(among, alone.empty() ? "" : "times_s[2]: " + alone);
    }
}

TEST(MotionTimes, GiveADrivenMotionOrAnErrorForAnySpan) {
  for (DrivenCase& c : drivenCases())
    for (const double t : times(0)) {
      SCOPED_TRACE(t);
      c.span = {std::min(t, 0.0), std::max(t, 0.0)};
      refusal([&] {
        const PrincipalAxes axes{PrincipalMoments(c.I)};
        const DrivenMotion motion(axes, c.omega0, c.q0, c.forcing, c.span, 1e-6, 100);
        expectState(motion, motion.at(t), t);
      });
    }
}

TEST(MotionTimes, FlightsAreFiniteOrRefused) {
  const FreeMotion spin(PrincipalMoments({1, 1, 1}), {0, 0, 0}, Quaterniond::Identity());
  for (const double g : {0.0, 9.80665, 1e20})
    for (const double t : times()) {
      SCOPED_TRACE(t);
      const Flight flight{{1, 2, 3}, {-1, 0, 1e10}, {0, 0, -g}};
      RigidBodyState state = spin.at(0);
      state.t_s = t;
      const auto position = refusal([&] { EXPECT_TRUE(flight.positionAt(t).allFinite()); });
      const auto velocity = refusal([&] { EXPECT_TRUE(flight.velocityAt(t).allFinite()); });
      refusal([&] {
        const FlightQuantities q = flightQuantities(2, flight, state);
        EXPECT_TRUE(q.P_W.allFinite() && q.orbital_W.allFinite() && q.total_W.allFinite() &&
                    q.torque_W.allFinite());
        EXPECT_TRUE(std::isfinite(q.kineticEnergy()) && std::isfinite(q.potentialEnergy));
      });
      // position needs 1e20 t²/2, velocity 1e20 t: doubles reach 1.8e308.
      EXPECT_EQ(position.empty(), std::isfinite(t) && std::isfinite(g * t * t) && std::isfinite(1e10 * t));
      EXPECT_EQ(velocity.empty(), std::isfinite(g * t));
    }
}

TEST(MotionTimes, RunConditionsAreFiniteOrRejected) {
  for (const Vector3d& omega : {Vector3d(0, 0, 0), Vector3d(0, 0, 1), Vector3d(1e-12, 1, 0), Vector3d(1e40, 2, 3)})
    for (const double t : times()) {
      SCOPED_TRACE(t);
      const auto message = refusal([&] {
        const RunCondition c = runCondition(PrincipalMoments({1, 2, 3}), omega, t);
        EXPECT_TRUE(std::isfinite(c.attitude_rad + c.digits + c.turns + c.flips));
      });
      EXPECT_EQ(message.empty(), std::isfinite(t) && omega.norm() * std::abs(t) <= kFarthestPhase_rad);
    }
}

TEST(MotionTimes, ASpanMayBeGivenInEitherOrder) {
  DrivenCase c = heavyTop(0);
  c.span = {-1, 2};
  const DrivenMotion motion = c.motion();
  c.span = {2, -1};
  const DrivenMotion reversed = c.motion();
  for (const double t : {-1.0, 0.5, 2.0}) {
    EXPECT_EQ(reversed.at(t).q_WB.coeffs(), motion.at(t).q_WB.coeffs());
    EXPECT_EQ(reversed.at(t).omega_B, motion.at(t).omega_B);
  }
}

}  // namespace
}  // namespace poinsot::physics
