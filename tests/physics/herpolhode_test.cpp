// SPDX-License-Identifier: Apache-2.0
#include "physics/herpolhode.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "physics/free_motion.h"
#include "physics/high_order_difference.h"
#include "physics/polhode.h"
#include "physics/random_bodies.h"
#include "physics/residual.h"

namespace poinsot::physics {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kTurn = 2 * 3.14159265358979323846;

/// The herpolhode in plane coordinates about L, from the motion alone.
class PlaneCurve {
 public:
  explicit PlaneCurve(const FreeMotion& motion) : motion_(motion), normal_(motion.L_W().normalized()) {
    first_ = normal_.unitOrthogonal();
    second_ = normal_.cross(first_);
  }

  Vector3d at(double t) const {
    const Vector3d omega = motion_.at(t).omega_W;
    return {omega.dot(first_), omega.dot(second_), 0};
  }

  static double angle(const Vector3d& from, const Vector3d& to) {
    return std::atan2(from.cross(to)[2], from.dot(to));
  }

 private:
  const FreeMotion& motion_;
  Vector3d normal_, first_, second_;
};

struct Case {
  PrincipalMoments moments;
  Vector3d omega0;
};

/// Returns a case away from the separatrix, so that a few hundred even steps in time follow the curve.
Case randomCase(Draw& draw) {
  for (;;) {
    const Case c{draw.moments(), draw.direction()};
    const Herpolhode herpolhode(c.moments, c.omega0);
    if (herpolhode.smallestRadius() > 0.05 * herpolhode.largestRadius()) return c;
  }
}

TEST(Herpolhode, RadiiAndAngleMatchTheMotion) {
  Draw draw(81);
  double angle = 0, beyond = 0, reached = 0;
  for (int i = 0; i < 40; ++i) {
    const Case c = randomCase(draw);
    const Herpolhode herpolhode(c.moments, c.omega0);
    const FreeMotion motion(c.moments, c.omega0, draw.attitude());
    const PlaneCurve curve(motion);
    constexpr int kSteps = 512;
    double swept = 0, least = 1e300, most = 0;
    for (int j = 0; j < kSteps; ++j) {
      const Vector3d from = curve.at(herpolhode.radialPeriod() * j / kSteps);
      swept += PlaneCurve::angle(from, curve.at(herpolhode.radialPeriod() * (j + 1) / kSteps));
      least = std::min(least, from.norm());
      most = std::max(most, from.norm());
    }
    angle = std::max(angle, std::abs(swept - herpolhode.anglePerRadialPeriod()));
    beyond = std::max({beyond, herpolhode.smallestRadius() - least, most - herpolhode.largestRadius()});
    reached = std::max({reached, least / herpolhode.smallestRadius() - 1, 1 - most / herpolhode.largestRadius()});
  }
  // The direction of a radius of 0.01 is known to 1e-16/0.01 only.
  expectResidual("angle per radial period, rad", angle, 4e-13);  // measured 8.5e-14
  expectResidual("outside the ring", beyond, 4e-15);             // measured 0
  expectResidual("short of the ring's edges", reached, 1e-3);    // measured 4.7e-05
}

// In a radial period the contact point covers the same length on the ellipsoid and on the plane. The trapezoidal
// rule over a period, which converges geometrically, gives both lengths from |omega'| in the body (Euler's
// equations) and in space (differences).
TEST(Herpolhode, RollsWithoutSlipping) {
  Draw draw(82);
  double worst = 0;
  for (int i = 0; i < 20; ++i) {
    const Case c = randomCase(draw);
    const FreeMotion motion(c.moments, c.omega0, draw.attitude());
    const double period = Herpolhode(c.moments, c.omega0).radialPeriod();
    constexpr int kSteps = 256;
    double onEllipsoid = 0, onPlane = 0;
    for (int j = 0; j < kSteps; ++j) {
      const double t = period * j / kSteps;
      const Vector3d w = motion.at(t).omega_B, m = c.moments.angularMomentum(w);
      onEllipsoid += m.cross(w).cwiseQuotient(c.moments.values()).norm();
      onPlane += derivative([&](double at) { return motion.at(at).omega_W; }, t).norm();
    }
    worst = std::max(worst, std::abs(onPlane / onEllipsoid - 1));
  }
  expectResidual("arc lengths, relative", worst, 1e-12);  // measured 4e-14
}

// Montgomery, Am. J. Phys. 59 (1991) 394: twice the angle per radial period is 2T Tp/L - A modulo a turn, where A
// is the solid angle that L encloses in the body. The trapezoidal rule gives A from Euler's equations, without
// elliptic integrals.
TEST(Herpolhode, HasMontgomerysGeometricPhase) {
  Draw draw(83);
  double worst = 0;
  for (int i = 0; i < 40; ++i) {
    const Case c = randomCase(draw);
    const Polhode polhode(c.moments, c.omega0);
    int axis = 0;
    if (polhode.regime() == PolhodeRegime::kAboutLargest)
      c.moments.values().maxCoeff(&axis);
    else
      c.moments.values().minCoeff(&axis);
    const int x = (axis + 1) % 3, y = (axis + 2) % 3;
    const FreeMotion motion(c.moments, c.omega0, Quaterniond::Identity());
    const double L = motion.L_W().norm();
    constexpr int kSteps = 512;
    double solidAngle = 0;
    for (int j = 0; j < kSteps; ++j) {
      const Vector3d w = motion.at(polhode.period() * j / kSteps).omega_B, m = c.moments.angularMomentum(w);
      const Vector3d rate = m.cross(w);
      const double turning = (m[x] * rate[y] - m[y] * rate[x]) / (m[x] * m[x] + m[y] * m[y]);
      solidAngle += (std::copysign(1.0, m[axis]) - m[axis] / L) * turning * polhode.period() / kSteps;
    }
    const double expected = 2 * motion.kineticEnergy() * polhode.period() / L - solidAngle;
    const double difference = 2 * Herpolhode(c.moments, c.omega0).anglePerRadialPeriod() - expected;
    worst = std::max(worst, std::abs(std::remainder(difference, kTurn)));
  }
  expectResidual("geometric phase, rad", worst, 4e-13);  // measured 7.1e-15
}

// The herpolhode of a body that obeys the triangle inequality has no inflection.
TEST(Herpolhode, NeverBendsOutwards) {
  Draw draw(84);
  for (int i = 0; i < 60; ++i) {
    const Case c = randomCase(draw);
    const FreeMotion motion(c.moments, c.omega0, Quaterniond::Identity());
    const PlaneCurve curve(motion);
    const double step = Herpolhode(c.moments, c.omega0).radialPeriod() / 200;
    for (int j = 0; j < 200; ++j) {
      const Vector3d a = curve.at(step * j), b = curve.at(step * (j + 1)), d = curve.at(step * (j + 2));
      EXPECT_GE((b - a).cross(d - b)[2], -1e-14);
    }
  }
}

TEST(Herpolhode, FindsTheClosureOfClosedCurves) {
  const PrincipalMoments moments({1.25, 2, 2.75});
  {
    const Vector3d omega0(1.577034598253537625, 0, 1.5);
    const Herpolhode herpolhode(moments, omega0);
    const auto closure = herpolhode.closure(100, 1e-12);
    ASSERT_TRUE(closure);
    EXPECT_EQ(closure->radialPeriods, 5);
    EXPECT_EQ(closure->turns, 8);
    EXPECT_NEAR(5 * herpolhode.radialPeriod(), 18.44647312604001, 1e-14);
    EXPECT_NEAR(herpolhode.smallestRadius(), 0.306044796713063, 5e-16);
    EXPECT_NEAR(herpolhode.largestRadius(), 0.7761287014141, 5e-14);
    const FreeMotion motion(moments, omega0, Quaterniond::Identity());
    EXPECT_LE((motion.at(18.44647312604001).omega_W - motion.at(0).omega_W).norm(), 1e-14);  // measured 2e-15
  }
  {
    const Herpolhode herpolhode(moments, {1.5, 0, 0.422945230106353779731});
    const auto closure = herpolhode.closure(100, 1e-12);
    ASSERT_TRUE(closure);
    EXPECT_EQ(closure->radialPeriods, 4);
    EXPECT_EQ(closure->turns, 3);
    EXPECT_NEAR(2 * herpolhode.radialPeriod(), 9.71219205763253422, 5e-15);
    EXPECT_NEAR(herpolhode.smallestRadius(), 0.324832946469297, 5e-16);
    EXPECT_NEAR(herpolhode.largestRadius(), 0.431292990394346, 5e-16);
  }
}

TEST(Herpolhode, FindsNoClosureOfAnOpenCurve) {
  const Herpolhode herpolhode(PrincipalMoments({2, 3, 4}), {.5, .25, 1});
  EXPECT_FALSE(herpolhode.closure(100, 1e-6));
}

// Eq (35): a circle of radius |omega| sin(angle to L) for the symmetric top.
TEST(Herpolhode, SymmetricTopDrawsACircle) {
  Draw draw(85);
  for (int i = 0; i < 50; ++i) {
    const PrincipalMoments moments({1, 1, draw.between(0.2, 1.9)});
    const Vector3d omega = draw.direction(), m = moments.angularMomentum(omega);
    const Herpolhode herpolhode(moments, omega);
    EXPECT_NEAR(herpolhode.smallestRadius(), herpolhode.largestRadius(), 1e-15);
    EXPECT_NEAR(herpolhode.largestRadius(), omega.cross(m).norm() / m.norm(), 1e-15);
  }
}

TEST(Herpolhode, HandlesSteadySpinsAndTheSeparatrix) {
  const Herpolhode steady(PrincipalMoments({2, 3, 4}), {0, 2, 0});
  EXPECT_EQ(steady.regime(), PolhodeRegime::kSteady);
  EXPECT_EQ(steady.largestRadius(), 0);
  EXPECT_EQ(steady.radialPeriod(), 0);
  EXPECT_FALSE(steady.closure(10, 1));
  const Herpolhode spiral(PrincipalMoments({1, 2, 2.25}), {.75, .5, 1});
  EXPECT_EQ(spiral.regime(), PolhodeRegime::kSeparatrix);
  EXPECT_EQ(spiral.smallestRadius(), 0);
  EXPECT_EQ(spiral.anglePerRadialPeriod(), std::numeric_limits<double>::infinity());
  EXPECT_FALSE(spiral.closure(10, 1));
}

}  // namespace
}  // namespace poinsot::physics
