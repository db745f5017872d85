// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>

#include "physics/driven_testing.h"

// The heavy symmetric top and its closed form (Lagrange; Landau & Lifshitz, Mechanics, section 35, problem 1):
// with u = cos theta, u'^2 = f(u) = (alpha - beta u)(1 - u^2) - (b - a u)^2, a cubic with roots u1 < u2 < 1 < u3,
//   u(t) = u1 + (u2 - u1) sn^2(sqrt(beta (u3 - u1))/2 (t - t1)),  sn^2 of modulus^2 = (u2 - u1)/(u3 - u1).
// Boost provides the elliptic functions. Literals come from the closed form and from Taylor integration in
// extended precision.

namespace poinsot::physics {
namespace {

using Eigen::Vector3d;

constexpr double kMgl = 2.84375, kI1 = 1.40625, kI3 = 0.65625, kSpin = 9.15625;
constexpr double kNutationPeriod_s = 1.83064120697989845;
constexpr double kLowest_deg = 38.840183490757;
constexpr double kPrecessionPerNutation_rad = 0.958047879275758037;

Vector3d axis_W(const RigidBodyState& state) { return state.q_WB.toRotationMatrix().col(2); }

/// Closed form of the cosine of inclination of a top that is released with spin alone, its axis at 30 degrees.
class ReleasedTop {
 public:
  ReleasedTop() {
    // f(u) = (u0 - u) [beta (1 - u^2) - a^2 (u0 - u)], a = I3 w3/I1, beta = 2 Mgl/I1: the top only falls.
    const double a = kI3 * kSpin / kI1, p = a * a / (2 * beta_), root = std::sqrt(p * p - 2 * p * u0_ + 1);
    lowest_ = p - root;
    third_ = p + root;
    modulus_ = std::sqrt((u0_ - lowest_) / (third_ - lowest_));
    rate_ = 0.5 * std::sqrt(beta_ * (third_ - lowest_));
  }
  double period_s() const { return 2 * boost::math::ellint_1(modulus_) / rate_; }
  double lowest() const { return lowest_; }
  double cosine(double t) const {
    const double sn = boost::math::jacobi_sn(modulus_, rate_ * (t - 0.5 * period_s()));
    return lowest_ + (u0_ - lowest_) * sn * sn;
  }

