// SPDX-License-Identifier: Apache-2.0
#include "physics/rolling_cone.h"

#include <gmock/gmock.h>

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "physics/mass_properties.h"
#include "physics/random_bodies.h"
#include "physics/residual.h"

namespace poinsot::physics {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using testing::HasSubstr;
using Real =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<40>, boost::multiprecision::et_off>;
using Real3 = std::array<Real, 3>;
using Real4 = std::array<Real, 4>;

constexpr double kPi = std::numbers::pi;
constexpr double kRadius = 0.75, kHeight = 1, kMass = 2;  // slant height 1.25, sin alpha = 0.6, cos alpha = 0.8

/// Solid cone with the apex at the origin and its axis along -z, about the apex.
PrincipalAxes apexAxes(double radius, double height, double mass) {
  const MassProperties cone =
      massProperties(SolidPart{Cone{radius, height}, mass, Quaternion::Identity(), {0, 0, -0.75 * height}});
  return PrincipalAxes(cone.inertiaAbout(Vector3d::Zero()));
}

RollingCone solidCone(double rate, double radius = kRadius, double height = kHeight, double mass = kMass) {
  return rollingCone(apexAxes(radius, height, mass), {0, 0, -1}, radius, height, rate);
}

RollingMotion solidMotion(double rate) { return {apexAxes(kRadius, kHeight, kMass), solidCone(rate)}; }

/// Body point (B) of the cone's side that touches the table at the distance s from the apex.
Vector3d touching_B(const RollingMotion& motion, double t, double s) {
  return Quaterniond(motion.at(t).q_WB).inverse() * (s * motion.cone().contact_W(t));
}

// Integrator of q' = (0, omega) q/2 that shares nothing with the closed form. It finds omega at each instant from
// the constraint alone: the apex is at rest, and so is the lowest point of the base. Its velocity omega × p is
// zero, so that omega = w p/|p|; w follows from the given turn of the cone's axis about the vertical.
class ConstraintOracle {
 public:
  ConstraintOracle(const Real4& start, const Real& radius, const Real& height, const Real& rate)
      : q_(start), radius_(radius), height_(height), rate_(rate) {}

  Real4 at(const Real& t, int steps) {
    const Real h = t / steps;
    for (int i = 0; i < steps; ++i) step(h);
    return q_;
  }

 private:
  static Real4 product(const Real4& p, const Real4& q) {
    return {p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
            p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
            p[0] * q[2] + p[2] * q[0] + p[3] * q[1] - p[1] * q[3],
            p[0] * q[3] + p[3] * q[0] + p[1] * q[2] - p[2] * q[1]};
  }

  /// Axis from the apex to the base in space, for the body's axis -z.
  static Real3 axis(const Real4& q) {
    const Real4 v = product(product(q, {Real(0), Real(0), Real(0), Real(-1)}), {q[0], -q[1], -q[2], -q[3]});
    return {v[1], v[2], v[3]};
  }

  Real3 omega(const Real4& q) const {
    const Real3 a = axis(q);
    // Lowest point of the base: from its centre, downwards in the plane of the base.
    const Real level = sqrt(Real(a[0] * a[0] + a[1] * a[1]));
    const Real3 down = {a[2] * a[0] / level, a[2] * a[1] / level, -level};
    Real3 p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = height_ * a[i] + radius_ * down[i];
    // The azimuth of a turns at the rate (a × a')_z/level² with a' = omega × a and omega = w p.
    const Real3 velocity = {p[1] * a[2] - p[2] * a[1], p[2] * a[0] - p[0] * a[2], p[0] * a[1] - p[1] * a[0]};
    const Real w = rate_ * level * level / (a[0] * velocity[1] - a[1] * velocity[0]);
    return {w * p[0], w * p[1], w * p[2]};
  }

  Real4 slope(const Real4& q) const {
    const Real3 w = omega(q);
    Real4 rate = product({Real(0), w[0], w[1], w[2]}, q);
    for (Real& r : rate) r /= 2;
    return rate;
  }

  // Gragg's modified midpoint rule, extrapolated to order 20.
  void step(const Real& h) {
    std::array<Real4, 10> table;
    for (int k = 0; k < 10; ++k) {
      const int n = 2 * (k + 1);
      table[static_cast<std::size_t>(k)] = midpoint(h, n);
      for (int j = k - 1; j >= 0; --j) {
        const Real ratio = Real(n) * n / (Real(2 * (j + 1)) * (2 * (j + 1))) - 1;
        for (std::size_t i = 0; i < 4; ++i) {
          const Real& finer = table[static_cast<std::size_t>(j + 1)][i];
          table[static_cast<std::size_t>(j)][i] = finer + (finer - table[static_cast<std::size_t>(j)][i]) / ratio;
        }
      }
    }
    q_ = table[0];
  }

