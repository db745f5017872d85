// SPDX-License-Identifier: Apache-2.0
// Compares events with textbook formulas. Elliptic integrals are computed here by the arithmetic-geometric mean.
#include "physics/motion_events.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "core/error.h"
#include "physics/driven_motion.h"
#include "physics/free_motion.h"

namespace poinsot::physics {
namespace {

using Eigen::Vector3d;
using EventKind = MotionEventKind;

constexpr double kPi = std::numbers::pi;

/// Returns the complete elliptic integral K for the complementary parameter mc = 1 - k^2.
double completeK(double mc) {
  double a = 1, b = std::sqrt(mc);
  for (int i = 0; i < 40; ++i) {
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  return kPi / (2 * a);
}

/// Returns the time between zeros of omega_2, 2K/lambda, for I1 < I2 < I3 (Landau & Lifshitz, Mechanics, section
/// 37). The formula is for L^2 > 2 T I2. For the other case, it exchanges I1 and I3.
double flipIntervalOf(Vector3d I, Vector3d omega) {
  const double square = I.cwiseProduct(omega).squaredNorm(), twoT = omega.dot(I.cwiseProduct(omega));
  if (square < twoT * I[1]) std::swap(I[0], I[2]);
  const double lambda = std::sqrt((I[2] - I[1]) * (square - twoT * I[0]) / (I[0] * I[1] * I[2]));
  const double parameter = (I[1] - I[0]) * (twoT * I[2] - square) / ((I[2] - I[1]) * (square - twoT * I[0]));
  return 2 * completeK(1 - parameter) / lambda;
}

FreeMotion freeMotion(const Vector3d& I, const Vector3d& omega) {
  return {PrincipalMoments(I), omega, Eigen::Quaterniond(1, 0, 0, 0)};
}

std::vector<MotionEvent> freeEventsOf(const Vector3d& I, const Vector3d& omega, const TimeSpan& span) {
  return motionEvents(freeMotion(I, omega), {}, span);
}

// omega_2 is 0 at the start, so that the flips are the multiples of the interval.
TEST(MotionEvents, AreTheFlipsOfAFreeBody) {
  for (const Vector3d& omega : {Vector3d(0.2, 0, 2), Vector3d(1.5, 0, 0.1), Vector3d(-0.3, 0, -1)}) {
    const Vector3d I(1, 2, 2.5);
    const double interval = flipIntervalOf(I, omega);
    const auto events = freeEventsOf(I, omega, {0, 100.5 * interval});
    ASSERT_EQ(events.size(), 101u);
    for (std::size_t k = 0; k < events.size(); ++k)
      EXPECT_NEAR(events[k].t_s, static_cast<double>(k) * interval, 1e-14 * 100 * interval) << k;
    const auto before = freeEventsOf(I, omega, {-2.5 * interval, 1.5 * interval});
    ASSERT_EQ(before.size(), 4u);
    for (int k = 0; k < 4; ++k)
      EXPECT_NEAR(before[static_cast<std::size_t>(k)].t_s, (k - 2) * interval, 1e-13 * interval);
    EXPECT_TRUE(freeEventsOf(I, omega, {0.1 * interval, 0.9 * interval}).empty());
  }
}

// tan of the least angle between L and the middle axis is |m_c/m_2| at m_a = 0: 0.5 deg and 84 deg.
TEST(MotionEvents, DistinguishFlipsFromReversals) {
  const auto kindOf = [](const Vector3d& omega) { return freeEventsOf({1, 2, 2.5}, omega, {0, 50}).at(0).kind; };
  EXPECT_EQ(kindOf({0.05, 3, 0.05}), EventKind::kFlip);
  EXPECT_EQ(kindOf({0.2, 0, 2}), EventKind::kReversal);
}

TEST(MotionEvents, OfAReversedSpanComeInReversedOrder) {
  auto forwards = freeEventsOf({1, 2, 2.5}, {0.05, 3, 0.05}, {-20, 30});
  const auto backwards = freeEventsOf({1, 2, 2.5}, {0.05, 3, 0.05}, {30, -20});
  ASSERT_GT(forwards.size(), 3u);
  std::ranges::reverse(forwards);
  ASSERT_EQ(forwards.size(), backwards.size());
  for (std::size_t i = 0; i < forwards.size(); ++i) EXPECT_EQ(forwards[i].t_s, backwards[i].t_s);
}

// I = (3, 4, 6), omega = (2, 1, 1): L^2 = 88 = 2 T I2. On the separatrix, omega_2 = A tanh(A/3 (t - t0)) with
// A = |L|/I2 and sqrt((I2 - I1)(I3 - I2)/(I1 I3)) = 1/3. omega_2' > 0 by Euler's equation.
TEST(MotionEvents, HaveOneFlipOnTheSeparatrix) {
  const double A = std::sqrt(88) / 4, t0 = -std::atanh(1 / A) / (A / 3);
  const auto events = freeEventsOf({3, 4, 6}, {2, 1, 1}, {-10, 10});
  ASSERT_EQ(events.size(), 1u);
  EXPECT_NEAR(events[0].t_s, t0, 1e-14);
  EXPECT_EQ(events[0].kind, EventKind::kFlip);
  EXPECT_TRUE(freeEventsOf({3, 4, 6}, {2, 1, 1}, {0, 1000}).empty());
}

TEST(MotionEvents, DoNotExistForSymmetricBodiesAndSteadySpins) {
  EXPECT_TRUE(freeEventsOf({2, 2, 3}, {0.4, 1, 5}, {0, 100}).empty());
  EXPECT_TRUE(freeEventsOf({1, 2, 3}, {0, 1, 0}, {0, 100}).empty());
  EXPECT_TRUE(freeEventsOf({1, 2, 3}, {0, 0, 0}, {0, 100}).empty());
}

TEST(MotionEvents, RejectMoreThanAMillionFlips) {
  EXPECT_THROW(freeEventsOf({1, 2, 2.5}, {0.2, 0, 2}, {0, 1e9}), core::Error);
}

/// Returns m' = m x w of a body that loses energy at constant L, with w = omega + alpha m x omega (forcing.h).
Vector3d dissipated(const Vector3d& I, double alpha, const Vector3d& m) {
  const Vector3d omega = m.cwiseQuotient(I);
  return m.cross(omega + alpha * m.cross(omega));
}

Vector3d rungeKutta(const Vector3d& I, double alpha, const Vector3d& m, double h) {
  const Vector3d a = dissipated(I, alpha, m), b = dissipated(I, alpha, m + h / 2 * a);
  const Vector3d c = dissipated(I, alpha, m + h / 2 * b), d = dissipated(I, alpha, m + h * c);
  return m + h / 6 * (a + 2 * b + 2 * c + d);
}

/// Returns the times at which a function of m changes sign, by Runge-Kutta steps and linear interpolation.
std::vector<double> rootsOf(const Vector3d& I, double alpha, Vector3d m, double to_s,
                            const std::function<double(const Vector3d&)>& value) {
  constexpr double kStep = 1e-3;
  std::vector<double> roots;
  for (double t = 0; t < to_s; t += kStep) {
    const Vector3d next = rungeKutta(I, alpha, m, kStep);
    const double before = value(m), after = value(next);
    if ((before < 0) != (after < 0)) roots.push_back(t + kStep * before / (before - after));
    m = next;
  }
  return roots;
}

TEST(MotionEvents, FindTheCrossingOfTheSeparatrixAndTheFlipsWithDissipation) {
  const Vector3d I(1, 2, 3), omega(2, 0.4, 0.2);
  Forcing forcing;
  forcing.dissipation = 0.02;
  const DrivenMotion motion(PrincipalMoments(I), omega, Eigen::Quaterniond(1, 0, 0, 0), forcing, {0, 60});
  const Vector3d m = I.cwiseProduct(omega);
  const auto crossings = rootsOf(I, 0.02, m, 60, [&](const Vector3d& now) {
    return now.squaredNorm() - now.dot(now.cwiseQuotient(I)) * I[1];
  });
  const auto flips = rootsOf(I, 0.02, m, 60, [](const Vector3d& now) { return now[1]; });
  std::vector<double> foundCrossings, foundFlips;
  for (const MotionEvent& event : motionEvents(motion, forcing, {0, 60}))
    (event.kind == EventKind::kSeparatrix ? foundCrossings : foundFlips).push_back(event.t_s);
  ASSERT_EQ(crossings.size(), 1u);
  ASSERT_EQ(foundCrossings.size(), 1u);
  EXPECT_NEAR(foundCrossings[0], crossings[0], 1e-6);  // the error of the linear interpolation
  ASSERT_EQ(foundFlips.size(), flips.size());
  ASSERT_GT(flips.size(), 5u);
  for (std::size_t i = 0; i < flips.size(); ++i) EXPECT_NEAR(foundFlips[i], flips[i], 1e-6) << i;
}

/// Heavy symmetric top with I1 across, I3 along and weight M g l, released at a tilt with spin w3 alone.
struct ReleasedTop {
  double I1 = 1, I3 = 0.4, weight = 2, spin = 14, tilt = 0.6;

  Forcing forcing() const {
    Forcing gravity;
    gravity.gravity_B = Vector3d(0, 0, weight);
    return gravity;
  }
  DrivenMotion motion(const Vector3d& omega, double from_s, double to_s) const {
    const Eigen::Quaterniond q(std::cos(tilt / 2), std::sin(tilt / 2), 0, 0);
    return {PrincipalMoments(Vector3d(I1, I1, I3)), omega, q, forcing(), {from_s, to_s}};
  }
  /// Returns the roots u1 <= u2 <= u3 of (alpha - a u)(1 - u^2) - (b - c u)^2 for the release without precession.
  /// Then u2 = cos(tilt), and the other two roots follow from a quadratic: with c = I3 spin/I1,
  /// a (1 - u^2) = c^2 (u2 - u).
  std::array<double, 3> roots() const {
    const double a = 2 * weight / I1, c = I3 * spin / I1, u2 = std::cos(tilt);
    // a u^2 - c^2 u + (c^2 u2 - a) = 0
    const double root = std::sqrt(c * c * c * c - 4 * a * (c * c * u2 - a));
    return {(c * c - root) / (2 * a), u2, (c * c + root) / (2 * a)};
  }
  double period() const {
    const auto [u1, u2, u3] = roots();
    return 4 * completeK((u3 - u2) / (u3 - u1)) / std::sqrt(2 * weight / I1 * (u3 - u1));
  }
};

double tiltAt(const DrivenMotion& motion, double t_s) {
  return std::acos((motion.at(t_s).q_WB * Vector3d::UnitZ()).z());
}

// The released top is at a cusp: the tilt is least at the multiples of the period, and largest half way between.
TEST(MotionEvents, AreTheTurningPointsOfANutation) {
  const ReleasedTop top;
  const double period = top.period();
  const DrivenMotion motion = top.motion({0, 0, top.spin}, -1.2 * period, 3.2 * period);
  const auto events = motionEvents(motion, top.forcing(), {-1.2 * period, 3.2 * period});
  ASSERT_EQ(events.size(), 9u);
  for (int i = 0; i < 9; ++i) {
    const MotionEvent& event = events[static_cast<std::size_t>(i)];
    const bool least = i % 2 == 0;
    EXPECT_EQ(event.kind, least ? EventKind::kLeastTilt : EventKind::kMostTilt) << i;
    EXPECT_NEAR(event.t_s, (i - 2) * period / 2, 1e-10) << i;
    EXPECT_NEAR(tiltAt(motion, event.t_s), std::acos(top.roots()[least ? 1 : 0]), 1e-10) << i;
  }
}

TEST(MotionEvents, IncludeTurningPointsAtTheEndsOfTheSpan) {
  const ReleasedTop top;
  const DrivenMotion motion = top.motion({0, 0, top.spin}, -1, 1);
  const auto from = motionEvents(motion, top.forcing(), {0, 0.3 * top.period()});
  ASSERT_EQ(from.size(), 1u);
  EXPECT_EQ(from[0].t_s, 0);
  EXPECT_EQ(from[0].kind, EventKind::kLeastTilt);
  const auto to = motionEvents(motion, top.forcing(), {-0.3 * top.period(), 0});
  ASSERT_EQ(to.size(), 1u);
  EXPECT_EQ(to[0].t_s, 0);
  EXPECT_EQ(to[0].kind, EventKind::kLeastTilt);
}

// A steady precession solves I1 cos(theta) W^2 - I3 w3 W + M g l = 0. With omega = W z + (w3 - W cos(theta)) k,
// the component of omega across k is W sin(theta), towards the vertical.
TEST(MotionEvents, DoNotExistForASteadyPrecession) {
  const ReleasedTop top;
  const double u = std::cos(top.tilt), L3 = top.I3 * top.spin;
  const double rate = (L3 - std::sqrt(L3 * L3 - 4 * top.I1 * u * top.weight)) / (2 * top.I1 * u);
  const DrivenMotion motion = top.motion({0, rate * std::sin(top.tilt), top.spin}, 0, 10);
  ASSERT_NEAR(tiltAt(motion, 7), top.tilt, 1e-9);
  EXPECT_TRUE(motionEvents(motion, top.forcing(), {0, 10}).empty());
}

}  // namespace
}  // namespace poinsot::physics
