// SPDX-License-Identifier: Apache-2.0
// Oracle: Eigen's turns about single axes, and differences of attitudes.
#include "physics/euler_angles.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>
#include <random>

#include "core/error.h"

namespace poinsot::physics {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

const Vector3d kX = Vector3d::UnitX(), kY = Vector3d::UnitY(), kZ = Vector3d::UnitZ();

// Measured: 4e-16.
TEST(EulerAngles, TurnAboutZThenXThenZ) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(-6, 6);
  for (int i = 0; i < 200; ++i) {
    const EulerAngles a{angle(random), angle(random), angle(random)};
    const Quaterniond expected =
        AngleAxisd(a.precession, kZ) * AngleAxisd(a.nutation, kX) * AngleAxisd(a.spin, kZ);
    EXPECT_LT(Quaterniond(attitudeOf(a)).angularDistance(expected), 2e-15);
    const RollPitchYaw b{a.precession, a.nutation, a.spin};
    EXPECT_LT(Quaterniond(attitudeOf(b))
                  .angularDistance(AngleAxisd(b.yaw, kZ) * AngleAxisd(b.pitch, kY) * AngleAxisd(b.roll, kX)),
              2e-15);
  }
}

// The difference over 2e-5 s has an error of h² times the third derivative. Measured: 6e-10.
TEST(EulerAngles, RatesGiveTheAngularVelocity) {
  constexpr double kH = 1e-5;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> value(-2, 2);
  for (int i = 0; i < 100; ++i) {
    const EulerAngles a{value(random), value(random), value(random)};
    const EulerAngles rate{value(random), value(random), value(random)};
    const auto at = [&](double t) {
      return Quaterniond(attitudeOf(EulerAngles{a.precession + t * rate.precession, a.nutation + t * rate.nutation,
                                                a.spin + t * rate.spin}));
    };
    const AngleAxisd turn_B(at(-kH).conjugate() * at(kH));  // in B, to first order
    EXPECT_LT((turn_B.angle() / (2 * kH) * turn_B.axis() - omegaFromEulerRates(a, rate)).norm(), 5e-9);
  }
}

// Worked out by hand: the axis leans from z towards -y, and a lean of the body's z is the Euler angle theta.
TEST(LeaningAttitude, LeansTheAxisTowardsMinusY) {
  for (const Vector3d& axis_B : {Vector3d(0, 0, 2), Vector3d(3, 0, 0), Vector3d(1, -2, 0.5), Vector3d(0, 0, -1)}) {
    const Quaterniond q_WB(leaningAttitude(axis_B, 0.7));
    const Vector3d leaning_W(0, -std::sin(0.7), std::cos(0.7));
    EXPECT_LT((q_WB * axis_B.normalized() - leaning_W).norm(), 1e-15);
  }
  EXPECT_EQ(leaningAttitude(kZ, 0.7).coeffs(), attitudeOf(EulerAngles{0, 0.7, 0}).coeffs());
}

TEST(EulerAngles, RejectAnAngleThatIsNotFinite) {
  EXPECT_THROW(attitudeOf(EulerAngles{std::numeric_limits<double>::infinity(), 0, 0}), core::Error);
  EXPECT_THROW(attitudeOf(RollPitchYaw{0, std::numeric_limits<double>::quiet_NaN(), 0}), core::Error);
}

}  // namespace
}  // namespace poinsot::physics