 private:
  double u0_ = std::sqrt(0.75), beta_ = 2 * kMgl / kI1;
  double lowest_ = 0, third_ = 0, modulus_ = 0, rate_ = 0;
};

TEST(HeavyTop, NutatesByLagrangesClosedForm) {
  const ReleasedTop exact;
  const DrivenMotion motion = heavyTop(20).motion();
  double worst = 0;
  for (double t = 0; t <= 20; t += 0.0625)
    worst = std::max(worst, std::abs(axis_W(motion.at(t))[2] - exact.cosine(t)));
  expectResidual("cos of the inclination", worst, 1e-12);  // measured 9.1e-15
}

TEST(HeavyTop, ReachesTheLimitsOfNutationEachPeriod) {
  const ReleasedTop exact;
  EXPECT_NEAR(exact.period_s(), kNutationPeriod_s, 4e-15);
  EXPECT_NEAR(std::acos(exact.lowest()) * 180 / EIGEN_PI, kLowest_deg, 1e-12);
  const DrivenMotion motion = heavyTop(10 * kNutationPeriod_s).motion();
  for (int n = 0; n < 10; ++n) {
    const double low = axis_W(motion.at((n + 0.5) * kNutationPeriod_s))[2];
    const double high = axis_W(motion.at(n * kNutationPeriod_s))[2];
    EXPECT_NEAR(low, std::cos(kLowest_deg * EIGEN_PI / 180), 1e-13);  // measured 1e-14
    EXPECT_NEAR(high, std::sqrt(0.75), 1e-13);
  }
}

TEST(HeavyTop, PrecessesByAFixedAnglePerNutation) {
  const DrivenMotion motion = heavyTop(10 * kNutationPeriod_s).motion();
  const Vector3d start = axis_W(motion.at(0));
  double worst = 0;
  for (int n = 1; n <= 10; ++n) {
    const Eigen::AngleAxisd turn(n * kPrecessionPerNutation_rad, Vector3d::UnitZ());
    worst = std::max(worst, (turn * start - axis_W(motion.at(n * kNutationPeriod_s))).norm());
  }
  expectResidual("axis after ten nutations", worst, 1e-12);  // measured 4.7e-14
}

/// Returns the largest deviation of the axis from steady precession at 30 degrees with a given rate.
double steadyPrecessionResidual(double rate) {
  DrivenCase top = heavyTop(20);
  // omega = rate z_W, with omega_3 set to the spin. The axis lies in the plane x = 0.
  const Vector3d up_B = top.q0.conjugate() * Vector3d::UnitZ();
  top.omega0 = rate * up_B;
  top.omega0[2] = kSpin;
  const DrivenMotion motion = top.motion();
  const Vector3d start = axis_W(motion.at(0));
  double worst = 0;
  for (double t = 0; t <= 20; t += 0.25) {
    const Eigen::AngleAxisd turn(rate * t, Vector3d::UnitZ());
    worst = std::max(worst, (turn * start - axis_W(motion.at(t))).norm());
  }
  return worst;
}

// Rates: roots of I1 cos(theta) p^2 - I3 w3 p + M g l = 0.
TEST(HeavyTop, PrecessesSteadilyAtBothRates) {
  expectResidual("slow", steadyPrecessionResidual(0.530251265914263), 1e-12);  // measured 4.0e-14
  expectResidual("fast", steadyPrecessionResidual(4.40368790953541), 1e-12);   // measured 8.9e-14
}

/// Returns how far an upright top leans after a small disturbance.
double largestLean(double spin) {
  DrivenCase top = heavyTop(30);
  top.q0 = Eigen::Quaterniond(Eigen::AngleAxisd(1e-6, Vector3d::UnitX()));
  top.omega0 = {0, 0, spin};
  const DrivenMotion motion = top.motion(1e-9);
  double lean = 0;
  for (double t = 0; t <= 30; t += 0.125) lean = std::max(lean, axis_W(motion.at(t)).head<2>().norm());
  return lean;
}

// A top that spins faster than 2 sqrt(I1 M g l)/I3 sleeps upright; a slower top falls.
TEST(HeavyTop, SleepsUprightAboveTheLimitingSpin) {
  constexpr double kLimit = 6.09449400220044;
  EXPECT_LT(largestLean(kLimit * 1.01), 2e-5);
  EXPECT_GT(largestLean(kLimit * 0.95), 0.1);
}

// An upright top without disturbance is in equilibrium and keeps spinning exactly.
TEST(HeavyTop, UprightTopStaysUpright) {
  DrivenCase top = heavyTop(10);
  top.q0 = Eigen::Quaterniond::Identity();
  const DrivenMotion motion = top.motion();
  EXPECT_EQ(motion.at(7.3).L_W, motion.at(0).L_W);
  EXPECT_LE(axis_W(motion.at(7.3)).head<2>().norm(), 0);
}

// A symmetric top keeps L along its axis. The kicks of the integrator leave the vertical component alone.
TEST(HeavyTop, ConservesItsThreeConstantsOfMotion) {
  const DrivenMotion motion = heavyTop(50).motion();
  const RigidBodyState start = motion.at(0);
  double figure = 0, energy = 0;
  for (double t = 0; t <= 50; t += 0.1875) {
    const RigidBodyState state = motion.at(t);
    EXPECT_EQ(state.L_W[2], start.L_W[2]);
    figure = std::max(figure, std::abs(state.omega_B[2] - kSpin) / kSpin);
    energy = std::max(energy, std::abs(motion.totalEnergy(state) / motion.totalEnergy(start) - 1));
  }
  expectResidual("L along the axis", figure, 1e-14);  // measured 1.9e-16
  expectResidual("energy", energy, 1e-14);            // measured 4.4e-16
  EXPECT_LE(motion.report().energyDrift.value(), 1e-14);
}

}  // namespace
}  // namespace poinsot::physics
