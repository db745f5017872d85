// SPDX-License-Identifier: Apache-2.0
// The attitude that brings L onto the vertical. The oracle turns a vector by the quaternion's matrix in long
// double (64-bit mantissa) and computes the angle between two directions with atan2.
#include "physics/level_attitude.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/error.h"
#include "physics/free_motion.h"
#include "physics/random_bodies.h"
#include "physics/residual.h"

namespace poinsot::physics {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using LongVector = Eigen::Matrix<long double, 3, 1>;

constexpr double kArcsecond = std::numbers::pi / 648000;

double sign(Vertical vertical) { return vertical == Vertical::kUp ? 1 : -1; }

/// Returns tilts from 0.001 arcsec to 180 degrees, dense where two directions are nearly opposite or nearly equal.
std::vector<double> tilts() {
  std::vector<double> list{0, std::numbers::pi / 2, std::numbers::pi};
  for (const double from : {0.0, std::numbers::pi})
    for (double tilt = 0.001 * kArcsecond; tilt < 1.6; tilt *= 1.37) list.push_back(std::abs(from - tilt));
  return list;
}

std::vector<Vector3d> directions() {
  std::vector<Vector3d> list;
  for (const double tilt : tilts())
    for (int side = 0; side < 24; ++side) {
      const double angle = (side + 0.1) * std::numbers::pi / 12;
      list.emplace_back(std::sin(tilt) * std::cos(angle), std::sin(tilt) * std::sin(angle), std::cos(tilt));
    }
  return list;
}

/// Returns the distance of the turned vector from the vertical, over its length.
double offVertical(const Quaterniond& q, const Vector3d& v, Vertical vertical) {
  const LongVector turned = q.cast<long double>().normalized().toRotationMatrix() * v.cast<long double>();
  EXPECT_GT(sign(vertical) * static_cast<double>(turned.z()), 0);
  return static_cast<double>(std::hypot(turned.x(), turned.y()) / v.cast<long double>().norm());
}

// Measured 1.6e-16, the rounding of the quaternion. Eigen's FromTwoVectors leaves 2.8e-6.
TEST(LevelAttitude, TurnsEveryDirectionOntoTheVertical) {
  double worst = 0;
  for (const Vector3d& d : directions())
    for (const Vertical vertical : {Vertical::kUp, Vertical::kDown})
      for (const double length : {1.0, 1e-200, 6e200})
        worst = std::max(worst, offVertical(turnOntoVertical(length * d, vertical), length * d, vertical));
  expectResidual("vector off the vertical, over its length", worst, 4e-16);
}

// The turn is about a horizontal axis, by the angle from the vertical. Measured: 4.4e-16 rad, a unit in the last
// place of pi.
TEST(LevelAttitude, TakesTheShortestWay) {
  double worst = 0;
  for (const Vector3d& d : directions())
    for (const Vertical vertical : {Vertical::kUp, Vertical::kDown}) {
      const Quaterniond q = turnOntoVertical(d, vertical);
      EXPECT_EQ(q.z(), 0);
      const double turn = 2 * std::atan2(std::hypot(q.x(), q.y()), q.w());
      worst = std::max(worst, std::abs(turn - std::atan2(std::hypot(d.x(), d.y()), sign(vertical) * d.z())));
    }
  expectResidual("angle of the turn, rad", worst, 1e-15);
}

// Directions without a shortest way turn as if they leaned towards +y, by definition.
TEST(LevelAttitude, TurnsAnOppositeDirectionAboutX) {
  EXPECT_EQ(turnOntoVertical({0, 0, 2}, Vertical::kDown).coeffs(), Eigen::Vector4d(-1, 0, 0, 0));
  EXPECT_EQ(turnOntoVertical({0, 0, -2}, Vertical::kUp).coeffs(), Eigen::Vector4d(1, 0, 0, 0));
  EXPECT_EQ(turnOntoVertical({0, 0, 2}, Vertical::kUp).coeffs(), Eigen::Vector4d(0, 0, 0, 1));
  EXPECT_EQ(turnOntoVertical(Vector3d::Zero(), Vertical::kDown).coeffs(), Eigen::Vector4d(0, 0, 0, 1));
}

/// Calls check(axes, omega_B) for spins about either end of each axis, with L off it by each tilt up to 0.02 rad,
/// for bodies in their principal axes and in others.
template <typename Check>
void forEachWobble(const Check& check) {
  Draw draw(31);
  for (const double tilt : tilts()) {
    if (tilt > 0.02) continue;
    for (int axis = 0; axis < 3; ++axis)
      for (const double spin : {7.3e-5, -3.0})
        for (int side = 0; side < 12; ++side) {
          const PrincipalMoments moments = draw.moments();
          Vector3d m_P;
          m_P[axis] = spin * std::cos(tilt);
          m_P[(axis + 1) % 3] = std::abs(spin) * std::sin(tilt) * std::cos(side * std::numbers::pi / 6);
          m_P[(axis + 2) % 3] = std::abs(spin) * std::sin(tilt) * std::sin(side * std::numbers::pi / 6);
          const Vector3d omega_P = m_P.cwiseQuotient(moments.values());
          check(PrincipalAxes(moments), omega_P);
          const PrincipalAxes turned(moments, draw.attitude());
          check(turned, turned.toB(omega_P));
        }
  }
}

// FreeMotion computes L to 100 bits from the attitude and the spin. Measured: 1.6e-16 |L|.
TEST(LevelAttitude, MakesLVerticalForEveryWobble) {
  double worst = 0;
  forEachWobble([&](const PrincipalAxes& axes, const Vector3d& omega_B) {
    for (const Vertical vertical : {Vertical::kUp, Vertical::kDown}) {
      const Vector3d L_W = FreeMotion(axes, omega_B, levelAttitude(axes, omega_B, vertical)).at(0).L_W;
      EXPECT_GT(sign(vertical) * L_W.z(), 0);
      worst = std::max(worst, std::hypot(L_W.x(), L_W.y()) / L_W.norm());
    }
  });
  expectResidual("L off the vertical, over |L|", worst, 4e-16);
}

TEST(LevelAttitude, RefusesDirectionsThatAreNotFinite) {
  for (const double bad : {NAN, INFINITY, -INFINITY}) {
    EXPECT_THROW(turnOntoVertical({bad, 0, 0}, Vertical::kUp), core::Error);
    EXPECT_THROW(turnOntoVertical({1, 0, bad}, Vertical::kDown), core::Error);
    EXPECT_THROW(levelAttitude(PrincipalMoments(1, 2, 2.5), {0, bad, 1}, Vertical::kUp), core::Error);
  }
}

}  // namespace
}  // namespace poinsot::physics
