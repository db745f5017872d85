// SPDX-License-Identifier: Apache-2.0
// Compares the estimates with the integrated motion, whose dissipation is exact, and with formulas worked by hand.
#include "physics/energy_loss.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "physics/driven_motion.h"
#include "physics/motion_events.h"

namespace poinsot::physics {
namespace {

using Eigen::Vector3d;

DrivenMotion losing(const Vector3d& I, const Vector3d& omega, double alpha, double to_s) {
  Forcing forcing;
  forcing.dissipation = alpha;
  return {PrincipalAxes(PrincipalMoments(I)), omega, Quaternion(1, 0, 0, 0), forcing, {0, to_s}};
}

/// Returns the angle between L and a principal axis.
double angleTo(int axis, const Vector3d& I, const Vector3d& omega_B) {
  const Vector3d m = I.cwiseProduct(omega_B);
  return std::acos(std::abs(m[axis]) / m.norm());
}

// Worked by hand: d(tan theta)/dt = -alpha L² (1/I1 - 1/I3) tan theta.
TEST(EnergyLoss, DampsTheTangentOfASymmetricBodyExactly) {
  const Vector3d I(2, 2, 3), omega(1, 0, 1);
  const double L = std::sqrt(13.0), alpha = 0.01;
  const double time_s = dampingTime(PrincipalMoments(I), alpha, L);
  EXPECT_NEAR(time_s, 1 / (0.01 * 13 * (1.0 / 2 - 1.0 / 3)), 1e-12);
  const auto motion = losing(I, omega, alpha, time_s);
  EXPECT_NEAR(std::tan(angleTo(2, I, motion.at(time_s).omega_B)), 2.0 / 3 * std::exp(-1.0), 1e-10);
}

// A rod comes to a spin across its axis: the cotangent of the angle to its axis falls.
TEST(EnergyLoss, BringsARodToASpinAcrossItsAxis) {
  const Vector3d I(3, 3, 1), omega(1, 0, 2);
  const double L = std::sqrt(13.0), alpha = 0.01, time_s = dampingTime(PrincipalMoments(I), alpha, L);
  const auto motion = losing(I, omega, alpha, time_s);
  EXPECT_NEAR(1 / std::tan(angleTo(2, I, motion.at(time_s).omega_B)), 2.0 / 3 * std::exp(-1.0), 1e-10);
}

// Measured: 4e-4 of the time, from the phase at which the fall begins and ends.
TEST(EnergyLoss, DampsASmallWobbleOfAnAsymmetricBodyInTheMean) {
  const Vector3d I(1, 2, 2.5), omega(1e-3, 0, 1);
  const double alpha = 1e-3, time_s = dampingTime(PrincipalMoments(I), alpha, 2.5);
  const auto motion = losing(I, omega, alpha, time_s);
  const auto excess = [&](double t_s) {  // T above its least value, which falls by e² in this time
    const Vector3d w = motion.at(t_s).omega_B, m = I.cwiseProduct(w);
    return w.dot(m) - m.squaredNorm() / I[2];
  };
  EXPECT_NEAR(std::log(excess(0) / excess(time_s)), 2, 2e-3);
}

TEST(EnergyLoss, ReachesTheSeparatrixWhenTheIntegratedMotionDoes) {
  for (const Vector3d& omega : {Vector3d(2, 0.1, 0.1), Vector3d(2, 1e-3, 0), Vector3d(1.2, 0.3, 0.3)}) {
    const Vector3d I(1, 2, 2.5);
    const double alpha = 1e-2, time_s = timeToSeparatrix(PrincipalMoments(I), omega, alpha);
    const auto motion = losing(I, omega, alpha, 1.5 * time_s);
    const auto events = motionEvents(motion, motion.forcing(), {0, 1.5 * time_s});
    double crossed_s = 0;
    for (const MotionEvent& event : events)
      if (event.kind == MotionEventKind::kSeparatrix) crossed_s = event.t_s;
    EXPECT_NEAR(crossed_s / time_s, 1, 0.05) << omega.transpose() << ": " << crossed_s / time_s - 1;
  }
}

TEST(EnergyLoss, KnowsMotionsThatNeverCrossTheSeparatrix) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  EXPECT_EQ(timeToSeparatrix(PrincipalMoments({1, 2, 2.5}), {0.1, 0, 1}, 0.1), 0);     // beyond it
  EXPECT_EQ(timeToSeparatrix(PrincipalMoments({1, 2, 2.5}), {1, 0, 0}, 0.1), kNever);  // loses nothing
  EXPECT_EQ(timeToSeparatrix(PrincipalMoments({2, 2, 3}), {1, 0, 1}, 0.1), kNever);
  EXPECT_EQ(dampingTime(PrincipalMoments({2, 2, 2}), 0.1, 1), kNever);
}

}  // namespace
}  // namespace poinsot::physics
