// SPDX-License-Identifier: Apache-2.0
// Nearest starts whose motion repeats. Oracles without K and Q (theta functions, Taylor series) show that the
// motion repeats. A blind search over all directions of L shows that no nearer start does.
#include "physics/closed_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "physics/free_motion.h"
#include "physics/herpolhode.h"
#include "physics/polhode.h"
#include "physics/random_bodies.h"
#include "physics/residual.h"
#include "physics/taylor_oracle.h"
#include "physics/theta_oracle.h"

namespace poinsot::physics {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kPi_ = std::numbers::pi;

struct Mismatch {
  double attitude_rad, omega;  ///< omega: relative to |omega|
};

/// Returns the mismatch after the period, by theta functions in 100 digits.
Mismatch mismatchByTheta(const Vector3d& I, const ClosedStart& closed) {
  const Quaterniond q0(0.5, -0.1, 0.7, 0.3);
  const ThetaOracle oracle(I, closed.omega0_P, q0);
  const auto after = oracle.at(Real100(closed.period_s));
  return {ThetaOracle::angle(after.R, q0),
          ThetaOracle::distance(after.omega, closed.omega0_P) / closed.omega0_P.norm()};
}

double momentum(const PrincipalMoments& moments, const Vector3d& omega_P) {
  return moments.values().cwiseProduct(omega_P).norm();
}

TEST(ClosedMotion, RepeatsForRandomMotions) {
  Draw draw(401);
  double worst = 0, worstOmega = 0, worstL = 0, farthest = 0;
  for (int i = 0; i < 150; ++i) {
    const PrincipalMoments moments = draw.moments();
    const Vector3d omega_P = draw.decade(-2, 2) * draw.direction();
    const double wanted_s = draw.between(1.2, 9) * Polhode(moments, omega_P).period();
    const ClosedStart closed = nearestClosedStart(moments, omega_P, wanted_s);
    const Mismatch left = mismatchByTheta(moments.values(), closed);
    worst = std::max(worst, left.attitude_rad);
    worstOmega = std::max(worstOmega, left.omega);
    worstL = std::max(worstL, std::abs(momentum(moments, closed.omega0_P) / momentum(moments, omega_P) - 1));
    farthest = std::max(farthest, closed.change / omega_P.norm());
    EXPECT_NEAR(closed.period_s, wanted_s, 0.5 * wanted_s);
    EXPECT_NEAR(closed.mismatch_rad, left.attitude_rad, 2e-14);
    EXPECT_NEAR(closed.change, (closed.omega0_P - omega_P).norm(), 1e-15 * omega_P.norm());
  }
  expectResidual("attitude after the period, rad", worst, 1e-12);
  expectResidual("omega after the period", worstOmega, 1e-12);
  expectResidual("|L|", worstL, 1e-15);
  expectResidual("farthest start", farthest, 1);
}

TEST(ClosedMotion, RepeatsInATaylorIntegration) {
  const PrincipalMoments moments({1, 1.7, 2.6});
  const Vector3d omega_P(0.9, 0.35, 1.1);
  const ClosedStart closed = nearestClosedStart(moments, omega_P, 20);
  const TaylorOracle<Real60> oracle(moments.values(), closed.omega0_P, Quaterniond::Identity());
  const auto after = oracle.at(Real60(closed.period_s));
  expectResidual("attitude", TaylorOracle<Real60>::angle(after.q, Quaterniond::Identity()), 1e-13);
  expectResidual("omega", TaylorOracle<Real60>::distance(after.omega, closed.omega0_P), 1e-13);
}

/// These herpolhodes close (docs/physics.md, worked to 16 digits): DPhi/2pi = 8/5 and 3/4. The attitude needs
/// whole periods of the polhode: 5 (10 radial periods, 16 turns), and 2 (4 radial periods, 3 turns).
TEST(ClosedMotion, KeepsAStartThatAlreadyRepeats) {
  const PrincipalMoments moments({1.25, 2, 2.75});
  const Vector3d about3(1.577034598253537625, 0, 1.5), about1(1.5, 0, 0.422945230106353779731);
  const ClosedStart first = nearestClosedStart(moments, about3, 36);
  EXPECT_EQ(first.polhodePeriods, 5);
  EXPECT_EQ(first.turns, 16);
  expectResidual("change, 8/5", first.change, 1e-14);
  EXPECT_NEAR(first.period_s, 2 * 18.44647312604001, 4e-14);
  const ClosedStart second = nearestClosedStart(moments, about1, 19);
  EXPECT_EQ(second.polhodePeriods, 2);
  EXPECT_EQ(second.turns, 3);
  expectResidual("change, 3/4", second.change, 1e-14);
  EXPECT_NEAR(second.period_s, 2 * 9.71219205763253422, 4e-14);
}

/// Returns starts with the |L| of omega_P whose L is spread evenly over the sphere (a spiral of golden angles).
std::vector<Vector3d> startsOfOneMomentum(const PrincipalMoments& moments, const Vector3d& omega_P, int count) {
  const double L = momentum(moments, omega_P);
  std::vector<Vector3d> starts;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count, across = std::sqrt(1 - z * z), angle = i * 2.399963229728653;
    const Vector3d m = L * Vector3d(across * std::cos(angle), across * std::sin(angle), z);
    starts.emplace_back(m.cwiseQuotient(moments.values()));
  }
  return starts;
}

