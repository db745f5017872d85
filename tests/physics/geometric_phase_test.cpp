// SPDX-License-Identifier: Apache-2.0
#include "physics/geometric_phase.h"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "physics/binet.h"
#include "physics/free_motion.h"
#include "physics/herpolhode.h"
#include "physics/random_bodies.h"
#include "physics/residual.h"

namespace poinsot::physics {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using Real =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<60>, boost::multiprecision::et_off>;

constexpr double kPi = std::numbers::pi;

/// Angle in rad between the attitude after a period and the start, turned about L by the phase.
double missedBy(const PrincipalMoments& moments, const Vector3d& omega0, const Quaterniond& q0) {
  const GeometricPhase phase = geometricPhase(moments, omega0).value();
  const FreeMotion motion(moments, omega0, q0);
  const Quaterniond turned =
      Quaterniond(motion.at(phase.period_s).q_WB) * Quaterniond(motion.at(0).q_WB).inverse();
  const Vector3d axis = motion.L_W().normalized();
  const Quaterniond rest = turned * Quaterniond(AngleAxisd(-phase.turn_rad, axis));
  return 2 * std::atan2(rest.vec().norm(), std::abs(rest.w()));
}

/// Solid angle by quadrature with 60 digits. On the sphere |m| = L, the energy gives the polar angle theta about
/// axis c at each azimuth phi:
///   sin² theta (1/I_c - cos² phi/I_a - sin² phi/I_2) = 1/I_c - 2T/L²
/// No elliptic integral and no motion is used.
double solidAngleByQuadrature(const Vector3d& I, const Vector3d& omega0) {
  const auto axis = PrincipalMoments(I).ascendingAxes();
  Real L2 = 0, twoT = 0;
  for (int i = 0; i < 3; ++i) {
    L2 += Real(I[i]) * I[i] * omega0[i] * omega0[i];
    twoT += Real(I[i]) * omega0[i] * omega0[i];
  }
  const bool aboutLargest = L2 > twoT * I[axis[1]];
  const Real first = 1 / Real(I[axis[aboutLargest ? 0 : 2]]), middle = 1 / Real(I[axis[1]]),
             circled = 1 / Real(I[axis[aboutLargest ? 2 : 0]]);
  const Real excess = circled - twoT / L2;
  const auto height = [&](const Real& phi) -> Real {
    const Real c = cos(phi), s = sin(phi);
    const Real sine2 = excess / (circled - first * c * c - middle * s * s);
    return sine2 / (1 + sqrt(Real(abs(Real(1 - sine2)))));  // 1 - cos theta
  };
  boost::math::quadrature::tanh_sinh<Real> quadrature(18);
  const Real end = boost::math::constants::half_pi<Real>();
  return static_cast<double>(Real(4 * quadrature.integrate(height, Real(0), end, Real("1e-22"))));
}

TEST(GeometricPhase, IsTheTurnOfTheAttitudeAboutL) {
  Draw draw(411);
  double worst = 0;
  for (int i = 0; i < 400; ++i)
    worst = std::max(worst, missedBy(draw.moments(), draw.direction(), draw.attitude()));
  expectResidual("attitude after a period, rad", worst, 1e-12);  // measured 8.3e-14
}

TEST(GeometricPhase, IsTheTurnOfTheAttitudeNearSteadySpinsAndTheSeparatrix) {
  Draw draw(412);
  double worst = 0;
  for (int i = 0; i < 300; ++i) {
    const PrincipalMoments moments = draw.moments();
    Vector3d omega0 = Vector3d::Unit(i % 3);
    omega0[(i + 1) % 3] = draw.decade(-12, -1);
    omega0[(i + 2) % 3] = draw.decade(-12, -1);
    if (geometricPhase(moments, omega0)) worst = std::max(worst, missedBy(moments, omega0, draw.attitude()));
  }
  expectResidual("attitude after a period, rad", worst, 1e-12);  // measured 3e-13
}

TEST(GeometricPhase, IsTheSumOfItsParts) {
  Draw draw(413);
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    Vector3d omega0 = draw.direction();
    omega0[i % 3] *= draw.decade(-12, 0);
    omega0[(i + 1) % 3] *= draw.decade(-12, 0);
    const auto phase = geometricPhase(draw.moments(), omega0 * draw.decade(-50, 50));
    if (!phase) continue;
    const double sum = phase->dynamic_rad + phase->geometric_rad;
    worst = std::max(worst, std::abs(sum - phase->turn_rad) / std::max(std::abs(phase->dynamic_rad), 2 * kPi));
  }
  expectResidual("turn, relative", worst, 1e-15);  // measured 2.8e-16
}

TEST(GeometricPhase, SolidAngleMatchesQuadrature) {
  Draw draw(414);
  double worst = 0;
  for (int i = 0; i < 60; ++i) {
    const PrincipalMoments moments = draw.moments();
    const Vector3d omega0 = draw.direction();
    const double expected = solidAngleByQuadrature(moments.values(), omega0);
    worst = std::max(worst, std::abs(geometricPhase(moments, omega0)->solidAngle_sr / expected - 1));
  }
  expectResidual("solid angle, relative", worst, 1e-12);  // measured 8.9e-16
}

