// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "physics/free_motion.h"
#include "physics/herpolhode.h"
#include "physics/high_order_difference.h"
#include "physics/poinsot_construction.h"
#include "physics/random_bodies.h"
#include "physics/residual.h"

// Poinsot's construction: the lecture's eq (38) to (40) and its figure. free_motion_invariants_test.cpp tests that
// omega stays on plane and ellipsoid, herpolhode_test.cpp that equal lengths roll off.

namespace poinsot::physics {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

struct Case {
  PrincipalMoments moments;
  Vector3d omega0;
  FreeMotion motion;
};

Case randomCase(Draw& draw) {
  const PrincipalMoments moments = draw.moments();
  const Vector3d omega0 = draw.direction();
  return {moments, omega0, FreeMotion(moments, omega0, draw.attitude())};
}

// L is normal to the ellipsoid at omega. Central differences give grad T, exact for a quadratic T except for
// rounding. At late times it must still be the fixed L.
TEST(Equation39, MomentumIsTheGradientOfTheEnergy) {
  Draw draw(262);
  double differences = 0, direction = 0;
  for (int i = 0; i < 200; ++i) {
    const Case c = randomCase(draw);
    const RigidBodyState s = c.motion.at(draw.sign() * draw.decade(-1, 8));
    Vector3d gradient;
    for (int k = 0; k < 3; ++k) {
      const Vector3d step = 0.5 * Vector3d::Unit(k);
      gradient[k] = c.moments.kineticEnergy(s.omega_B + step) - c.moments.kineticEnergy(s.omega_B - step);
    }
    const Vector3d normal = s.q_WB * gradient, L = c.motion.L_W();
    differences = std::max(differences, (normal - L).norm() / L.norm());
    direction = std::max(direction, std::atan2(normal.cross(L).norm(), normal.dot(L)));
  }
  expectResidual("grad T - L, relative", differences, 1e-14);      // measured 1e-15
  expectResidual("angle of grad T and L, rad", direction, 1e-14);  // measured 7.3e-16
}

// The plane omega·L = 2T touches the ellipsoid in one point. Other points lie below it, by an amount that follows
// from their distance to the point of contact.
TEST(Equation40, PlaneTouchesTheEllipsoidInOnePoint) {
  Draw draw(263);
  for (int i = 0; i < 200; ++i) {
    const Case c = randomCase(draw);
    const PoinsotConstruction construction(c.moments, c.omega0);
    const RigidBodyState s = c.motion.at(draw.sign() * draw.decade(-1, 8));
    const Vector3d normal_B = s.q_WB.conjugate() * c.motion.L_W().normalized(), &a = construction.semiAxes_P();
    for (int j = 0; j < 20; ++j) {
      const Vector3d other = a.cwiseProduct(draw.direction());
      // On the unit sphere of x/a, 1 - cos of an angle is half the squared chord.
      const double chord = (other - s.omega_B).cwiseQuotient(a).norm();
      EXPECT_NEAR(other.dot(normal_B), construction.planeHeight() * (1 - chord * chord / 2),
                  8e-15 * construction.planeHeight());
    }
  }
}

// The figure: the ellipsoid turns about the point of contact. A point of the body at x has the velocity omega × x;
// at the tip of omega that is 0, so nothing slips, and points of the ellipsoid near by move with the body.
TEST(RollingFigure, ContactPointIsAtRest) {
  Draw draw(264);
  double worst = 0;
  for (int i = 0; i < 200; ++i) {
    const Case c = randomCase(draw);
    const double t = draw.between(-50, 50);
    const Vector3d contact_B = c.motion.at(t).omega_B;  // this point of the body, followed through space
    const Vector3d velocity = derivative([&](double s) { return Vector3d(c.motion.at(s).q_WB * contact_B); }, t);
    worst = std::max(worst, velocity.norm());
  }
  expectResidual("velocity of the contact point, rad/s²", worst, 5e-13);  // measured 1.1e-14
}

// The rate of the herpolhode on the motion, and its bounds L/I3 and L/I1.
TEST(RollingFigure, HerpolhodeHasTheRateOfTheMotion) {
  Draw draw(265);
  double worst = 0;
  for (int i = 0; i < 200; ++i) {
    const Case c = randomCase(draw);
    const double t = draw.between(-50, 50), L = c.motion.L_W().norm();
    const Vector3d normal = c.motion.L_W() / L, omega = c.motion.at(t).omega_W;
    const Vector3d radial = omega - omega.dot(normal) * normal;
    const Vector3d velocity = derivative([&](double s) { return c.motion.at(s).omega_W; }, t);
    const Herpolhode herpolhode(c.moments, c.omega0);
    const double rate = herpolhode.rate(radial.norm());
    EXPECT_GE(rate, L / c.moments.values().maxCoeff() * (1 - 1e-12));
    EXPECT_LE(rate, L / c.moments.values().minCoeff() * (1 + 1e-12));
    // Times the squared radius: near L the angle itself is ill defined.
    worst = std::max(worst, std::abs(normal.dot(radial.cross(velocity)) - rate * radial.squaredNorm()));
  }
  expectResidual("rho² chi', (rad/s)³", worst, 5e-13);  // measured 2.1e-14
}

TEST(RollingFigure, HerpolhodeRateIsRightInLimitingCases) {
  const Herpolhode steady(PrincipalMoments({2, 3, 4}), {0, 2, 0});
  EXPECT_EQ(steady.rate(0), 0);
  const Herpolhode spiral(PrincipalMoments({1, 2, 2.25}), {.75, .5, 1});
  EXPECT_NEAR(spiral.rate(0), 1.286953767623375, 3e-16);  // 2T/L = L/I2
  EXPECT_EQ(spiral.rate(0.3), spiral.rate(0));
}

}  // namespace
}  // namespace poinsot::physics
