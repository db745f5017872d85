// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "physics/driven_testing.h"

// Drag and dissipation are compared with closed forms.

namespace poinsot::physics {
namespace {

using Eigen::Vector3d;

// Drag makes a spin about a principal axis decay as e^(-d t), with the angle omega0 (1 - e^(-d t))/d.
TEST(DrivenLoss, SpinAboutAPrincipalAxisDecays) {
  DrivenCase c;
  c.omega0 = {0, 0, 3};
  c.forcing.dragRate_P = {0.5, 0.1, 0.2};
  c.span = {-5, 20};
  const DrivenMotion motion = c.motion();
  double omega = 0, attitude = 0;
  for (double t = -5; t <= 20; t += 0.3125) {
    const RigidBodyState state = motion.at(t);
    const double left = std::exp(-0.2 * t), phi = -3 * std::expm1(-0.2 * t) / 0.2;
    omega = std::max(omega, (state.omega_B - Vector3d(0, 0, 3 * left)).norm() / left);
    const Eigen::Quaterniond expected(std::cos(phi / 2), 0, 0, std::sin(phi / 2));
    attitude = std::max(attitude, 2 * (state.q_WB.conjugate() * expected).vec().norm());
  }
  expectResidual("omega", omega, 1e-13);        // measured 2.0e-15
  expectResidual("attitude", attitude, 1e-12);  // measured 6.8e-15
}

// With equal drag rates the direction of L stays, T and |L| decay, and the motion is known at any time.
TEST(DrivenLoss, EqualDragFollowsTheClosedForm) {
  DrivenCase c;
  c.forcing.dragRate_P.setConstant(0.2);
  c.span = {0, 1};
  const DrivenMotion motion = c.motion();
  EXPECT_EQ(motion.report().order, 0);
  const DrivenResiduals r = residualsOf(DrivenCase{c.I, c.omega0, c.q0, c.forcing, {-10, 40}}, motion);
  expectResidual("attitude", r.attitude_rad, 4e-14);  // measured 7.2e-15
  expectResidual("L", r.L, 4e-14);                    // measured 3.2e-15
  const RigidBodyState late = motion.at(1e6);
  EXPECT_EQ(late.L_W.norm(), 0);
  EXPECT_EQ(late.kineticEnergy, 0);
}

// One rate larger by its last bit forces integration. Closed form and integrator must agree.
TEST(DrivenLoss, ClosedFormAgreesWithTheIntegrator) {
  DrivenCase c;
  c.forcing.dragRate_P.setConstant(0.2);
  const DrivenMotion closed = c.motion();
  c.forcing.dragRate_P[1] = std::nextafter(0.2, 1);
  const DrivenMotion stepped = c.motion();
  EXPECT_EQ(stepped.report().order, 8);
  double worst = 0;
  for (double t = 0; t <= 20; t += 0.625)
    worst = std::max(worst, 2 * (closed.at(t).q_WB.conjugate() * stepped.at(t).q_WB).vec().norm());
  expectResidual("closed form and steps", worst, 1e-12);  // measured 1.8e-15
}

// Closed form for a symmetric body, theta from the axis to L:
// tan theta(t) = tan theta0 exp(-alpha L^2 (1/Ip - 1/I3) t).
void expectSymmetricDecay(const char* name, const Vector3d& I) {
  DrivenCase c;
  c.I = I;
  c.omega0 = {0.6, 0, 1.5};
  c.forcing.dissipation = 0.02;
  c.span = {-5, 60};
  const DrivenMotion motion = c.motion();
  const Vector3d m0 = I.cwiseProduct(c.omega0);
  double angle = 0, L = 0;
  for (double t = -5; t <= 60; t += 0.40625) {
    const RigidBodyState state = motion.at(t);
    const Vector3d m = I.cwiseProduct(state.omega_B);
    const double tangent = m0[0] / m0[2] * std::exp(-0.02 * m0.squaredNorm() * (1 / I[0] - 1 / I[2]) * t);
    angle = std::max(angle, std::abs(std::atan2(m.head<2>().norm(), m[2]) - std::atan(tangent)));
    L = std::max(L, (state.L_W - motion.at(0).L_W).norm() / m0.norm());
  }
  expectResidual(name, angle, 1e-12);
  expectResidual("  L", L, 0);
}

TEST(DrivenLoss, SymmetricBodyTiltsByTheClosedForm) {  // measured 5e-16 and 9e-16
  expectSymmetricDecay("oblate", {1, 1, 1.6});
  expectSymmetricDecay("prolate", {1, 1, 0.5});
}

// Explorer 1: spin about the long axis becomes flat spin, at constant L. Scaled to a spin of 3 rad/s.
TEST(DrivenLoss, ExplorerEndsInFlatSpin) {
  DrivenCase c;
  c.I = {0.04034536, 4.8, 4.81758709666667};
  c.omega0 = {3, 0.001, 0.002};
  c.forcing.dissipation = 0.05;
  c.span = {0, 4000};
  const DrivenMotion motion = c.motion(1e-6);
  const RigidBodyState start = motion.at(0), end = motion.at(4000);
  const double L = start.L_W.norm();
  EXPECT_EQ(end.L_W, start.L_W);
  EXPECT_NEAR(std::abs(end.omega_B[2]), L / c.I[2], 1e-6 * L / c.I[2]);
  EXPECT_NEAR(end.kineticEnergy, L * L / (2 * c.I[2]), 1e-6 * end.kineticEnergy);
  double energy = start.kineticEnergy;
  for (double t = 0; t <= 4000; t += 5) {
    const double next = motion.at(t).kineticEnergy;
    EXPECT_LE(next, energy * (1 + 1e-14));
    energy = next;
  }
}

/// Returns the rate of turning at t, up to (h rate)^3: twice the vector part of q(t - h)^-1 q(t + h), over 2 h.
Vector3d differencedRate(const DrivenMotion& motion, double t, double h) {
  const Eigen::Quaterniond turn = motion.at(t - h).q_WB.conjugate() * motion.at(t + h).q_WB;
  return turn.vec() * (turn.w() < 0 ? -1 : 1) / h;
}

// Oracle: central differences of q, extrapolated from steps h and h/2 (error h^4).
TEST(DrivenLoss, AttitudeTurnsAtTheTurningRateAndNotAtOmega) {
  DrivenCase c;
  c.forcing.dissipation = 0.02;
  c.forcing.torque_B = {0.1, -0.05, 0.2};
  c.forcing.dragRate_P = {0.01, 0.03, 0.02};
  const DrivenMotion motion = c.motion();
  double ofRate = 0, ofOmega = 0;
  for (double t = 1; t <= 19; t += 0.75) {
    const RigidBodyState state = motion.at(t);
    const Vector3d coarse = differencedRate(motion, t, 2e-3), fine = differencedRate(motion, t, 1e-3);
    const Vector3d turning = fine + (fine - coarse) / 3;
    ofRate = std::max(ofRate, (turningRate_B(motion, state) - turning).norm());
    ofOmega = std::max(ofOmega, (state.omega_B - turning).norm());
  }
  expectResidual("turning rate", ofRate, 1e-9);  // measured 8.9e-12
  EXPECT_GT(ofOmega, 1e-2);                      // measured 0.031
}

TEST(DrivenLoss, TurningRateIsOmegaWithoutDissipation) {
  DrivenCase c;
  c.forcing.dragRate_P = {0.01, 0.03, 0.02};
  const DrivenMotion motion = c.motion();
  EXPECT_EQ(turningRate_B(motion, motion.at(3)), motion.at(3).omega_B);
  EXPECT_EQ(turningRate_W(motion, motion.at(3)), motion.at(3).omega_W);
}

// Torques alone change L: dL/dt = N. Dissipation adds nothing.
TEST(DrivenLoss, OnlyTorquesChangeTheMomentum) {
  DrivenCase c;
  c.forcing.dissipation = 0.05;
  c.forcing.torque_W = {0.1, 0, -0.2};
  const DrivenMotion motion = c.motion();
  const Vector3d L0 = motion.at(0).L_W;
  for (double t = 0; t <= 20; t += 1.25) EXPECT_LE((motion.at(t).L_W - L0 - c.forcing.torque_W * t).norm(), 2e-15);
}

}  // namespace
}  // namespace poinsot::physics