TEST(GeometricPhase, SolidAngleKeepsItsDigitsNearSteadySpinsAndTheSeparatrix) {
  Draw draw(415);
  double worst = 0, smallest = 1, nearest = 1;
  for (int i = 0; i < 60; ++i) {
    const PrincipalMoments moments = draw.moments();
    Vector3d omega0 = Vector3d::Unit(i % 3);
    omega0[(i + 1) % 3] = draw.decade(-9, -1);
    omega0[(i + 2) % 3] = draw.decade(-9, -1);
    const auto phase = geometricPhase(moments, omega0);
    if (!phase) continue;
    const double expected = solidAngleByQuadrature(moments.values(), omega0);
    worst = std::max(worst, std::abs(phase->solidAngle_sr / expected - 1));
    smallest = std::min(smallest, expected);
    const Herpolhode curve(moments, omega0);
    nearest = std::min(nearest, curve.smallestRadius() / curve.largestRadius());
  }
  expectResidual("solid angle, relative", worst, 1e-12);  // measured 8.9e-16
  EXPECT_LT(smallest, 1e-12);
  EXPECT_LT(nearest, 1e-7);
}

// Worked by hand: on a symmetric top, L goes round a circle at the angle theta from the axis, which encloses 2 pi (1 -
// cos theta). Omega_p = (I3/I1 - 1) omega_3 (eq 29) gives the period, and 2T = I1 omega_1² + I3 omega_3².
TEST(GeometricPhase, OfASymmetricTopFollowsFromItsCone) {
  Draw draw(416);
  for (int i = 0; i < 100; ++i) {
    const double I1 = 1, I3 = draw.between(0.2, 1.9), across = draw.decade(-8, 1), along = 1;
    if (std::abs(I3 - 1) < 0.05) continue;
    const auto phase = geometricPhase(PrincipalMoments({I1, I1, I3}), {across, 0, along}).value();
    const double theta = std::atan2(I1 * across, I3 * along), L = std::hypot(I1 * across, I3 * along);
    const double cap = 4 * kPi * std::sin(theta / 2) * std::sin(theta / 2), period = 2 * kPi / std::abs(I3 - 1);
    EXPECT_NEAR(phase.solidAngle_sr / cap, 1, 4e-15) << I3 << " " << across;
    EXPECT_NEAR(phase.period_s / period, 1, 4e-15);
    EXPECT_EQ(phase.sense, I3 > I1 ? 1 : -1);
    const double dynamic = (I1 * across * across + I3) * period / L;
    EXPECT_NEAR(phase.dynamic_rad / dynamic, 1, 4e-15);
    EXPECT_NEAR(phase.turn_rad, dynamic - phase.sense * cap, 1e-14 * dynamic);
  }
}

// Worked by hand: a small polhode is an ellipse. With I = (1, 2, 3) and |L| = 3, the energy gives the ratio of its
// semi-axes m_1/m_2 = sqrt((1/2 - 1/3)/(1 - 1/3)) = 1/2. The area is pi m_1 m_2/L².
TEST(GeometricPhase, OfASmallWobbleEnclosesAnEllipse) {
  for (const double m1 : {1e-4, 1e-8, 1e-12, 1e-60}) {
    const auto phase = geometricPhase(PrincipalMoments({1, 2, 3}), {m1, 0, 1}).value();
    EXPECT_NEAR(phase.solidAngle_sr / (kPi * 2 * m1 * m1 / 9), 1, 1e-15 + m1 * m1) << m1;
  }
}

// Worked by hand: next to the separatrix, the polhode about the axis of largest moment bounds the lune between two great
// circles that make the angle pi - 2 psi, with tan² psi = I3 (I2 - I1)/(I1 (I3 - I2)). The polhode about the axis
// of smallest moment bounds the other lune, of angle 2 psi.
TEST(GeometricPhase, NextToTheSeparatrixEnclosesALune) {
  const PrincipalMoments moments({1, 2, 3});
  const double psi = std::atan(std::sqrt(3.0));
  const auto largest = geometricPhase(moments, {0, 1, 1e-17}).value();
  EXPECT_EQ(largest.sense, 1);
  EXPECT_NEAR(largest.solidAngle_sr, 2 * (kPi - 2 * psi), 4e-15);
  const auto smallest = geometricPhase(moments, {1e-17, 1, 0}).value();
  EXPECT_EQ(smallest.sense, -1);
  EXPECT_NEAR(smallest.solidAngle_sr, 4 * psi, 4e-15);
  EXPECT_NEAR(separatrix(moments)->momentumAngle_rad, psi, 1e-15);
}

// Values of the closed form with 50 digits: Tp, 2T/L and the herpolhode's angle of the same start.
TEST(GeometricPhase, MatchesAKnownExample) {
  const auto phase = geometricPhase(PrincipalMoments({2, 3, 4}), {.5, .25, 1}).value();
  EXPECT_NEAR(phase.period_s, 11.18295442677762, 2e-14);
  EXPECT_NEAR(phase.dynamic_rad, 1.1185312242598 * 11.18295442677762, 2e-12);
  EXPECT_NEAR(phase.turn_rad, 2 * 9.205124422942755 - 2 * kPi, 2e-14);
  EXPECT_NEAR(phase.geometric_rad, -phase.solidAngle_sr, 0);
}

TEST(GeometricPhase, DoesNotExistForSteadySpinsAndOnTheSeparatrix) {
  const PrincipalMoments moments({1, 2, 3});
  for (const Vector3d& omega0 : {Vector3d(0, 0, 0), Vector3d(0, 0, 1), Vector3d(0, 1, 0)})
    EXPECT_FALSE(geometricPhase(moments, omega0));
  EXPECT_FALSE(geometricPhase(PrincipalMoments({1, 1, 1}), {1, 2, 3}));
  EXPECT_FALSE(geometricPhase(PrincipalMoments({1, 2, 2.25}), {.75, .5, 1}));
  EXPECT_THROW(geometricPhase(moments, {NAN, 0, 1}), core::Error);
}

}  // namespace
}  // namespace poinsot::physics
