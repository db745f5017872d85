// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "physics/free_motion.h"
#include "physics/herpolhode.h"
#include "physics/high_order_difference.h"
#include "physics/precession_cones.h"
#include "physics/random_bodies.h"
#include "physics/residual.h"

// The two descriptions of the symmetric top brought together: the lecture's eq (30) to (37).

namespace poinsot::physics {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

struct Top {
  PrincipalMoments moments;
  Vector3d omega0_B;
  FreeMotion motion;
  PrecessionCones cones;
  double t;

  RigidBodyState state() const { return motion.at(t); }
  Vector3d k_W(double at) const { return motion.at(at).q_WB * cones.k_P; }
  Vector3d omega_W(double at) const { return motion.at(at).omega_W; }
};

/// Returns a random top about any of the three axes, spinning either way.
Top randomTop(Draw& draw) {
  const double Ip = draw.between(0.6, 2);
  Vector3d I = Vector3d::Constant(Ip);
  I[static_cast<int>(draw.between(0, 3))] = Ip * draw.between(0.1, 1.99);
  const PrincipalMoments moments(I);
  const Vector3d omega0 = draw.direction();
  return {moments, omega0, FreeMotion(moments, omega0, draw.attitude()), *precessionCones(moments, omega0),
          draw.between(-50, 50)};
}

template <typename Residual>
double worstOf(std::uint64_t seed, Residual residual) {
  Draw draw(seed);
  double worst = 0;
  for (int i = 0; i < 200; ++i) worst = std::max(worst, residual(randomTop(draw)));
  return worst;
}

// Eq (30), (31): omega' is the same vector in the body and in space, Omega_p k × omega; k' = omega × k.
TEST(Equation30And31, OmegaTurnsAboutKAndKAboutOmega) {
  const auto body = [](const Top& top) {
    const Vector3d rate = derivative([&](double t) { return top.motion.at(t).omega_B; }, top.t);
    return (rate - top.cones.bodyRate * top.cones.k_P.cross(top.state().omega_B)).norm();
  };
  const auto space = [](const Top& top) {
    const Vector3d rate = derivative([&](double t) { return top.omega_W(t); }, top.t);
    return (rate - top.cones.bodyRate * top.k_W(top.t).cross(top.omega_W(top.t))).norm();
  };
  const auto axis = [](const Top& top) {
    const Vector3d rate = derivative([&](double t) { return top.k_W(t); }, top.t);
    return (rate - top.omega_W(top.t).cross(top.k_W(top.t))).norm();
  };
  expectResidual("omega' in the body, rad/s²", worstOf(251, body), 5e-13);  // measured 3.9e-14
  expectResidual("omega' in space, rad/s²", worstOf(252, space), 5e-13);    // measured 4e-14
  expectResidual("k', 1/s", worstOf(253, axis), 5e-13);                     // measured 9.5e-14
}

// Eq (32) to (34): omega_p = Omega_p k + omega = L/I1, and both vectors turn at it.
TEST(Equation32To34, OmegaSplitsIntoPrecessionAndSpin) {
  const auto sum = [](const Top& top) {
    const Vector3d k = top.k_W(top.t), omega = top.omega_W(top.t);
    const AngularVelocityParts parts = top.cones.parts(omega, k);
    const double I1 = top.moments[(top.cones.axis + 1) % 3];
    EXPECT_LE((parts.precession + parts.spin - omega).norm(), 4e-16);
    EXPECT_LE((parts.spin + top.cones.bodyRate * k).norm(), 0);
    return std::max((parts.precession - top.motion.L_W() / I1).norm(),
                    std::abs(parts.precession.norm() - top.cones.precessionRate));
  };
  expectResidual("omega + Omega_p k - L/I1, rad/s", worstOf(254, sum), 6e-15);  // measured 1e-15
  const auto turning = [](const Top& top) {
    const Vector3d rate_p = top.cones.parts(top.omega_W(top.t), top.k_W(top.t)).precession;
    const Vector3d omega_ = derivative([&](double t) { return top.omega_W(t); }, top.t);
    const Vector3d k_ = derivative([&](double t) { return top.k_W(t); }, top.t);
    return std::max((omega_ - rate_p.cross(top.omega_W(top.t))).norm(),
                    (k_ - rate_p.cross(top.k_W(top.t))).norm());
  };
  expectResidual("omega' and k' from omega_p, 1/s", worstOf(255, turning), 5e-13);  // measured 8.9e-14
}

// The prolate top of eq (20): omega_p = L/I1 = 4/3 along L.
TEST(Equation34, ProlateTopPrecessesAboutLAtLOverI1) {
  const double theta = 25 * 3.14159265358979323846 / 180;
  const Vector3d omega(2 * std::sin(theta) / 1.5, 0, 2 * std::cos(theta) / 0.9);
  const PrecessionCones cones = *precessionCones(PrincipalMoments({1.5, 1.5, 0.9}), omega);
  const Vector3d along(std::sin(theta), 0, std::cos(theta));
  EXPECT_LE((cones.parts(omega, cones.k_P).precession - 4.0 / 3 * along).norm(), 1e-15);
}

// Eq (35): omega goes round L at L/I1, on a circle of radius L sin theta cos theta |1/I1 - 1/I3|.
TEST(Equation35, OmegaPrecessesAboutL) {
  const auto precession = [](const Top& top) {
    const Vector3d L = top.motion.L_W();
    const double I1 = top.moments[(top.cones.axis + 1) % 3], I3 = top.moments[top.cones.axis];
    const Vector3d rate = derivative([&](double t) { return top.omega_W(t); }, top.t);
    const Herpolhode herpolhode(top.moments, top.omega0_B);
    const double theta = top.cones.tilt_rad;
    const double radius = L.norm() * std::sin(theta) * std::cos(theta) * std::abs(1 / I1 - 1 / I3);
    EXPECT_NEAR(herpolhode.largestRadius(), radius, 4e-15);
    EXPECT_NEAR(herpolhode.smallestRadius(), radius, 4e-15);
    EXPECT_NEAR(herpolhode.rate(radius), top.cones.precessionRate, 1e-14 * top.cones.precessionRate);
    return (rate - (L / I1).cross(top.omega_W(top.t))).norm();
  };
  expectResidual("omega' - L/I1 × omega, rad/s²", worstOf(256, precession), 5e-13);  // measured 3.8e-14
  EXPECT_NEAR(Herpolhode(PrincipalMoments({1.5, 1.5, .9}), {.5, 0, 2}).largestRadius(), 0.3076923076923077, 1e-16);
}

// Eq (36): L = I1 omega + (I3 - I1)(k·omega) k; eq (37): Omega_p of this football is -0.8.
TEST(Equation36And37, LFollowsFromOmegaAndTheAxis) {
  const auto momentum = [](const Top& top) {
    const double I1 = top.moments[(top.cones.axis + 1) % 3], I3 = top.moments[top.cones.axis];
    const Vector3d omega = top.omega_W(top.t * 1e5), k = top.k_W(top.t * 1e5);
    return (I1 * omega + (I3 - I1) * k.dot(omega) * k - top.motion.L_W()).norm() / top.motion.L_W().norm();
  };
  expectResidual("eq (36), relative", worstOf(257, momentum), 5e-15);  // measured 9.8e-16
  EXPECT_NEAR(precessionCones(PrincipalMoments({1.5, 1.5, .9}), {.5, 0, 2})->bodyRate, -0.8, 2e-16);
}

// The half-angles are measured on the motion. The cones roll without slipping: at the line of contact, omega, the
// precession about L and the body's turning have equal speed.
TEST(PrecessionCones, MatchTheMotionAndRollWithoutSlipping) {
  const auto angle = [](const Vector3d& a, const Vector3d& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); };
  const auto cones = [&](const Top& top) {
    const Vector3d k = top.k_W(top.t), omega = top.omega_W(top.t), L = top.motion.L_W();
    return std::max({std::abs(angle(k, L) - top.cones.tilt_rad),
                     std::abs(angle(omega, k) - top.cones.bodyCone_rad),
                     std::abs(angle(omega, L) - top.cones.spaceCone_rad)});
  };
  expectResidual("half-angles, rad", worstOf(258, cones), 5e-15);  // measured 7e-16
  const auto rolling = [](const Top& top) {
    const PrecessionCones& c = top.cones;
    const bool outside = c.tilt_rad > c.bodyCone_rad;
    EXPECT_EQ(outside, c.sense == RollingSense::kOutside);
    EXPECT_NEAR(c.tilt_rad, c.bodyCone_rad + (outside ? 1 : -1) * c.spaceCone_rad, 1e-15);
    return std::abs(c.precessionRate * std::sin(c.spaceCone_rad) -
                    std::abs(c.bodyRate) * std::sin(c.bodyCone_rad));
  };
  expectResidual("omega_p sin(space) - |Omega_p| sin(body), rad/s", worstOf(259, rolling),
                 4e-15);  // measured 1.7e-16
}

}  // namespace
}  // namespace poinsot::physics
