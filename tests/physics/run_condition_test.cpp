// SPDX-License-Identifier: Apache-2.0
#include "physics/run_condition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "core/error.h"
#include "physics/binet.h"
#include "physics/free_motion.h"
#include "physics/random_bodies.h"
#include "physics/stability.h"

namespace poinsot::physics {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// Most steps of 2^-52 by which rounded() moves each component.
constexpr int kSteps = 32;
Vector3d rounded(const Vector3d& v, Draw& draw) {
  Vector3d off = v;
  for (double& x : off)
    x *= 1 + std::round(draw.between(-kSteps, kSteps)) * std::numeric_limits<double>::epsilon();
  return off;
}

double angleBetween(const Quaterniond& a, const Quaterniond& b) {
  const Quaterniond d = a.conjugate() * b;
  return 2 * std::atan2(d.vec().norm(), std::abs(d.w()));
}

/// Returns the largest angle that such roundings cause, divided by kSteps, in the last half period before t. Near
/// the separatrix the body mostly turns about the middle axis, and errors show only in the times of flips.
double spread(const PrincipalMoments& moments, const Vector3d& omega, double t, Draw& draw) {
  const FreeMotion exact(moments, omega, Quaterniond::Identity());
  const double last = std::min(t, flipTimes(moments, omega).interval_s);
  double worst = 0;
  for (int i = 0; i < 12; ++i) {
    const FreeMotion other(PrincipalMoments(rounded(moments.values(), draw)), rounded(omega, draw),
                           Quaterniond::Identity());
    for (int j = 0; j < 40; ++j) {
      const double at = t - last * j / 40;
      worst = std::max(worst, angleBetween(exact.at(at).q_WB, other.at(at).q_WB));
    }
  }
  return worst / kSteps;
}

/// Ratio of the stated to the measured uncertainty.
struct Ratio {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  int cases = 0;
};

template <typename Omega>
Ratio ratios(std::uint64_t seed, double shortest, double longest, Omega omegaOf) {
  Draw draw(seed);
  Ratio ratio;
  for (int i = 0; i < 100; ++i) {
    const PrincipalMoments moments = draw.moments();
    const Vector3d omega = omegaOf(draw, moments);
    const double t = draw.decade(shortest, longest);
    const double stated = runCondition(moments, omega, t).attitude_rad, measured = spread(moments, omega, t, draw);
    if (measured > 0.1 / kSteps) continue;  // no longer a small angle
    ++ratio.cases;
    ratio.least = std::min(ratio.least, stated / measured);
    ratio.most = std::max(ratio.most, stated / measured);
  }
  return ratio;
}

void expectWithin(const Ratio& ratio, double least, double most) {
  if (std::getenv("POINSOT_SHOW_RESIDUALS"))
    std::printf("  stated/measured %.3g to %.3g (bounds %g, %g) in %d cases\n", ratio.least, ratio.most, least,
                most, ratio.cases);
  EXPECT_GE(ratio.cases, 90);
  EXPECT_GE(ratio.least, least);
  EXPECT_LE(ratio.most, most);
}

TEST(RunCondition, MatchesTheSpreadOfRoundedInputs) {
  const Ratio ratio =
      ratios(291, 1, 8, [](Draw& draw, const PrincipalMoments&) { return Vector3d(draw.direction()); });
  expectWithin(ratio, 0.2, 20);  // measured 0.71 to 6.4
}

// Starts lie far from the middle axis on polhodes that pass it closely, where every rounding moves the flips.
TEST(RunCondition, IsRightNearTheSeparatrix) {
  const Ratio ratio = ratios(292, 1, 6, [](Draw& draw, const PrincipalMoments& moments) {
    const Separatrix s = *separatrix(moments);
    const double off = draw.sign() * draw.decade(-9, -2);
    Vector3d m = s.momentumCircle(1, 8, false)[2];
    m[s.largest] *= 1 + off;
    return Vector3d(m.cwiseQuotient(moments.values()));
  });
  expectWithin(ratio, 0.2, 100);  // measured 1.1 to 37
}

// Times end before rounding has grown to a flip.
TEST(RunCondition, IsRightOnTheSeparatrix) {
  const Ratio ratio = ratios(293, 0, 2, [](Draw&, const PrincipalMoments& moments) {
    return Vector3d(separatrix(moments)->momentumCircle(1, 8, false)[2].cwiseQuotient(moments.values()));
  });
  expectWithin(ratio, 1, 200);  // measured 5.8 to 60
}

// A faint disturbance that is a separate number is relatively exact, and so are the times of the flips. An
// uncertainty of eps/mc would be 1e11 times too large.
TEST(RunCondition, IsRightForAFaintDisturbanceOfTheMiddleAxis) {
  const Ratio ratio = ratios(294, 1, 6, [](Draw& draw, const PrincipalMoments& moments) {
    Vector3d omega = draw.decade(-6, -2) * draw.direction();
    omega[moments.ascendingAxes()[1]] = 1;
    return omega;
  });
  expectWithin(ratio, 0.01, 20);  // measured 0.05 to 3.7
}

// If the same body is described in other axes, the disturbance is known only to the rounding of omega.
TEST(RunCondition, GrowsIfAFaintDisturbanceIsGivenInOtherAxes) {
  const PrincipalMoments moments({1, 2, 3});
  const Eigen::Quaterniond q_BP(Eigen::AngleAxisd(0.7, Vector3d(1, 2, 2) / 3));
  const PrincipalAxes turned(moments, q_BP);
  const Vector3d omega_P(1e-5, 1, 0);
  const double aligned = runCondition(moments, omega_P, 100).attitude_rad;
  const double stated = runCondition(turned, turned.toB(omega_P), 100).attitude_rad;
  EXPECT_GT(stated, 1000 * aligned);
  Draw draw(295);
  double worst = 0;
  const FreeMotion exact(turned, turned.toB(omega_P), Quaterniond::Identity());
  for (int i = 0; i < 40; ++i) {
    const FreeMotion other(turned, rounded(turned.toB(omega_P), draw), Quaterniond::Identity());
    for (int j = 0; j < 40; ++j)
      worst = std::max(worst, angleBetween(exact.at(60 + j).q_WB, other.at(60 + j).q_WB) / kSteps);
  }
  EXPECT_GT(stated / worst, 0.1);
  EXPECT_LT(stated / worst, 100);
}

// The formula gives an uncertainty of eps 2 pi 1e6 for a steady spin of 1000 turns/s during 1000 s.
TEST(RunCondition, CountsDigitsTurnsAndFlips) {
  const double turn = 2 * 3.14159265358979323846;
  const RunCondition steady = runCondition(PrincipalMoments({2, 3, 4}), {0, 0, 1000 * turn}, -1000);
  EXPECT_NEAR(steady.turns, 1e6, 1e-9);
  EXPECT_EQ(steady.flips, 0);
  EXPECT_NEAR(steady.attitude_rad, std::ldexp(1, -52) * turn * 1e6, 3e-16);
  EXPECT_NEAR(steady.digits, 8.8554, 5e-5);  // -log10 1.3951e-9
  const RunCondition flips =
      runCondition(PrincipalMoments({1, 2, 3}), {0x1p-10, 1, 0}, 10 * 57.62716233737096 / 2);
  EXPECT_NEAR(flips.flips, 10, 1e-13);  // two flips in a period of 57.6 s
  EXPECT_EQ(runCondition(PrincipalMoments({1, 2, 2.25}), {.75, .5, 1}, 1e4).digits, 0);
  EXPECT_EQ(runCondition(PrincipalMoments({2, 3, 4}), {0, 0, 0}, 5).attitude_rad, std::ldexp(1, -52));
  EXPECT_THROW(runCondition(PrincipalMoments({2, 3, 4}), {NAN, 0, 0}, 5), core::Error);
}

}  // namespace
}  // namespace poinsot::physics
