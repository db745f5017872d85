// SPDX-License-Identifier: Apache-2.0
#include "physics/stability.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/error.h"
#include "physics/free_motion.h"
#include "physics/polhode.h"
#include "physics/random_bodies.h"
#include "physics/residual.h"

namespace poinsot::physics {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kTurn = 2 * 3.14159265358979323846;

// A T-handle, which spins at 1 turn/s about its shaft, the middle axis.
const PrincipalMoments kTHandle({0.279722222222222, 0.513333333333333, 0.773055555555556});

TEST(SpinStability, IsUnstableOnlyAboutTheMiddleAxis) {
  const SpinStability shaft = spinStability(kTHandle, 1, kTurn);
  EXPECT_EQ(shaft.kind, Stability::kUnstable);
  EXPECT_NEAR(shaft.rate, 3.3282, 5e-5);
  EXPECT_EQ(spinStability(kTHandle, 0, kTurn).kind, Stability::kStable);
  EXPECT_EQ(spinStability(kTHandle, 2, -kTurn).kind, Stability::kStable);
}

// A small disturbance of a stable spin returns after one period, which must be the polhode's.
TEST(SpinStability, HasTheFrequencyOfSmallPolhodes) {
  Draw draw(271);
  double worst = 0;
  for (int i = 0; i < 200; ++i) {
    const PrincipalMoments moments = draw.moments();
    const auto axes = moments.ascendingAxes();
    for (const int axis : {axes[0], axes[2]}) {
      const double spin = draw.sign() * draw.between(0.3, 3);
      Vector3d omega = 1e-9 * draw.direction();
      omega[axis] = spin;
      const SpinStability stability = spinStability(moments, axis, spin);
      EXPECT_EQ(stability.kind, Stability::kStable);
      worst = std::max(worst, std::abs(Polhode(moments, omega).period() * stability.rate / kTurn - 1));
    }
  }
  expectResidual("period of a small circling, relative", worst, 1e-12);  // measured 3.3e-16
}

// A relative disturbance of 1e-9 must grow at the stated rate.
TEST(SpinStability, HasTheGrowthRateOfADisturbance) {
  Draw draw(272);
  double worst = 0;
  for (int i = 0; i < 100; ++i) {
    const PrincipalMoments moments = draw.moments();
    const auto [a, k, c] = moments.ascendingAxes();
    const SpinStability stability = spinStability(moments, k, 1.5);
    EXPECT_EQ(stability.kind, Stability::kUnstable);
    Vector3d omega = Vector3d::Zero();
    omega[k] = 1.5;
    omega[a] = 1e-9;
    const FreeMotion motion(moments, omega, Quaterniond::Identity());
    // A disturbance that starts without velocity grows as cosh.
    const double t = 5 / stability.rate, grown = motion.at(t).omega_B[a] / omega[a];
    worst = std::max(worst, std::abs(grown / std::cosh(5.0) - 1));
  }
  expectResidual("growth over five e-foldings, relative", worst, 1e-11);  // measured 6.8e-14
}

TEST(SpinStability, IsNeutralForEqualMomentsAndAtRest) {
  EXPECT_EQ(spinStability(PrincipalMoments({2, 2, 2}), 1, 3).kind, Stability::kNeutral);
  EXPECT_EQ(spinStability(PrincipalMoments({2, 2, 3}), 0, 3).kind, Stability::kNeutral);
  EXPECT_EQ(spinStability(PrincipalMoments({2, 3, 4}), 0, 0).kind, Stability::kNeutral);
  EXPECT_EQ(spinStability(PrincipalMoments({2, 2, 3}), 2, 3).kind, Stability::kStable);
  EXPECT_EQ(spinStability(PrincipalMoments({2, 2, 3}), 2, 3).rate, 1.5);  // Omega_p = (3/2 - 1) 3
  EXPECT_THROW(spinStability(PrincipalMoments({2, 2, 3}), 3, 1), std::logic_error);
}

// Expected flip intervals in s are computed apart from the code. Each decade of the disturbance adds
// (2/lambda) ln 10 = 1.38367 s.
TEST(FlipTimes, MatchComputedIntervalsOfTheTHandle) {
  const double expected[][2] = {{0.1, 3.31061953}, {0.01, 4.69446708}, {0.001, 6.07814236}, {0.0001, 7.46181502}};
  for (const auto& [disturbance, flip_s] : expected) {
    const FlipTimes flip = flipTimes(kTHandle, {disturbance, kTurn, 0});
    EXPECT_NEAR(flip.interval_s, flip_s, 5.1e-9);
    EXPECT_NEAR(flip.growthRate, 3.3282, 2e-3);
    // The next term: K = ln(4/sqrt mc) + (mc/4)(ln(4/sqrt mc) - 1) + ...
    const double mc = flip.complementary, logarithm = std::log(4 / std::sqrt(mc));
    EXPECT_NEAR(flip.interval_s - flip.asymptotic_s, mc / (2 * flip.growthRate) * (logarithm - 1),
                mc * mc * flip.interval_s + 2e-15);
  }
  const double decade =
      flipTimes(kTHandle, {1e-6, kTurn, 0}).interval_s - flipTimes(kTHandle, {1e-5, kTurn, 0}).interval_s;
  EXPECT_NEAR(decade, 1.38367, 5e-6);
}

// In the motion, omega_2 is reversed after one interval, restored after two, and 0 after half of one.
TEST(FlipTimes, MatchTheMotion) {
  const Vector3d omega(0.01, kTurn, 0);
  const FreeMotion motion(kTHandle, omega, Quaterniond::Identity());
  const double flip_s = flipTimes(kTHandle, omega).interval_s;
  EXPECT_NEAR(motion.at(flip_s).omega_B[1], -kTurn, 1e-13);
  EXPECT_NEAR(motion.at(2 * flip_s).omega_B[1], kTurn, 1e-13);
  EXPECT_NEAR(motion.at(flip_s / 2).omega_B[1], 0, 1e-13);
}

TEST(FlipTimes, AreRightInLimitingCases) {
  EXPECT_EQ(flipTimes(kTHandle, {0, 1, 0}).interval_s, 0);
  EXPECT_EQ(flipTimes(PrincipalMoments({1, 2, 2.25}), {.75, .5, 1}).interval_s, INFINITY);
  EXPECT_NEAR(flipTimes(PrincipalMoments({1, 2, 2.25}), {.75, .5, 1}).growthRate, 0.4289845892077917, 1e-16);
  EXPECT_THROW(flipTimes(kTHandle, {NAN, 1, 0}), core::Error);
}

/// Returns the time between two sign changes of the middle component of L, by Runge-Kutta steps of order 4 of
/// Euler's equations dm/dt = m x (I^-1 m) alone.
double integratedInterval(const PrincipalMoments& moments, Vector3d m_P) {
  const int middle = moments.ascendingAxes()[1];
  const auto rate = [&](const Vector3d& m) -> Vector3d { return m.cross(m.cwiseQuotient(moments.values())); };
  const double h = 2e-3 / m_P.cwiseQuotient(moments.values()).norm();
  std::vector<double> crossings;
  for (int i = 0; crossings.size() < 2; ++i) {
    const Vector3d a = rate(m_P), b = rate(m_P + 0.5 * h * a), c = rate(m_P + 0.5 * h * b), d = rate(m_P + h * c);
    const Vector3d next = m_P + h / 6 * (a + 2 * b + 2 * c + d);
    if ((m_P[middle] < 0) != (next[middle] < 0))
      crossings.push_back(h * (i + m_P[middle] / (m_P[middle] - next[middle])));
    m_P = next;
  }
  return crossings[1] - crossings[0];
}

TEST(FlipInterval, IsTheTimeBetweenSignChangesOfTheMiddleComponent) {
  Draw draw(314);
  double worst = 0;
  for (int i = 0; i < 40; ++i) {
    const PrincipalMoments moments = draw.moments();
    const Vector3d m_P = draw.decade(-2, 2) * draw.direction();
    const double exact = flipInterval(moments, m_P);
    worst = std::max(worst, std::abs(integratedInterval(moments, m_P) / exact - 1));
    EXPECT_EQ(exact, flipTimes(moments, m_P.cwiseQuotient(moments.values())).interval_s);
  }
  expectResidual("interval against integrated", worst, 1e-10);  // measured 1.2e-11
}

TEST(FlipInterval, IsContinuousAtSteadySpins) {
  const Vector3d& I = kTHandle.values();
  for (const int axis : {0, 2}) {
    const Vector3d along = -3 * Vector3d::Unit(axis);
    // Equation (24) linearised: the square of the rate is w² (I_k - I_i)(I_k - I_j)/(I_i I_j).
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    const double rate = 3 / I[axis] * std::sqrt((I[axis] - I[i]) * (I[axis] - I[j]) / (I[i] * I[j]));
    EXPECT_NEAR(flipInterval(kTHandle, along) * rate, 3.14159265358979324, 1e-14);
    // A polhode of 1e-5 rad takes longer by a relative amount of about that angle squared.
    const Vector3d beside = along + 3e-5 * (Vector3d(1, 1, 1) - Vector3d::Unit(axis));
    EXPECT_NEAR(flipInterval(kTHandle, beside) / flipInterval(kTHandle, along), 1, 1e-8);
  }
  EXPECT_EQ(flipInterval(kTHandle, {0, 5, 0}), std::numeric_limits<double>::infinity());
  EXPECT_EQ(flipInterval(kTHandle, {0, -5, 0}), std::numeric_limits<double>::infinity());
}

// Flips of a symmetric body slow down as L approaches the plane across its axis, where no flip ever comes.
TEST(FlipInterval, GrowsTowardsTheEquatorOfASymmetricBody) {
  const PrincipalMoments disc({1, 1, 2});
  EXPECT_GT(flipInterval(disc, {1, 0, 1e-9}), 1e8 * flipInterval(disc, {1, 0, 1}));
  EXPECT_EQ(flipInterval(disc, {1, 2, 0}), std::numeric_limits<double>::infinity());
}

TEST(Stability, RefusesNumbersThatAreNotFinite) {
  for (const double bad : {NAN, INFINITY, -INFINITY}) {
    EXPECT_THROW(spinStability(kTHandle, 1, bad), core::Error);
    EXPECT_THROW(spinStability(kTHandle, {0, bad, 0}), core::Error);
    EXPECT_THROW(spinStability(kTHandle, {bad, 1, 0}), core::Error);
    EXPECT_THROW(flipInterval(kTHandle, {bad, 1, 0}), core::Error);
  }
}

TEST(Stability, IsEqualForAnAxisAndAVectorAlongIt) {
  for (const double w : {1e-300, -3.0, 1e300})
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d omega_P = w * Vector3d::Unit(axis);
      EXPECT_EQ(spinStability(kTHandle, omega_P).kind, spinStability(kTHandle, axis, w).kind);
      const Vector3d rounded = omega_P + 1e-14 * w * Vector3d(1, 1, 1);
      EXPECT_EQ(spinStability(kTHandle, rounded).kind, spinStability(kTHandle, axis, w).kind);
    }
  EXPECT_EQ(spinStability(PrincipalMoments({1, 1, 2}), {3, 4, 0}).kind, Stability::kNeutral);
  EXPECT_EQ(spinStability(kTHandle, {0, 0, 0}).kind, Stability::kNeutral);
}

}  // namespace
}  // namespace poinsot::physics
