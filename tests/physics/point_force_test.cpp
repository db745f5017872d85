// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/error.h"
#include "physics/driven_testing.h"
#include "physics/flight_path.h"
#include "physics/free_motion.h"
#include "physics/torque.h"

// Forces at points of the body (eq 1, 8, 9), compared with a Taylor integrator of 30 digits and with values worked
// by hand.

namespace poinsot::physics {
namespace {

using Eigen::Vector3d;
using Real30 =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<30>, boost::multiprecision::et_off>;
using Oracle = DrivenOracle<Real30>;

constexpr double kMass = 2.5;

PointForce inSpace(const Vector3d& lever_B, const Vector3d& force_W, double from_s = -HUGE_VAL,
                   double to_s = HUGE_VAL) {
  return {lever_B, Vector3d::Zero(), force_W, from_s, to_s};
}

PointForce inBody(const Vector3d& lever_B, const Vector3d& force_B, double from_s = -HUGE_VAL,
                  double to_s = HUGE_VAL) {
  return {lever_B, force_B, Vector3d::Zero(), from_s, to_s};
}

/// Returns forces whose windows overlap, on both sides of t = 0.
std::vector<PointForce> overlapping() {
  return {inSpace({0.3, -0.2, 0.5}, {0.4, -0.1, 0.25}, -3.5, 2.25),
          inBody({-0.1, 0.4, 0.2}, {0.2, 0.3, -0.5}, 1, 4), inSpace({0.2, 0.1, -0.6}, {-0.3, 0.5, 0.1}, 2, 9),
          inBody({0.5, 0.1, -0.3}, {-0.1, 0.2, 0.4}), inBody({0, 0, 0.25}, {0.6, 0, 0.1}, -6, -1.75)};
}

DrivenCase withForces(std::vector<PointForce> forces) {
  DrivenCase c;
  c.q0 = Eigen::Quaterniond(0.5, -0.25, 0.75, 0.5).normalized();
  c.forcing.forces = std::move(forces);
  return c;
}

/// Returns the forcing with the forces that act between two neighbouring edges of windows, without their windows.
Forcing acting(const Forcing& all, double inside) {
  Forcing now = all;
  now.forces.clear();
  for (const PointForce& f : all.forces)
    if (f.from_s < inside && inside < f.to_s) now.forces.push_back({f.lever_B, f.force_B, f.force_W});
  return now;
}

/// Returns the oracle's state at t, advanced from 0 from edge to edge.
Oracle::State led(const DrivenCase& c, double t) {
  std::set<double> edges{t};
  for (const PointForce& f : c.forcing.forces)
    for (const double edge : {f.from_s, f.to_s})
      if (std::min(0.0, t) < edge && edge < std::max(0.0, t)) edges.insert(edge);
  std::vector<double> stops(edges.begin(), edges.end());
  if (t < 0) std::reverse(stops.begin(), stops.end());
  auto state = Oracle(c.I, Forcing()).start(c.omega0, c.q0);
  double now = 0;
  for (const double stop : stops) {
    state = Oracle(c.I, acting(c.forcing, 0.5 * (now + stop))).advanced(state, Real30(stop));
    now = stop;
  }
  return state;
}

Vector3d toVector(const Oracle::Vector& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

void expectLikeOracle(const char* name, const DrivenCase& c, const std::vector<double>& times) {
  const DrivenMotion motion = c.motion();
  double attitude = 0, L = 0;
  for (const double t : times) {
    const auto state = led(c, t);
    const RigidBodyState tested = motion.at(t);
    attitude = std::max(attitude, TaylorOracle<Real30>::angle(state.q, tested.q_WB));
    L = std::max(L, TaylorOracle<Real30>::distance(Oracle::momentum_W(state), tested.L_W));
  }
  expectResidual(name, attitude, 1e-12);  // measured 1.3e-14 to 1.1e-13
  expectResidual("  L", L, 1e-12);        // measured 1.4e-14 to 1.5e-13
  EXPECT_LE(attitude, 3 * motion.report().estimatedAttitudeError_rad) << name;
  EXPECT_FALSE(motion.report().energyDrift) << name;
}

// The body turns by 70 to 170 rad, more than ten periods.
TEST(PointForce, TurnsAFreeBodyLikeTheOracle) {
  DrivenCase space = withForces({inSpace({0.3, -0.2, 0.5}, {0.4, -0.1, 0.25})});
  space.span = {0, 32};
  expectLikeOracle("space force", space, {3.1, 10.0, 21.7, 32.0});
  DrivenCase body = withForces({inBody({0.3, -0.2, 0.5}, {0.04, -0.1, 0.25})});
  body.span = {0, 32};
  expectLikeOracle("body force", body, {3.1, 10.0, 21.7, 32.0});
}

// Times on and between the edges of windows.
TEST(PointForce, ActsInItsWindow) {
  DrivenCase c = withForces(overlapping());
  c.span = {-7, 12};
  expectLikeOracle("windows", c, {-7.0, -6.0, -4.2, -1.75, -0.3, 0.5, 1.0, 1.6, 2.25, 3.0, 4.0, 8.8, 9.0, 12.0});
}

TEST(PointForce, AddsToGravityTorqueAndLosses) {
  DrivenCase c = withForces(overlapping());
  c.forcing.gravity_B = {0.2, -0.1, 0.5};
  c.forcing.torque_B = {0.03, 0.01, -0.02};
  c.forcing.torque_W = {0.01, 0.02, -0.03};
  c.span = {-7, 12};
  expectLikeOracle("with gravity and torques", c, {-7.0, -2.5, 1.6, 4.0, 12.0});
  c.forcing.dragRate_P = {0.1, 0.05, 0.2};
  c.forcing.dissipation = 0.05;
  c.span = {-2, 12};
  expectLikeOracle("with losses too", c, {-2.0, 1.6, 4.0, 12.0});
}

// Between two thrusts a body turns freely, with the states at the edges as starts.
TEST(PointForce, LeavesAFreeMotionOutsideItsWindow) {
  DrivenCase c = withForces({inBody({1, 0, 0}, {0, 0.5, 0}, 2, 3)});
  c.span = {0, 30};
  const DrivenMotion motion = c.motion();
  const FreeMotion before(PrincipalMoments(c.I), c.omega0, c.q0);
  const RigidBodyState end = motion.at(3);
  const FreeMotion after(PrincipalMoments(c.I), end.omega_B, end.q_WB);
  const auto angle = [](const RigidBodyState& a, const RigidBodyState& b) {
    return 2 * (a.q_WB.conjugate() * b.q_WB).vec().norm();
  };
  expectResidual("before", angle(motion.at(1.7), before.at(1.7)), 1e-14);  // measured 2.5e-16
  double worst = 0;
  for (double t = 3; t <= 30; t += 0.6875) worst = std::max(worst, angle(motion.at(t), after.at(t - 3)));
  expectResidual("after", worst, 5e-13);  // measured 6.6e-15
}

// lever × force is (0.5, 0.25, -0.5) × (1, -2, 0.5) = (-0.875, -0.75, -1.25), exact in doubles.
TEST(PointForce, InTheBodyIsAConstantBodyTorqueToTheLastBit) {
  DrivenCase force = withForces({inBody({0.5, 0.25, -0.5}, {1, -2, 0.5})}), torque = withForces({});
  torque.forcing.torque_B = {-0.875, -0.75, -1.25};
  const DrivenMotion a = force.motion(), b = torque.motion();
  for (double t = 0; t <= 20; t += 1.1875) {
    EXPECT_EQ(a.at(t).q_WB.coeffs(), b.at(t).q_WB.coeffs());
    EXPECT_EQ(a.at(t).L_W, b.at(t).L_W);
  }
}

// A weight of 1 N at the point r is gravity with M g r = r.
TEST(PointForce, DownwardsInSpaceIsGravity) {
  DrivenCase force = withForces({inSpace({0.3, -0.2, 0.9}, {0, 0, -1})}), gravity = withForces({});
  gravity.forcing.gravity_B = {0.3, -0.2, 0.9};
  const DrivenMotion a = force.motion(), b = gravity.motion();
  double worst = 0;
  for (double t = 0; t <= 20; t += 1.1875)
    worst = std::max(worst, 2 * (a.at(t).q_WB.conjugate() * b.at(t).q_WB).vec().norm());
  expectResidual("gravity as a force", worst, 2e-12);  // measured: equal
}

/// Returns the rate of change of f at t, by a difference of sixth order.
template <typename F>
Vector3d rateOf(const F& f, double t) {
  constexpr double h = 0.003;
  const auto slope = [&](double k) { return Vector3d((f(t + k * h) - f(t - k * h)) / (2 * k * h)); };
  return 1.5 * slope(1) - 0.6 * slope(2) + 0.1 * slope(3);
}

struct Thrown {
  explicit Thrown(const DrivenCase& c_, const Flight& flight_ = {{1, 2, -1}, {0.5, -1, 3}, {0, 0, -9.81}})
      : c(c_), flight(flight_), motion(c.motion()), path(flight, kMass, motion) {}

  FlightQuantities at(double t) const {
    return flightQuantities(kMass, path, c.forcing, motion.axes(), motion.at(t));
  }

  DrivenCase c;
  Flight flight;
  DrivenMotion motion;
  FlightPath path;
};

// Eq (1), (8) and (9), at times inside of the windows.
TEST(PointForce, SumsAreTheRatesOfChangeOfPAndL) {
  DrivenCase c = withForces(overlapping());
  c.forcing.torque_W = {0.1, 0.2, -0.3};
  c.forcing.dragRate_P = {0.1, 0.05, 0.2};
  c.span = {-7, 12};
  const Thrown thrown(c);
  double P = 0, total = 0, L = 0, R = 0;
  for (const double t : {-5.5, -2.0, 0.3, 1.5, 2.1, 3.1, 6.0, 11.0}) {
    const FlightQuantities q = thrown.at(t);
    const auto quantity = [&](auto member) { return rateOf([&](double s) { return thrown.at(s).*member; }, t); };
    P = std::max(P, (quantity(&FlightQuantities::P_W) - q.force_W).norm());
    total = std::max(total, (quantity(&FlightQuantities::total_W) - q.torque_W).norm() / q.torque_W.norm());
    L = std::max(L, (quantity(&FlightQuantities::intrinsic_W) -
                     torque_W(c.forcing, thrown.motion.axes(), thrown.motion.at(t)))
                        .norm());
    R = std::max(R, (kMass * rateOf([&](double s) { return thrown.path.positionAt(s); }, t) - q.P_W).norm());
  }
  expectResidual("dP/dt - F", P, 1e-9);                    // measured 3.7e-12
  expectResidual("dL_tot/dt - N, relative", total, 1e-9);  // measured 2.1e-13
  expectResidual("dL/dt - N", L, 1e-9);                    // measured 3.2e-13
  expectResidual("M dR/dt - P", R, 1e-9);                  // measured 1.2e-11
}

TEST(PointForce, MovesTheCentreOfMassLikeTheOracle) {
  DrivenCase c = withForces(overlapping());
  c.span = {-7, 40};
  const Thrown thrown(c, {Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()});
  double velocity = 0, position = 0;
  for (const double t : {-7.0, -4.2, -1.75, -0.3, 0.5, 1.6, 3.0, 4.0, 9.0, 12.0, 23.3, 40.0}) {
    const auto state = led(c, t);
    const Vector3d v = toVector(state.impulse) / kMass, r = toVector(state.shift) / kMass;
    velocity = std::max(velocity, (thrown.path.velocityAt(t) - v).norm() / v.norm());
    position = std::max(position, (thrown.path.positionAt(t) - r).norm() / r.norm());
  }
  expectResidual("V, relative", velocity, 1e-12);  // measured 1.04e-14
  expectResidual("R, relative", position, 1e-12);  // measured 7e-15
}

// A symmetric body that spins about its axis at 3 rad/s, under a force across the axis at its centre of mass:
// dV/dt = F/M (cos 3t, sin 3t, 0).
TEST(PointForce, ThroughTheCentreTurnsWithASpinningBody) {
  DrivenCase c;
  c.I = {1, 1, 2};
  c.omega0 = {0, 0, 3};
  c.forcing.forces = {inBody({0, 0, 0}, {5, 0, 0})};
  c.span = {0, 200};
  const Thrown thrown(c, {Vector3d::Zero(), {0.25, -0.5, 0}, Vector3d::Zero()});
  double velocity = 0, position = 0;
  for (double t = 0; t <= 200; t += 7.3125) {
    const double a = 5 / kMass, s = std::sin(3 * t), k = std::cos(3 * t);
    const Vector3d v(0.25 + a * s / 3, -0.5 + a * (1 - k) / 3, 0);
    const Vector3d r(0.25 * t + a * (1 - k) / 9, -0.5 * t + a * (t / 3 - s / 9), 0);
    velocity = std::max(velocity, (thrown.path.velocityAt(t) - v).norm());
    position = std::max(position, (thrown.path.positionAt(t) - r).norm());
  }
  expectResidual("V, m/s", velocity, 1e-12);  // measured 2.1e-14
  expectResidual("R, m", position, 1e-11);    // measured 2.3e-12, of 60 m
}

// R = R0 + V0 t + (g + F/M) t²/2 while the force acts, then a straight line plus free fall.
TEST(PointForce, InSpaceGivesAParabola) {
  DrivenCase c = withForces({inSpace({0.3, -0.2, 0.5}, {5, -2.5, 10}, 1, 3)});
  c.span = {-2, 10};
  const Thrown thrown(c);
  const Vector3d a = Vector3d(5, -2.5, 10) / kMass;
  for (const double t : {-2.0, 0.5, 1.0, 1.75, 3.0, 7.5, 10.0}) {
    const double in = std::clamp(t - 1, 0.0, 2.0), since = std::max(t - 3, 0.0);
    const Vector3d v = thrown.flight.velocityAt(t) + a * in;
    const Vector3d r = thrown.flight.positionAt(t) + a * (0.5 * in * in + in * since);
    EXPECT_LE((thrown.path.velocityAt(t) - v).norm(), 1e-14 * (1 + v.norm())) << t;
    EXPECT_LE((thrown.path.positionAt(t) - r).norm(), 1e-14 * (1 + r.norm())) << t;
  }
}

// A couple: F at r and -F at -r. P stays, and L_tot changes by twice r × F, about any point (eq 9).
TEST(PointForce, CoupleLeavesTheMomentum) {
  DrivenCase c =
      withForces({inBody({0.5, 0.25, 0}, {0, 0.75, 1}, 0.5, 2), inBody({-0.5, -0.25, 0}, {0, -0.75, -1}, 0.5, 2)});
  const Thrown thrown(c, {{3, -1, 2}, {0.5, 0, -0.25}, Vector3d::Zero()});
  for (const double t : {0.25, 1.0, 2.0, 20.0}) {
    EXPECT_EQ(thrown.path.velocityAt(t), Vector3d(0.5, 0, -0.25)) << t;
    EXPECT_LE((thrown.path.positionAt(t) - Vector3d(3 + 0.5 * t, -1, 2 - 0.25 * t)).norm(), 1e-15) << t;
  }
  const RigidBodyState state = thrown.motion.at(1);
  const Vector3d couple = state.q_WB * (2 * Vector3d(0.5, 0.25, 0).cross(Vector3d(0, 0.75, 1)));
  EXPECT_LE((thrown.at(1).torque_W - couple).norm(), 1e-15);
  EXPECT_LE((torqueOfForces_W(c.forcing, state) - couple).norm(), 1e-15);
  EXPECT_EQ(totalForce_W(c.forcing, state), Vector3d::Zero());
  EXPECT_EQ(torqueOfForces_W(c.forcing, thrown.motion.at(2)), Vector3d::Zero());
}

// A thin rod of mass M and length l at rest gets a blow J across it, at a distance of 2 l/3 from one end: its
// centre of percussion. V = J/M, omega = J (l/6)/(M l²/12) = 2 J/(M l), so the end starts with V - omega l/2 = 0.
TEST(PointForce, BlowAtTheCentreOfPercussionLeavesTheEndAtRest) {
  constexpr double l = 1.2, J = 0.75, blow_s = 1e-6;
  DrivenCase rod;
  rod.I = {1e-4, kMass * l * l / 12, kMass * l * l / 12};
  rod.omega0.setZero();
  rod.forcing.forces = {inSpace({l / 6, 0, 0}, {0, J / blow_s, 0}, 0, blow_s)};
  rod.span = {0, 1};
  const Thrown thrown(rod, {Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()});
  const RigidBodyState after = thrown.motion.at(blow_s);
  const Vector3d end_W = thrown.path.velocityAt(blow_s) + after.omega_W.cross(after.q_WB * Vector3d(-l / 2, 0, 0));
  EXPECT_NEAR(thrown.path.velocityAt(blow_s)[1], J / kMass, 1e-15);
  EXPECT_NEAR(after.omega_W[2], 2 * J / (kMass * l), 1e-12);
  // The rod turns by 2.5e-7 rad during the blow. Measured 7.5e-8.
  expectResidual("velocity of the end, m/s", end_W.norm(), 1e-6);
  // Hung at this end, the rod needs no force of the pivot: the blow gives its centre of mass the acceleration F/M.
  DrivenCase hung = rod;
  hung.I = {1e-4, kMass * l * l / 3, kMass * l * l / 3};
  hung.forcing.forces = {inSpace({2 * l / 3, 0, 0}, {0, 3, 0})};
  const DrivenMotion motion = hung.motion();
  const Vector3d angular = torque_W(hung.forcing, motion.axes(), motion.at(0)) / hung.I[2];
  expectResidual("force of the pivot, N",
                 (kMass * angular.cross(Vector3d(l / 2, 0, 0)) - Vector3d(0, 3, 0)).norm(), 1e-14);
  EXPECT_NEAR(motion.at(1e-3).omega_W[2], 1e-3 * angular[2], 1e-12);
}

template <typename Action>
std::string refusal(const Action& action) {
  try {
    action();
  } catch (const core::Error& error) {
    return error.message();
  }
  return "not refused";
}

TEST(PointForce, IsValidated) {
  const auto refused = [](const PointForce& force) {
    Forcing f;
    f.forces = {PointForce(), force};
    return refusal([&] { validate(f); });
  };
  EXPECT_EQ(refused({}), "not refused");
  EXPECT_EQ(refused(inSpace({0, NAN, 0}, {1, 0, 0})), "the point of force 2 (m) must be finite, got (0, nan, 0)");
  EXPECT_EQ(refused(inSpace({0, 0, 0}, {HUGE_VAL, 0, 0})),
            "force 2 in space axes (N) must be finite, got (inf, 0, 0)");
  EXPECT_EQ(refused(inBody({0, 0, 0}, {0, 0, -HUGE_VAL})),
            "force 2 in body axes (N) must be finite, got (0, 0, -inf)");
  EXPECT_EQ(refused(inBody({0, 0, 0}, {1, 0, 0}, 2, 2)), "force 2 must end after it begins, got 2 s to 2 s");
  EXPECT_EQ(refused(inBody({0, 0, 0}, {1, 0, 0}, NAN, 2)), "force 2 must end after it begins, got nan s to 2 s");
}

TEST(FlightPath, NeedsAMassAndATimeOfItsSpan) {
  const DrivenCase c = withForces({inBody({0.5, 0, 0}, {0, 1, 0})});
  const Thrown thrown(c);
  EXPECT_EQ(refusal([&] { thrown.path.positionAt(20.5); }),
            "t = 20.5 s: this flight was computed only from 0 s to 20 s");
  EXPECT_EQ(refusal([&] { thrown.path.velocityAt(NAN); }), "t = nan s: must be a finite number of seconds");
  EXPECT_EQ(refusal([&] { FlightPath(thrown.flight, 0, thrown.motion); }),
            "a force moves the centre of mass of a body with a positive mass, got 0 kg");
}

// Without forces, the flight is the parabola of flight.h to the last bit, at any time and without a mass.
TEST(FlightPath, IsTheParabolaWithoutForces) {
  const DrivenCase c = withForces({});
  const Flight flight{{1, 2, -1}, {0.5, -1, 3}, {0.3, -0.4, -9.81}};
  const FlightPath path(flight, NAN, c.motion());
  for (const double t : {-100.0, 0.0, 0.3, 1e6}) {
    EXPECT_EQ(path.positionAt(t), flight.positionAt(t));
    EXPECT_EQ(path.velocityAt(t), flight.velocityAt(t));
  }
  EXPECT_FALSE(path.hasForces());
}

}  // namespace
}  // namespace poinsot::physics
