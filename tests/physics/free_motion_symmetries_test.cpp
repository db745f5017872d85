// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "physics/free_motion.h"
#include "physics/random_bodies.h"
#include "physics/residual.h"
#include "physics/theta_oracle.h"

// A change of units or of axes must not change the motion. The doubles of each pair of motions are exact images of
// each other, so that 4e-15 rad must hold between them at any time. free_motion_invariants_test.cpp tests orders
// of the axes, time reversal, powers of two and the group property.

namespace poinsot::physics {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kBound = 4e-15;

/// Rounds components to 26 bits, so that their product with a whole number below 2^27 is exact.
Vector3d shortened(const Vector3d& v) {
  return v.unaryExpr([](double x) { return std::ldexp(std::round(std::ldexp(x, 26)), -26); });
}

struct Case {
  PrincipalMoments moments;
  Vector3d omega0_B;
  Quaterniond q0_WB;
};

Case shortCase(Draw& draw) {
  return {PrincipalMoments(shortened(draw.moments().values())), shortened(draw.direction()), draw.attitude()};
}

double angleBetween(const Quaterniond& a, const Quaterniond& b) {
  return ThetaOracle::angle(ThetaOracle::rotationMatrix(a), b);
}

TEST(FreeMotionSymmetries, ScalingTheMomentsScalesOnlyTheEnergy) {
  Draw draw(131);
  double attitude = 0, omega = 0, energy = 0;
  for (int i = 0; i < 100; ++i) {
    const Case c = shortCase(draw);
    const FreeMotion motion(c.moments, c.omega0_B, c.q0_WB);
    for (const double factor : {3.0, 7e3, 1e6 + 1}) {
      const FreeMotion heavy(PrincipalMoments(c.moments.values() * factor), c.omega0_B, c.q0_WB);
      const double t_s = draw.sign() * draw.decade(-1, 9);
      const RigidBodyState expected = motion.at(t_s), state = heavy.at(t_s);
      attitude = std::max(attitude, angleBetween(expected.q_WB, state.q_WB));
      omega = std::max(omega, (expected.omega_B - state.omega_B).norm() / c.omega0_B.norm());
      energy = std::max(energy, std::abs(heavy.kineticEnergy() / (factor * motion.kineticEnergy()) - 1));
    }
  }
  expectResidual("moments scaled, rad", attitude, kBound);            // measured 6.1e-16
  expectResidual("  omega_B, relative to the start", omega, kBound);  // measured 3.4e-16
  expectResidual("  T, relative", energy, kBound);                    // measured 2.2e-16
}

TEST(FreeMotionSymmetries, ScalingTimeScalesOnlyOmega) {
  Draw draw(132);
  double attitude = 0, omega = 0;
  for (int i = 0; i < 100; ++i) {
    const Case c = shortCase(draw);
    const FreeMotion motion(c.moments, c.omega0_B, c.q0_WB);
    for (const double factor : {3.0, 7e3, 1e6 + 1}) {
      const FreeMotion fast(c.moments, c.omega0_B * factor, c.q0_WB);
      const double t_s = std::round(draw.between(-0x1p26, 0x1p26)) / 64;
      const RigidBodyState expected = motion.at(factor * t_s), state = fast.at(t_s);
      attitude = std::max(attitude, angleBetween(expected.q_WB, state.q_WB));
      omega = std::max(omega, (factor * expected.omega_B - state.omega_B).norm() / (factor * c.omega0_B.norm()));
    }
  }
  expectResidual("time scaled, rad", attitude, kBound);               // measured 8.1e-16
  expectResidual("  omega_B, relative to the start", omega, kBound);  // measured 3.1e-16
}

TEST(FreeMotionSymmetries, TurningSpaceTurnsTheMotion) {
  Draw draw(133);
  double attitude = 0, omega = 0;
  for (int i = 0; i < 300; ++i) {
    const Case c = shortCase(draw);
    const Quaterniond turn = draw.attitude();
    const double t_s = draw.sign() * draw.decade(-1, 9);
    const RigidBodyState here = FreeMotion(c.moments, c.omega0_B, c.q0_WB).at(t_s);
    const RigidBodyState there = FreeMotion(c.moments, c.omega0_B, turn * c.q0_WB).at(t_s);
    attitude = std::max(attitude, angleBetween(turn * here.q_WB, there.q_WB));
    omega = std::max(omega, (turn * here.omega_W - there.omega_W).norm() / here.omega_W.norm());
    EXPECT_EQ(here.omega_B, there.omega_B);
  }
  expectResidual("space turned, rad", attitude, kBound);           // measured 6.6e-16
  expectResidual("  omega_W, relative to itself", omega, kBound);  // measured 1.1e-15
}

/// With body axes that are not principal, omega along the principal axes is rounded once more. The start is 2e-16
/// off, so that the comparison covers 10 rad only.
TEST(FreeMotionSymmetries, BodyAxesDoNotMatter) {
  Draw draw(134);
  double attitude = 0, omega = 0, momentum = 0;
  for (int i = 0; i < 300; ++i) {
    const Case c = shortCase(draw);
    const Quaterniond q_BP = draw.attitude();
    const PrincipalAxes axes(c.moments, q_BP);
    const double t_s = draw.between(-10, 10);
    const FreeMotion motion_P(c.moments, c.omega0_B, c.q0_WB);
    const FreeMotion motion_B(axes, q_BP * c.omega0_B, c.q0_WB * q_BP.conjugate());
    const RigidBodyState P = motion_P.at(t_s), B = motion_B.at(t_s);
    attitude = std::max(attitude, angleBetween(P.q_WB * q_BP.conjugate(), B.q_WB));
    omega = std::max(omega, (q_BP * P.omega_B - B.omega_B).norm() / c.omega0_B.norm());
    momentum = std::max(momentum, (B.q_WB * axes.angularMomentum(B.omega_B) - P.L_W).norm() / P.L_W.norm());
  }
  expectResidual("axes not principal, rad", attitude, 2e-14);        // measured 1.1e-14
  expectResidual("  omega_B, relative to the start", omega, 2e-14);  // measured 2.7e-15
  expectResidual("  L_W, relative", momentum, kBound);               // measured 2.5e-15
}

}  // namespace
}  // namespace poinsot::physics
