// SPDX-License-Identifier: Apache-2.0
#include "physics/heavy_top.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "core/error.h"
#include "physics/driven_motion.h"
#include "physics/random_bodies.h"
#include "physics/residual.h"

namespace poinsot::physics {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kDegree = 3.14159265358979323846 / 180;

// Expected values for this top come from two other methods, a closed form and a Taylor integration.
const PrincipalMoments kMoments({1.40625, 1.40625, 0.65625});
const Vector3d kGravity(0, 0, 2.84375);
constexpr double kSpin = 9.15625;

Vector3d upAtTilt(double tilt_rad) { return {std::sin(tilt_rad), 0, std::cos(tilt_rad)}; }

TEST(HeavyTop, HasTheLimitingSpinOfASleepingTop) {
  EXPECT_NEAR(heavyTop(kMoments, kGravity)->sleepingSpin(), 6.09449400220044, 3e-15);
}

TEST(HeavyTop, HasASlowAndAFastSteadyPrecession) {
  const auto rates = heavyTop(kMoments, kGravity)->steadyPrecession(30 * kDegree, kSpin);
  ASSERT_TRUE(rates);
  EXPECT_NEAR(rates->slow, 0.530251265914263, 6e-16);
  EXPECT_NEAR(rates->fast, 4.40368790953541, 6e-15);
  // Below the least spin for the tilt no rate exists; a hanging top needs no spin.
  EXPECT_FALSE(heavyTop(kMoments, kGravity)->steadyPrecession(30 * kDegree, 5));
  const auto pendulum = heavyTop(kMoments, kGravity)->steadyPrecession(120 * kDegree, 0);
  ASSERT_TRUE(pendulum);
  EXPECT_NEAR(std::abs(pendulum->slow), std::sqrt(2.84375 / (1.40625 * 0.5)), 2e-15);  // conical: Mgl = I1 cos W²
  EXPECT_EQ(pendulum->slow, -pendulum->fast);
  const auto level = heavyTop(kMoments, kGravity)->steadyPrecession(0.5 * 180 * kDegree, kSpin);
  EXPECT_NEAR(level->slow, 2.84375 / (0.65625 * kSpin), 1e-15);  // Mgl/(I3 omega_3)
  EXPECT_TRUE(std::isinf(level->fast));
  EXPECT_TRUE(std::isfinite(heavyTop(kMoments, kGravity)->steadyPrecession(89.999 * kDegree, kSpin)->fast));
}

TEST(HeavyTop, HasTheNutationOfAReleasedTop) {
  const Nutation swing = heavyTop(kMoments, kGravity)->nutation({0, 0, kSpin}, upAtTilt(30 * kDegree));
  EXPECT_NEAR(swing.leastTilt_rad / kDegree, 30, 1e-13);
  EXPECT_NEAR(swing.mostTilt_rad / kDegree, 38.840183490757, 6e-13);
  EXPECT_NEAR(swing.period_s, 1.83064120697989845, 4e-15);
  EXPECT_NEAR(swing.precession_rad, 0.958047879275758037, 4e-15);
}

// A start at a steady rate keeps the tilt. The swing's period is then the period of small nutations.
TEST(HeavyTop, SteadyPrecessionDoesNotNutate) {
  const HeavyTop top = *heavyTop(kMoments, kGravity);
  const Vector3d up = upAtTilt(30 * kDegree);
  for (const double rate :
       {top.steadyPrecession(30 * kDegree, kSpin)->slow, top.steadyPrecession(30 * kDegree, kSpin)->fast}) {
    // omega = rate up, plus a part along k that completes omega_3.
    const Vector3d omega = rate * up + (kSpin - rate * up[2]) * Vector3d::UnitZ();
    const Nutation swing = top.nutation(omega, up);
    EXPECT_NEAR(swing.leastTilt_rad, 30 * kDegree, 1e-7);
    EXPECT_NEAR(swing.mostTilt_rad, 30 * kDegree, 1e-7);
    EXPECT_NEAR(swing.precession_rad / swing.period_s, rate, 1e-7);
  }
}

// The integrated motion must stay between the tilts. After a period its axis must have the same height and be
// turned by the precession.
TEST(HeavyTop, NutationMatchesTheIntegratedMotion) {
  Draw draw(301);
  double tilt = 0, turned = 0;
  for (int i = 0; i < 25; ++i) {
    const double Ip = draw.between(0.6, 2);
    const PrincipalMoments moments({Ip, Ip, Ip * draw.between(0.1, 1.9)});
    Forcing forcing;
    forcing.gravity_B = {0, 0, draw.sign() * draw.between(0.3, 2)};
    const Vector3d omega0 = draw.direction() * draw.between(0.5, 4);
    const Quaterniond q0 = draw.attitude();
    const HeavyTop top = *heavyTop(moments, forcing.gravity_B);
    const Nutation swing = top.nutation(omega0, q0.conjugate() * Vector3d::UnitZ());
    const DrivenMotion motion(moments, omega0, q0, forcing, {0, 2 * swing.period_s});
    const auto k_W = [&](double t) { return Vector3d(motion.at(t).q_WB * top.k_P); };
    double highest = -1, lowest = 1, swept = 0;
    constexpr int kSteps = 400;
    for (int j = 0; j < kSteps; ++j) {
      const Vector3d k = k_W(swing.period_s * j / kSteps), next = k_W(swing.period_s * (j + 1) / kSteps);
      highest = std::max(highest, k[2]);
      lowest = std::min(lowest, k[2]);
      swept += std::atan2(k[0] * next[1] - k[1] * next[0], k[0] * next[0] + k[1] * next[1]);
    }
    EXPECT_LE(highest, std::cos(swing.leastTilt_rad) + 1e-12);
    EXPECT_GE(lowest, std::cos(swing.mostTilt_rad) - 1e-12);
    const double range = std::cos(swing.leastTilt_rad) - std::cos(swing.mostTilt_rad);
    EXPECT_GE(highest - lowest, range * (1 - 1e-3));
    tilt = std::max(tilt, std::abs(k_W(swing.period_s)[2] - k_W(0)[2]));
    turned = std::max(turned, std::abs(std::remainder(swept - swing.precession_rad, 2 * 180 * kDegree)));
  }
  expectResidual("height of the axis after a period", tilt, 1e-12);  // measured 3.2e-14
  // The closer an axis passes to the vertical, the faster its azimuth turns.
  expectResidual("precession in a period, rad", turned, 5e-11);  // measured 4.9e-12
}

TEST(HeavyTop, UprightTopSleepsOrFallsByItsSpin) {
  const HeavyTop top = *heavyTop(kMoments, kGravity);
  const Nutation upright = top.nutation({0, 0, kSpin}, {0, 0, 1});
  EXPECT_EQ(upright.leastTilt_rad, 0);
  EXPECT_EQ(upright.mostTilt_rad, 0);
  // A top that is too slow falls from upright in infinite time, down to the other root of f. By hand:
  // cos theta = L3²/(2 I1 Mgl) - 1.
  const double slow = 4;
  const Nutation falling = top.nutation({0, 0, slow}, {0, 0, 1});
  EXPECT_EQ(falling.leastTilt_rad, 0);
  EXPECT_EQ(falling.period_s, INFINITY);
  const double L3 = 0.65625 * slow;
  EXPECT_NEAR(std::cos(falling.mostTilt_rad), L3 * L3 / (2 * 1.40625 * 2.84375) - 1, 1e-15);
}

// An axis that passes close to the vertical turns by half a turn more or less than one that passes through it.
TEST(HeavyTop, AzimuthGainsHalfATurnPastTheVertical) {
  const HeavyTop top = *heavyTop(kMoments, kGravity);
  const auto swing = [&](double lean) { return top.nutation({0.5, 0, kSpin}, Vector3d(lean, 0, 1).normalized()); };
  const Nutation through = swing(0);
  EXPECT_EQ(through.leastTilt_rad, 0);
  for (const double lean : {1e-5, 1e-8, 1e-12, 1e-17}) {
    const double turn = swing(lean).precession_rad - through.precession_rad;
    const double other = swing(-lean).precession_rad - through.precession_rad;
    EXPECT_NEAR(turn, 180 * kDegree, 20 * lean);
    EXPECT_NEAR(other, -180 * kDegree, 20 * lean);
    EXPECT_NEAR(swing(lean).leastTilt_rad, lean, 1e-6 * lean);
  }
  // An upright top at the limiting spin does not move.
  EXPECT_EQ(top.nutation({0, 0, top.sleepingSpin()}, {0, 0, 1}).mostTilt_rad, 0);
}

// Spins and weights of any size, near the vertical and at rest, must give a swing with ordered tilts.
TEST(HeavyTop, AnyStartGivesAValidNutation) {
  Draw draw(302);
  for (int i = 0; i < 5000; ++i) {
    const double Ip = draw.decade(-6, 6);
    const HeavyTop top = *heavyTop(PrincipalMoments({Ip, Ip, Ip * draw.between(1e-3, 2)}),
                                   {0, 0, draw.sign() * draw.decade(-8, 8)});
    const Vector3d up = (draw.sign() * Vector3d::UnitZ() + draw.decade(-20, 1) * draw.direction()).normalized();
    const double along = i % 5 == 0 ? 0 : draw.sign() * draw.decade(-6, 6),
                 across = i % 3 == 0 ? 0 : draw.decade(-9, 3);
    const Nutation swing = top.nutation(along * Vector3d::UnitZ() + across * draw.direction(), up);
    EXPECT_LE(swing.leastTilt_rad, swing.mostTilt_rad);
    EXPECT_GT(swing.period_s, 0);
    EXPECT_FALSE(std::isnan(swing.precession_rad));
  }
}

TEST(HeavyTop, NeedsGravityAlongTheSymmetryAxis) {
  EXPECT_FALSE(heavyTop(kMoments, {0, 0, 0}));
  EXPECT_FALSE(heavyTop(kMoments, {1, 0, 0}));
  EXPECT_FALSE(heavyTop(kMoments, {0, 1e-13, 1}));
  EXPECT_TRUE(heavyTop(kMoments, {0, 1e-16, 1}));
  EXPECT_FALSE(heavyTop(PrincipalMoments({2, 3, 4}), kGravity));
  EXPECT_TRUE(heavyTop(PrincipalMoments({2, 2, 2}), {0, -1, 0}));
  EXPECT_EQ(heavyTop(kMoments, {0, 0, -3})->k_P, Vector3d(0, 0, -1));
  const PrincipalMoments rounded({2, 2 + 1e-6, 3});  // moments that are equal to six digits
  EXPECT_FALSE(heavyTop(rounded, kGravity));
  EXPECT_NEAR(heavyTop(rounded, kGravity + Vector3d(1e-7, 0, 0), 1e-6)->across, 2 + 0.5e-6, 1e-15);
  EXPECT_FALSE(heavyTop(rounded, kGravity, 1e-7));
}

TEST(HeavyTop, RefusesNumbersThatAreNotFinite) {
  const Vector3d up = Vector3d::UnitZ();
  const HeavyTop top = *heavyTop(kMoments, kGravity);
  for (const double bad : {NAN, INFINITY, -INFINITY}) {
    EXPECT_THROW(heavyTop(kMoments, {0, 0, bad}), core::Error);
    EXPECT_THROW(heavyTop(kMoments, {bad, 0, 1}), core::Error);
    EXPECT_THROW(heavyTop(kMoments, kGravity, bad), core::Error);
    EXPECT_THROW(top.steadyPrecession(bad, 1), core::Error);
    EXPECT_THROW(top.steadyPrecession(1, bad), core::Error);
    EXPECT_THROW(top.nutation({0, bad, 1}, up), core::Error);
  }
}

// Worked out by hand: an axis released at rest draws cusps. With half of the slow precession it goes on in one
// direction, and with the opposite precession it starts backwards.
TEST(HeavyTop, NamesItsNutation) {
  const HeavyTop top = heavyTop(kMoments, kGravity).value();
  for (const double tilt_rad : {0.3, 1.0, 2.2}) {
    const Vector3d up_P = upAtTilt(tilt_rad);
    const SteadyPrecession steady = top.steadyPrecession(tilt_rad, kSpin).value();
    const auto kindAt = [&](double rate) {
      return top.nutationKind(top.omegaPrecessing(up_P, kSpin, rate), up_P);
    };
    EXPECT_EQ(kindAt(0), NutationKind::kCusps);
    EXPECT_EQ(kindAt(-steady.slow), NutationKind::kLoops);
    EXPECT_EQ(kindAt(steady.slow / 2), NutationKind::kWaves);
    EXPECT_EQ(kindAt(steady.slow), NutationKind::kSteady);
    EXPECT_EQ(kindAt(steady.fast), NutationKind::kSteady);
  }
  EXPECT_EQ(top.nutationKind({0, 0, kSpin}, {0, 0, 1}), std::nullopt);  // a sleeping top
}

// The spin of a precession must have this rate among its two steady ones. Measured: 3e-16.
TEST(HeavyTop, FindsTheSpinOfAPrecession) {
  const HeavyTop top = heavyTop(kMoments, kGravity).value();
  for (const double rate : {0.2, 1.5, 6.0, -2.0}) {
    const auto [slow, fast] = top.steadyPrecession(1.1, top.spinOfPrecession(1.1, rate)).value();
    EXPECT_LT(std::min(std::abs(slow / rate - 1), std::abs(fast / rate - 1)), 2e-14) << rate;
  }
}

}  // namespace
}  // namespace poinsot::physics