  Real4 midpoint(const Real& step, int n) const {
    const Real h = step / n;
    Real4 before = q_, now = moved(q_, slope(q_), h);
    for (int i = 1; i < n; ++i) {
      const Real4 next = moved(before, slope(now), 2 * h);
      before = now;
      now = next;
    }
    const Real4 last = moved(before, slope(now), h);
    Real4 mean;
    for (std::size_t i = 0; i < 4; ++i) mean[i] = (now[i] + last[i]) / 2;
    return mean;
  }

  static Real4 moved(Real4 q, const Real4& slope, const Real& h) {
    for (std::size_t i = 0; i < 4; ++i) q[i] += h * slope[i];
    return q;
  }

  Real4 q_;
  Real radius_, height_, rate_;
};

TEST(RollingCone, AttitudeIsThatOfAnIntegratorOfTheConstraint) {
  for (const double rate : {1.5, -0.7}) {
    const RollingMotion motion = solidMotion(rate);
    // The start by hand: the axis a = (0, -cos alpha, sin alpha), turned from -z about x, with cos alpha = 0.8.
    const Real c = sqrt(Real("0.2")),
               s = -sqrt(Real("0.8"));  // half of a turn of -126.87 deg, whose cosine is -0.6
    const Quaterniond q0(motion.at(0).q_WB);
    const Vector3d a0 = q0 * Vector3d(0, 0, -1);
    EXPECT_LT((a0 - Vector3d(0, -0.8, 0.6)).norm(), 4e-16);
    const Quaterniond byHand(static_cast<double>(c), static_cast<double>(s), 0, 0);
    const double about = 2 * std::atan2((byHand.inverse() * q0).z(), (byHand.inverse() * q0).w());
    const Real half = Real(about) / 2;
    const Real4 start = {c * cos(half), s * cos(half), -s * sin(half), c * sin(half)};
    const double t = 9.25;
    const Real4 q = ConstraintOracle(start, Real(kRadius), Real(kHeight), Real(rate)).at(Real(t), 120);
    const Real4 finer = ConstraintOracle(start, Real(kRadius), Real(kHeight), Real(rate)).at(Real(t), 240);
    Real change = 0;
    for (std::size_t i = 0; i < 4; ++i) change += abs(Real(q[i] - finer[i]));
    EXPECT_LT(static_cast<double>(change), 1e-25);
    const Quaterniond expected(static_cast<double>(q[0]), static_cast<double>(q[1]), static_cast<double>(q[2]),
                               static_cast<double>(q[3]));
    const Quaterniond rest = expected.normalized().inverse() * Quaterniond(motion.at(t).q_WB);
    expectResidual("attitude, rad", 2 * std::atan2(rest.vec().norm(), std::abs(rest.w())),
                   4e-15);  // measured 2.3e-16
  }
}

TEST(RollingCone, PointsOfTheLineOfContactAreAtRestOnTheTable) {
  const RollingMotion motion = solidMotion(1.5);
  const double h = 1e-4;
  for (const double t : {0.0, 0.7, 3.1, 12.5})
    for (const double s : {0.3, 0.8, 1.25}) {
      const Vector3d p_B = touching_B(motion, t, s);
      const auto place = [&](double at) { return Vector3d(Quaterniond(motion.at(at).q_WB) * p_B); };
      // Differences of the attitude: the velocity is 0, and the point leaves the table upwards, with |a| ~ s.
      EXPECT_LT((place(t + h) - place(t - h)).norm() / (2 * h), 1e-7);
      EXPECT_GT(place(t + 0.1)[2], 1e-4);
      EXPECT_GT(place(t - 0.1)[2], 1e-4);
      EXPECT_NEAR(place(t)[2], 0, 1e-15);
      EXPECT_LT(motion.at(t).omega_W.cross(place(t)).norm(), 2e-15);
      // The point lies on the side of the cone: its distance along the axis is s cos alpha.
      EXPECT_NEAR(-p_B[2], 0.8 * s, 1e-15);
    }
}

TEST(RollingCone, NoPointOfTheConeIsBelowTheTable) {
  const RollingMotion motion = solidMotion(2);
  for (int i = 0; i < 200; ++i) {
    const double t = 0.05 * i, angle = 0.31 * i;
    const Vector3d rim_B(kRadius * std::cos(angle), kRadius * std::sin(angle), -kHeight);
    EXPECT_GE((Quaterniond(motion.at(t).q_WB) * rim_B)[2], -4e-16);
  }
}

// Worked by hand, with sin alpha = 0.6, cos alpha = 0.8 and Omega_v = 1.5: omega = 1.5 cot alpha = 2 towards the apex,
// and its two parts are 1.5 upwards and -1.5/0.6 = -2.5 along the axis.
TEST(RollingCone, AngularVelocityHasTwoParts) {
  const RollingMotion motion = solidMotion(1.5);
  EXPECT_NEAR(motion.cone().spin(), -2.5, 1e-15);
  EXPECT_NEAR(motion.cone().alongContact(), -2, 1e-15);
  EXPECT_NEAR(motion.cone().halfAngle_rad(), std::asin(0.6), 1e-15);
  for (const double t : {0.0, 1.0, 7.5}) {
    const RigidBodyState state = motion.at(t);
    const Vector3d a_W = Quaterniond(state.q_WB) * motion.cone().axis_B;
    EXPECT_LT((state.omega_W - (1.5 * Vector3d::UnitZ() - 2.5 * a_W)).norm(), 4e-15);
    EXPECT_NEAR(state.omega_W.norm(), 2, 4e-15);
    EXPECT_NEAR(state.omega_W[2], 0, 0);
    EXPECT_LT((Quaterniond(state.q_WB) * state.omega_B - state.omega_W).norm(), 4e-15);
  }
  EXPECT_LT((motion.at(0).omega_W - Vector3d(0, 2, 0)).norm(), 4e-15);  // the axis leans towards -y
}

// Landau & Lifshitz, Mechanics, section 32, problem 7: T = (3/40) M h² Omega_v² (1 + 5 cos² alpha).
TEST(RollingCone, EnergyIsTheTextbooksAndThatOfItsMassElements) {
  for (const double radius : {0.2, 0.75, 3.0}) {
    const double height = 1.25, mass = 1.7, rate = 0.9;
    const RollingCone cone = solidCone(rate, radius, height, mass);
    const double cosine = height / std::hypot(radius, height);
    const double textbook = 3.0 / 40 * mass * height * height * rate * rate * (1 + 5 * cosine * cosine);
    EXPECT_NEAR(cone.kineticEnergy() / textbook, 1, 4e-15);
    // Midpoints of elements along the axis, across and around; the sums of cosines are exact.
    const RollingMotion motion(apexAxes(radius, height, mass), cone);
    const RigidBodyState state = motion.at(0.4);
    constexpr int kAlong = 400, kAcross = 200, kAround = 8;
    const double density = mass / (kPi * radius * radius * height / 3);
    double T = 0;
    Vector3d L = Vector3d::Zero();
    for (int i = 0; i < kAlong; ++i)
      for (int j = 0; j < kAcross; ++j)
        for (int k = 0; k < kAround; ++k) {
          const double z = (i + 0.5) / kAlong * height, wide = radius * z / height;
          const double r = (j + 0.5) / kAcross * wide, angle = 2 * kPi * k / kAround;
          const double m = density * (height / kAlong) * (wide / kAcross) * (2 * kPi / kAround) * r;
          const Vector3d p = Quaterniond(state.q_WB) * Vector3d(r * std::cos(angle), r * std::sin(angle), -z);
          const Vector3d v = state.omega_W.cross(p);
          T += 0.5 * m * v.squaredNorm();
          L += m * p.cross(v);
        }
    EXPECT_NEAR(T / state.kineticEnergy, 1, 3e-5);
    EXPECT_LT((L - state.L_W).norm() / L.norm(), 3e-5);
  }
}

TEST(RollingCone, TorqueIsTheRateOfChangeOfL) {
  const RollingMotion motion = solidMotion(1.5);
  const double h = 1e-4;
  for (const double t : {0.0, 1.0, 7.5}) {
    const Vector3d change = (motion.at(t + h).L_W - motion.at(t - h).L_W) / (2 * h);
    EXPECT_LT((change - motion.torque_W(t)).norm(), 1e-7);
    EXPECT_NEAR(motion.torque_W(t).dot(motion.cone().contact_W(t)), 0, 1e-15);
    const RigidBodyState state = motion.at(t);
    EXPECT_LT(
        (Quaterniond(state.q_WB) * apexAxes(kRadius, kHeight, kMass).angularMomentum(state.omega_B) - state.L_W)
            .norm(),
        4e-15);
  }
}

// Worked by hand for the solid cone of 2 kg, radius 0.75 and height 1: I_a = (3/10) M r² = 0.3375, I_t = (3/5) M h² +
// (3/20) M r² = 1.36875, and cot alpha (I_t sin² alpha + I_a cos² alpha) = 4/3 (0.49275 + 0.216) = 0.945. With g =
// 10, the normal force of 20 N acts at 0.75·0.8 + 0.945·Omega²/20 from the apex.
TEST(RollingForces, BalanceTheTorque) {
  const RollingCone cone = solidCone(2);
  EXPECT_NEAR(cone.along, 0.3375, 1e-15);
  EXPECT_NEAR(cone.across, 1.36875, 1e-15);
  EXPECT_NEAR(cone.torque(), -4 * 0.945, 4e-15);
  const RollingForces forces = rollingForces(cone, kMass, 0.75, 10);
  EXPECT_EQ(forces.normal_N, 20);
  EXPECT_NEAR(forces.place_m, 0.6 + 0.945 * 4 / 20, 1e-15);
  EXPECT_NEAR(forces.inward_N, 2 * 4 * 0.6, 4e-15);
  EXPECT_TRUE(forces.holds(cone));
  EXPECT_NEAR(forces.fastest, std::sqrt(0.65 * 20 / 0.945), 1e-14);
  // The torques of weight and normal force about the apex, in space, add up to dL/dt.
  const RollingMotion motion(apexAxes(kRadius, kHeight, kMass), cone);
  const double t = 1.3;
  const Vector3d centre = Quaterniond(motion.at(t).q_WB) * Vector3d(0, 0, -0.75);
  const Vector3d torque = centre.cross(Vector3d(0, 0, -20)) +
                          (forces.place_m * cone.contact_W(t)).cross(Vector3d(0, 0, forces.normal_N));
  EXPECT_LT((torque - motion.torque_W(t)).norm(), 1e-14);
}

TEST(RollingForces, FindTheRateAtWhichTheConeTips) {
  const double fastest = rollingForces(solidCone(1), kMass, 0.75, 10).fastest;
  const RollingCone slower = solidCone(0.999 * fastest), faster = solidCone(-1.001 * fastest);
  EXPECT_TRUE(rollingForces(slower, kMass, 0.75, 10).holds(slower));
  EXPECT_FALSE(rollingForces(faster, kMass, 0.75, 10).holds(faster));
  EXPECT_NEAR(rollingForces(faster, kMass, 0.75, 10).fastest, fastest, 1e-14);
}

TEST(RollingCone, IsExactAfterManyTurns) {
  const RollingMotion motion = solidMotion(0.25);
  // After t = 2 pi n/Omega_v, rounded to a double, the axis is back by the rounding of t; the oracle has 40
  // digits.
  const double t = 3e9;
  const Real phase = Real(0.25) * t;
  const Vector3d expected(static_cast<double>(sin(phase)), static_cast<double>(-cos(phase)), 0);
  EXPECT_LT((motion.cone().contact_W(t) - expected).norm(), 4e-16);
  EXPECT_LT(
      (Quaterniond(motion.at(t).q_WB) * Vector3d(0, 0, -1) - (0.8 * expected + 0.6 * Vector3d::UnitZ())).norm(),
      1e-15);
  EXPECT_THROW(motion.at(NAN), core::Error);
  EXPECT_THROW(motion.at(1e300), core::Error);
}

template <class Work>
std::string refusal(Work work) {
  try {
    work();
  } catch (const core::Error& error) {
    return error.message();
  }
  return "";
}

TEST(RollingCone, RefusesConesThatCannotRoll) {
  const PrincipalAxes axes = apexAxes(kRadius, kHeight, kMass);
  const auto of = [&](const PrincipalAxes& body, const Vector3d& axis, double radius, double height, double rate) {
    return refusal([&] { rollingCone(body, axis, radius, height, rate); });
  };
  EXPECT_EQ(of(axes, {0, 0, -2}, 0.75, 1, 1), "");
  EXPECT_THAT(of(axes, {0, 0, -1}, 0.75, 1, 0), HasSubstr("rate of a rolling cone must not be 0"));
  EXPECT_THAT(of(axes, {0, 0, -1}, 0.75, 1, NAN), HasSubstr("must be finite, got nan rad/s"));
  EXPECT_THAT(of(axes, {0, 0, -1}, 0, 1, 1), HasSubstr("must be positive and finite, got 0"));
  EXPECT_THAT(of(axes, {0, 0, -1}, 1, -1, 1), HasSubstr("must be positive and finite, got -1"));
  EXPECT_THAT(of(axes, {0, 0, -1}, 1e-320, 1e10, 1), HasSubstr("between 0 and 90 deg"));
  EXPECT_THAT(of(axes, {0, 0, 0}, 0.75, 1, 1), HasSubstr("must not be zero"));
  EXPECT_THAT(of(axes, {1, 0, 0}, 0.75, 1, 1), HasSubstr("does not roll uniformly"));
  EXPECT_THAT(of(axes, {0, 1e-6, -1}, 0.75, 1, 1), HasSubstr("does not roll uniformly"));
  EXPECT_THAT(of(PrincipalMoments({1, 1.01, 0.5}), {0, 0, -1}, 0.75, 1, 1), HasSubstr("differ by 0.00"));
  EXPECT_THAT(refusal([&] { rollingForces(solidCone(1), 0, 1, 10); }), HasSubstr("mass of a rolling cone"));
}

}  // namespace
}  // namespace poinsot::physics
