// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "physics/driven_testing.h"
#include "physics/free_motion.h"
#include "physics/torque.h"

// Constant and time-dependent torques are compared with closed forms and with the Taylor integrator.

namespace poinsot::physics {
namespace {

using Eigen::Vector3d;

double angleBetween(const RigidBodyState& a, const RigidBodyState& b) {
  return 2 * (a.q_WB.conjugate() * b.q_WB).vec().norm();
}

TEST(DrivenTorque, MotionWithoutTorqueIsFreeMotion) {
  DrivenCase c;
  c.q0 = Eigen::Quaterniond(0.5, -0.25, 0.75, 1.5);
  const DrivenMotion motion = c.motion();
  const FreeMotion free(PrincipalMoments(c.I), c.omega0, c.q0);
  for (const double t : {-1e6, 0.0, 3.7, 1e9}) {
    EXPECT_EQ(motion.at(t).q_WB.coeffs(), free.at(t).q_WB.coeffs());
    EXPECT_EQ(motion.at(t).L_W, free.at(t).L_W);
  }
  EXPECT_EQ(motion.report().order, 0);
  EXPECT_EQ(motion.report().steps, 0u);
}

// A torque of 1e-200 N·m is too small to matter but forces integration.
TEST(DrivenTorque, MotionUnderATinyTorqueIsNearlyFree) {
  DrivenCase c;
  c.q0 = Eigen::Quaterniond(0.5, -0.25, 0.75, 1.5).normalized();
  c.forcing.torque_B = {1e-200, 0, 0};
  c.span = {-50, 50};
  const DrivenMotion motion = c.motion();
  const FreeMotion free(PrincipalMoments(c.I), c.omega0, c.q0);
  double worst = 0;
  for (double t = -50; t <= 50; t += 0.78125) worst = std::max(worst, angleBetween(motion.at(t), free.at(t)));
  expectResidual("free motion by steps", worst, 2e-13);  // measured 1.5e-14
}

// L = L0 + N t for any attitude.
TEST(DrivenTorque, SpaceTorqueChangesLByItsTimeIntegral) {
  DrivenCase c;
  c.forcing.torque_W = {0.1, 0.2, -0.3};
  c.span = {-10, 20};
  const DrivenMotion motion = c.motion();
  const Vector3d L0 = motion.at(0).L_W;
  double worst = 0;
  for (double t = -10; t <= 20; t += 0.3125)
    worst = std::max(worst, (motion.at(t).L_W - (L0 + c.forcing.torque_W * t)).norm() / L0.norm());
  expectResidual("L0 + N t", worst, 5e-16);  // measured 5.2e-17
}

// A body at rest spins up about a principal axis by phi = N t^2/(2 I).
TEST(DrivenTorque, SpinsUpFromRest) {
  for (const bool inBody : {true, false}) {
    DrivenCase c;
    c.omega0.setZero();
    (inBody ? c.forcing.torque_B : c.forcing.torque_W) = {0, 0, 0.5};
    c.span = {-4, 10};
    const DrivenMotion motion = c.motion();
    double worst = 0;
    for (double t = -4; t <= 10; t += 0.21875) {
      const double phi = 0.5 * t * t / (2 * c.I[2]);
      const Eigen::Quaterniond expected(std::cos(phi / 2), 0, 0, std::sin(phi / 2));
      worst = std::max(worst, 2 * (motion.at(t).q_WB.conjugate() * expected).vec().norm());
    }
    expectResidual(inBody ? "body torque" : "space torque", worst, 1e-12);  // measured 3.3e-16
  }
}

// A torque about the axis of a symmetric body gives omega_3 = w3 + N t/I3. The other two components turn by the
// integral of (I3/I1 - 1) omega_3.
TEST(DrivenTorque, SpinsUpASymmetricBodyByTheClosedForm) {
  DrivenCase c;
  c.I = {1, 1, 1.5};
  c.omega0 = {0.7, 0, 2};
  c.forcing.torque_B = {0, 0, 0.3};
  const DrivenMotion motion = c.motion();
  double worst = 0;
  for (double t = 0; t <= 20; t += 0.46875) {
    const double turned = 0.5 * (2 * t + 0.3 * t * t / (2 * 1.5));
    const Vector3d expected(0.7 * std::cos(turned), 0.7 * std::sin(turned), 2 + 0.3 * t / 1.5);
    worst = std::max(worst, (motion.at(t).omega_B - expected).norm());
  }
  expectResidual("omega", worst, 1e-12);  // measured 1.6e-15
}

TorqueHistory table(bool linear) {
  TorqueHistory history;
  history.t_s = {-2.5, 0.5, 1.25, 1.3125, 4};
  history.torque = {{0.2, 0, -0.1}, {0, 0.4, 0.1}, {-5, 3, 1}, {0.1, -0.2, 0.3}, {0.2, 0.1, 0}};
  history.linear = linear;
  return history;
}

/// Returns the oracle's state at t, advanced from 0 from knot to knot with the torque of each piece.
template <typename Oracle>
typename Oracle::State led(const DrivenCase& c, const TorqueHistory& history, bool inBody, double t) {
  auto state = Oracle(c.I, Forcing()).start(c.omega0, c.q0);
  double now = 0;
  while (now != t) {
    double next = t, inside = 0;
    for (const double knot : history.t_s) {
      if (t > 0 && knot > now && knot < next) next = knot;
      if (t < 0 && knot < now && knot > next) next = knot;
    }
    inside = 0.5 * (now + next);
    Forcing forcing;
    typename Oracle::Slopes slopes;
    Vector3d value = Vector3d::Zero(), slope = Vector3d::Zero();
    for (std::size_t i = 0; i < history.t_s.size(); ++i) {
      const bool last = i + 1 == history.t_s.size();
      if (inside < history.t_s[i] || (!last && inside > history.t_s[i + 1]) || (last && history.linear)) continue;
      if (history.linear)
        slope = (history.torque[i + 1] - history.torque[i]) / (history.t_s[i + 1] - history.t_s[i]);
      value = history.torque[i] - slope * history.t_s[i];
    }
    (inBody ? forcing.torque_B : forcing.torque_W) = value;
    (inBody ? slopes.torque_P : slopes.torque_W) = slope;
    state = Oracle(c.I, forcing, slopes).advanced(state, next);
    now = next;
  }
  return state;
}

void expectTable(const char* name, bool linear, bool inBody) {
  DrivenCase c;
  c.q0 = Eigen::Quaterniond(0.5, -0.25, 0.75, 0.5).normalized();
  (inBody ? c.forcing.torqueHistory_B : c.forcing.torqueHistory_W) = table(linear);
  c.span = {-5, 6};
  const DrivenMotion motion = c.motion();
  using Oracle = DrivenOracle<long double>;
  double worst = 0;
  // Times between knots, on knots, and beyond the first and the last knot.
  for (const double t : {-5.0, -2.5, -1.1, 0.5, 0.9, 1.25, 1.28, 1.3125, 2.2, 4.0, 6.0})
    worst = std::max(
        worst, TaylorOracle<long double>::angle(led<Oracle>(c, table(linear), inBody, t).q, motion.at(t).q_WB));
  expectResidual(name, worst, 1e-12);
  EXPECT_LE(worst, 3 * motion.report().estimatedAttitudeError_rad);
}

TEST(DrivenTorque, FollowsTablesOfStepsAndLines) {  // measured 4e-14 to 9e-14
  expectTable("steps, body", false, true);
  expectTable("steps, space", false, false);
  expectTable("lines, body", true, true);
  expectTable("lines, space", true, false);
}

// For a table of many short pieces, as read from a file, the angular momentum is the integral of the torque.
TEST(DrivenTorque, IntegratesALongTable) {
  DrivenCase c;
  TorqueHistory& history = c.forcing.torqueHistory_W;
  history.linear = true;
  for (int i = 0; i <= 2000; ++i) {
    history.t_s.push_back(i * 0.01);
    history.torque.push_back({0.1 * std::sin(0.05 * i), 0.1 * std::cos(0.03 * i), 0});
  }
  const DrivenMotion motion = c.motion();
  Vector3d L = motion.at(0).L_W;
  for (std::size_t i = 0; i < 2000; ++i)
    L += 0.5 * (history.torque[i] + history.torque[i + 1]) * (history.t_s[i + 1] - history.t_s[i]);
  expectResidual("L", (motion.at(20).L_W - L).norm(), 1e-13);  // measured 4.5e-15
  EXPECT_LE(motion.report().estimatedAttitudeError_rad, 1e-12);
}

// A body described in other axes moves as the same body described in its principal axes.
TEST(DrivenTorque, DoesNotDependOnTheBodyAxes) {
  const Eigen::Quaterniond q_BP = Eigen::Quaterniond(0.8, 0.2, -0.3, 0.4).normalized();
  DrivenCase c;
  c.forcing.torque_B = {0.1, 0.2, -0.3};
  c.forcing.gravity_B = {0.2, 0.5, -0.1};
  Forcing turned = c.forcing;
  turned.torque_B = q_BP * c.forcing.torque_B;
  turned.gravity_B = q_BP * c.forcing.gravity_B;
  const DrivenMotion inP = c.motion();
  const DrivenMotion inB(PrincipalAxes(PrincipalMoments(c.I), q_BP), q_BP * c.omega0, c.q0 * q_BP.conjugate(),
                         turned, c.span);
  double worst = 0;
  for (double t = 0; t <= 20; t += 1.25) {
    const RigidBodyState p = inP.at(t), b = inB.at(t);
    worst = std::max({worst, 2 * ((b.q_WB * q_BP).conjugate() * p.q_WB).vec().norm(), (b.L_W - p.L_W).norm(),
                      (b.omega_B - q_BP * p.omega_B).norm(), std::abs(b.kineticEnergy - p.kineticEnergy)});
    EXPECT_NEAR(inB.totalEnergy(b), inP.totalEnergy(p), 1e-12);
  }
  expectResidual("described in other axes", worst, 2e-12);  // measured 1e-14
}

// at(t) depends on t alone, to the last bit, and not on earlier calls.
TEST(DrivenTorque, StateDependsOnTimeAlone) {
  DrivenCase c = heavyTop(20);
  c.span = {-20, 20};
  const DrivenMotion motion = c.motion(), again = c.motion();
  for (double t = 19.9; t >= -20; t -= 0.7) {
    const RigidBodyState a = motion.at(t), b = again.at(t);
    EXPECT_EQ(a.q_WB.coeffs(), b.q_WB.coeffs());
    EXPECT_EQ(a.L_W, b.L_W);
    EXPECT_EQ(a.t_s, t);
    EXPECT_GE(a.q_WB.w(), 0);
    // The state is continuous where one step ends and the next begins.
    EXPECT_LE(angleBetween(a, motion.at(t + 1e-9)), 2e-8);
  }
}

// The torque of a state must be the rate of change of L_W, by a difference of sixth order.
TEST(DrivenTorque, IsTheRateOfChangeOfL) {
  DrivenCase c;
  c.forcing.gravity_B = {0.2, -0.1, 0.5};
  c.forcing.torque_B = {0.3, 0.1, -0.2};
  c.forcing.torque_W = {0.1, 0.2, -0.3};
  c.forcing.torqueHistory_W = {{-20, 20}, {Vector3d(0.4, -0.2, 0.1), Vector3d(-0.3, 0.1, 0.6)}, true};
  c.forcing.torqueHistory_B = {
      {-20, -1, 2}, {Vector3d(0, 0.1, 0), Vector3d(0.2, 0, 0), Vector3d(0, 0, 0.3)}, false};
  c.forcing.dragRate_P = {0.1, 0.05, 0.2};
  c.forcing.dissipation = 0.05;
  c.span = {-5, 5};
  const DrivenMotion motion = c.motion();
  const double h = 0.003;  // step of a difference of sixth order
  double worst = 0;
  for (const double t : {-4.5, -2.0, -0.3, 0.7, 1.9, 3.3}) {
    const auto slope = [&](double k) {
      return Vector3d((motion.at(t + k * h).L_W - motion.at(t - k * h).L_W) / (2 * k * h));
    };
    const Vector3d rate = 1.5 * slope(1) - 0.6 * slope(2) + 0.1 * slope(3);
    worst = std::max(worst, (torque_W(c.forcing, motion.axes(), motion.at(t)) - rate).norm());
  }
  expectResidual("dL/dt", worst, 3e-11);  // measured 3.2e-12
}

}  // namespace
}  // namespace poinsot::physics