/// Returns the least change among grid starts that repeat, within the grid's spacing, after an allowed time.
double leastChangeByBlindSearch(const PrincipalMoments& moments, const Vector3d& omega_P, double wanted_s) {
  double least = INFINITY;
  for (const Vector3d& start : startsOfOneMomentum(moments, omega_P, 400000)) {
    const double distance = (start - omega_P).norm();
    if (distance >= least) continue;
    const Herpolhode curve(moments, start);
    if (curve.regime() != Herpolhode(moments, omega_P).regime()) continue;
    for (int m = 1; 2 * m * curve.radialPeriod() <= 1.25 * wanted_s; ++m) {
      if (2 * m * curve.radialPeriod() < wanted_s / 1.25) continue;
      const double turns = m * curve.anglePerRadialPeriod() / kPi_;
      if (std::abs(turns - std::round(turns)) < 2e-3) least = distance;
    }
  }
  return least;
}

TEST(ClosedMotion, FindsTheNearestStart) {
  const struct {
    Vector3d I, omega_P;
    double wanted_s;
  } cases[] = {{{1, 1.7, 2.6}, {0.9, 0.35, 1.1}, 20}, {{1.25, 2, 2.75}, {1.5, 0.4, 0.3}, 30}};
  for (const auto& c : cases) {
    const PrincipalMoments moments(c.I);
    const ClosedStart closed = nearestClosedStart(moments, c.omega_P, c.wanted_s);
    const double blind = leastChangeByBlindSearch(moments, c.omega_P, c.wanted_s);
    // The grid's spacing is 0.006 rad of L. Its nearest hit may be nearer by at most that, and not much farther.
    expectResidual("nearer by blind search, rad/s", closed.change - blind, 0.006);
    expectResidual("farther by blind search, rad/s", blind - closed.change, 0.02);
  }
}

/// The motion passes every point of the polhode that was found. No point may be nearer.
TEST(ClosedMotion, StartsAtTheNearestPointOfItsPolhode) {
  Draw draw(402);
  for (int i = 0; i < 40; ++i) {
    const PrincipalMoments moments = draw.moments();
    const Vector3d omega_P = draw.direction();
    const double period_s = Polhode(moments, omega_P).period();
    const ClosedStart closed = nearestClosedStart(moments, omega_P, 2 * period_s);
    const FreeMotion motion(moments, closed.omega0_P, Quaterniond::Identity());
    const double polhodePeriod_s = closed.period_s / closed.polhodePeriods;
    for (int k = 0; k < 500; ++k)
      EXPECT_GE((motion.at(polhodePeriod_s * k / 500).omega_B - omega_P).norm(), closed.change * (1 - 1e-12));
  }
}

