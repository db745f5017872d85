// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "physics/free_motion.h"
#include "physics/high_order_difference.h"
#include "physics/precession_cones.h"
#include "physics/random_bodies.h"
#include "physics/residual.h"
#include "physics/start.h"

// The symmetric top from the body, and the Chandler wobble: the lecture's eq (27) to (29).

namespace poinsot::physics {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// The Earth as a rigid top: its dynamical ellipticity e = I3/Ip - 1 and the angle of its spin from the axis.
struct Earth {
  double ellipticity, offAxis_rad;

  PrincipalMoments moments() const { return PrincipalMoments({1, 1, 1 + ellipticity}); }
  static double rate() { return 2 * 3.14159265358979323846 / kSiderealDay_s; }
  Vector3d omega() const { return {rate() * std::tan(offAxis_rad), 0, rate()}; }
  PrecessionCones cones() const { return *precessionCones(moments(), omega()); }
};

struct Wobble {
  double siderealDays, solarDays;
};

Wobble wobbleOf(double ellipticity) {
  const double period = Earth{ellipticity, 1e-6}.cones().wobblePeriod();
  return {period / kSiderealDay_s, period / kSolarDay_s};
}

// The lecture's "about 306 days" belongs to 1/306 = 0.003268; its 0.0033 gives 303 sidereal days.
TEST(Equation29, GivesTheChandlerPeriodOfTheRigidEarth) {
  // 1 + e rounded to a double leaves e good to 7e-14 relative: 2e-11 days.
  EXPECT_NEAR(wobbleOf(0.0033).siderealDays, 303.030303030303, 3e-11);
  EXPECT_NEAR(wobbleOf(0.0033).solarDays, 302.2028988, 1e-7);
  EXPECT_NEAR(wobbleOf(1.0 / 306).siderealDays, 306, 3e-11);
  EXPECT_NEAR(wobbleOf(1.0 / 306).solarDays, 305.1644872, 1e-7);
  const double H = 0.0032737949;  // (I3 - Ip)/I3, as precession gives it
  EXPECT_NEAR(H / (1 - H), 0.003284547836, 1e-12);
  EXPECT_NEAR(wobbleOf(H / (1 - H)).siderealDays, 304.46, 5e-3);
  EXPECT_NEAR(wobbleOf(H / (1 - H)).solarDays, 303.6246, 5e-5);  // 304.4559 x 86164.0905/86400
}

// The lecture's footnote: the wobble is some 10 m at the pole, and L is only 3.3 cm from omega.
TEST(Equation29, ChandlerWobbleIsSmall) {
  const double radius_m = 6371e3;
  const PrecessionCones cones = Earth{0.003284547836, 10 / radius_m}.cones();
  EXPECT_NEAR(cones.bodyCone_rad, 1.57e-6, 5e-9);
  EXPECT_NEAR(cones.spaceCone_rad / cones.bodyCone_rad, 0.003284547836 / 1.003284547836, 1e-12);
  EXPECT_NEAR(cones.spaceCone_rad * radius_m, 0.033, 5e-4);
  EXPECT_EQ(cones.sense, RollingSense::kInside);
}

// Sign of Omega_p: omega goes round k in the sense of the spin for an oblate body, against it for a prolate one.
TEST(Equation29, WobbleTurnsWithTheSpinIfOblate) {
  for (const double I3 : {0.7, 1.4}) {
    const PrincipalMoments moments({1, 1, I3});
    const Vector3d omega(0.5, 0, 2);
    const FreeMotion motion(moments, omega, Quaterniond::Identity());
    const double turning = motion.at(0.01).omega_B[1];
    EXPECT_GT(turning * (I3 - 1), 0);
    EXPECT_GT(turning * precessionCones(moments, omega)->bodyRate, 0);
    EXPECT_EQ(precessionCones(moments, omega)->bodyRate > 0, I3 > 1);
  }
}

PrincipalMoments randomTop(Draw& draw) {
  const double Ip = draw.between(0.6, 2);
  return PrincipalMoments({Ip, Ip, Ip * draw.between(0.1, 1.99)});
}

// Eq (27), (28) by differences, and eq (29) at late times: omega_3 and the size of omega_perp are constant.
TEST(Equation27To29, OmegaTurnsRigidlyInTheBody) {
  Draw draw(241);
  double size = 0, rates = 0;
  for (int i = 0; i < 200; ++i) {
    const PrincipalMoments moments = randomTop(draw);
    const Vector3d omega0 = draw.direction();
    const FreeMotion motion(moments, omega0, draw.attitude());
    const double Omega_p = (moments[2] / moments[0] - 1) * omega0[2], t = draw.sign() * draw.decade(0, 8);
    const Vector3d late = motion.at(t).omega_B;
    size =
        std::max({size, std::abs(late.head<2>().norm() - omega0.head<2>().norm()), std::abs(late[2] - omega0[2])});
    const Vector3d rate = derivative([&](double s) { return motion.at(s).omega_B; }, 3);
    const Vector3d w = motion.at(3).omega_B;
    rates = std::max(
        {rates, std::abs(rate[0] + Omega_p * w[1]), std::abs(rate[1] - Omega_p * w[0]), std::abs(rate[2])});
  }
  expectResidual("|omega_perp| and omega_3, rad/s", size, 2e-15);  // measured 3.3e-16
  expectResidual("eq (27), (28), rad/s²", rates, 5e-13);           // measured 4.7e-15
}

// After a wobble's period omega is back in the body; after half a period omega_perp is reversed.
TEST(Equation29, OmegaReturnsAfterTheWobble) {
  Draw draw(242);
  double worst = 0;
  for (int i = 0; i < 100; ++i) {
    const PrincipalMoments moments = randomTop(draw);
    const Vector3d omega0 = draw.direction();
    const FreeMotion motion(moments, omega0, draw.attitude());
    const double period = precessionCones(moments, omega0)->wobblePeriod();
    worst = std::max(worst, (motion.at(period).omega_B - omega0).norm());
    const Vector3d half = motion.at(period / 2).omega_B;
    worst = std::max(worst, (half.head<2>() + omega0.head<2>()).norm());
  }
  expectResidual("omega after a wobble, rad/s", worst, 4e-15);  // measured 1e-15
}

}  // namespace
}  // namespace poinsot::physics