/// Lecture, eq (29), (34): the axis goes round L at L/I1, omega round the axis at (I3/I1 - 1) omega_3. Both must
/// make whole turns in the period.
TEST(ClosedMotion, RepeatsForASymmetricTop) {
  for (const double I3 : {0.9, 2.1}) {
    const PrincipalMoments moments({1.5, 1.5, I3});
    const Vector3d omega_P(0.56, 0.1, 1.3);
    const ClosedStart closed = nearestClosedStart(moments, omega_P, 25);
    const double precession = momentum(moments, closed.omega0_P) / 1.5;
    const double wobble = std::abs(I3 / 1.5 - 1) * closed.omega0_P[2];
    EXPECT_NEAR(precession * closed.period_s, 2 * kPi_ * closed.turns, 2e-13);
    EXPECT_NEAR(wobble * closed.period_s, 2 * kPi_ * closed.polhodePeriods, 2e-13);
    EXPECT_NEAR(closed.omega0_P[1] / closed.omega0_P[0], omega_P[1] / omega_P[0], 1e-7);  // only the tilt changes
    EXPECT_LT(mismatchByTheta(moments.values(), closed).attitude_rad, 1e-13);
  }
}

TEST(ClosedMotion, RoundsSteadySpinsToWholeTurns) {
  for (const Vector3d& I : {Vector3d(1, 2, 2.5), Vector3d(2, 2, 2), Vector3d(2, 2, 3)}) {
    const ClosedStart closed = nearestClosedStart(PrincipalMoments(I), {0, 0, 3}, 10);
    EXPECT_EQ(closed.omega0_P, Vector3d(0, 0, 3));
    EXPECT_EQ(closed.change, 0);
    EXPECT_EQ(closed.turns, 5);  // 10 s are 4.77 turns
    EXPECT_NEAR(closed.period_s, 5 * 2 * kPi_ / 3, 4e-15);
    EXPECT_LT(closed.mismatch_rad, 1e-14);
  }
  const ClosedStart rest = nearestClosedStart(PrincipalMoments({1, 2, 2.5}), {0, 0, 0}, 10);
  EXPECT_EQ(rest.period_s, 10);
  EXPECT_EQ(rest.mismatch_rad, 0);
}

TEST(ClosedMotion, DropsAnInvisibleWobble) {
  const PrincipalMoments moments({1, 2, 2.5});
  const ClosedStart closed = nearestClosedStart(moments, {1e-6, 0, 3}, 10);
  EXPECT_EQ(closed.polhodePeriods, 0);
  EXPECT_EQ(closed.omega0_P[0], 0);
  EXPECT_NEAR(closed.change, 1e-6, 1e-12);
  const ClosedStart seen = nearestClosedStart(moments, {0.1, 0, 3}, 10);
  EXPECT_GT(seen.polhodePeriods, 0);
}

TEST(ClosedMotion, AcceptsAPolhodeLongerThanTheRequestedTime) {
  // L is 1e-4 off the middle axis. The polhode takes 31 s, and no loop can be shorter.
  const PrincipalMoments moments({1, 2, 2.5});
  const Vector3d omega_P(0, 2, 1e-4);
  const ClosedStart closed = nearestClosedStart(moments, omega_P, 3);
  EXPECT_EQ(closed.polhodePeriods, 1);
  EXPECT_GT(closed.period_s, 10);
  expectResidual("attitude, long period", mismatchByTheta(moments.values(), closed).attitude_rad, 1e-12);
}

TEST(ClosedMotion, RejectsTheSeparatrixAndInvalidStarts) {
  const PrincipalMoments moments({1, 2, 2.25});
  try {
    nearestClosedStart(moments, {.75, .5, 1}, 10);  // L² = 2 T I2 exactly
    FAIL();
  } catch (const core::Error& error) {
    EXPECT_NE(error.message().find("separatrix"), std::string::npos);
  }
  EXPECT_THROW(nearestClosedStart(moments, {NAN, 0, 1}, 10), core::Error);
  EXPECT_THROW(nearestClosedStart(moments, {0, 0, 1e20}, 10), core::Error);
  EXPECT_THROW(nearestClosedStart(moments, {0, 0, 1}, 0), std::logic_error);
}

}  // namespace
}  // namespace poinsot::physics
