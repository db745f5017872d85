// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "physics/free_motion.h"
#include "physics/random_bodies.h"
#include "physics/residual.h"

// General free motion is compared with the lecture's symmetric top, eq (19) to (37) in terms of L, k and omega.

namespace poinsot::physics {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

struct Top {
  double Ip = 0, I3 = 0;
  Vector3d omega0_B;
  Quaterniond q0_WB;
  double t = 0;

  FreeMotion motion() const { return FreeMotion(PrincipalMoments({Ip, Ip, I3}), omega0_B, q0_WB); }
};

Top randomTop(Draw& draw) {
  const double Ip = draw.between(0.6, 2);
  return {Ip, Ip * draw.between(0.1, 1.99), draw.direction() * draw.between(0.3, 3), draw.attitude(),
          draw.between(-30, 30)};
}

// The two rotations of eq (20) and (29) give the expected attitude: k and the body turn about L by L t/Ip, and the
// body about its own axis by -Omega_p t. In plain doubles the angles are off by eps |omega| t, which sets the
// bound.
TEST(SymmetricTop, AttitudeCombinesTwoSteadyRotations) {
  Draw draw(61);
  double worst = 0;
  for (int i = 0; i < 300; ++i) {
    const Top top = randomTop(draw);
    const FreeMotion motion = top.motion();
    const double rate = motion.L_W().norm() / top.Ip, Omega_p = (top.I3 / top.Ip - 1) * top.omega0_B[2];
    const Quaterniond expected = Quaterniond(AngleAxisd(rate * top.t, motion.L_W().normalized())) * top.q0_WB *
                                 Quaterniond(AngleAxisd(-Omega_p * top.t, Vector3d::UnitZ()));
    worst = std::max(worst, 2 * (expected.conjugate() * motion.at(top.t).q_WB).vec().norm());
  }
  expectResidual("two steady rotations, rad", worst, 2e-13);  // measured 1.7e-14
}

// Eq (27) to (29): omega turns about k in the body at Omega_p, with the sign of I3 - Ip.
TEST(SymmetricTop, OmegaTurnsAboutTheAxisInTheBody) {
  Draw draw(62);
  double worst = 0;
  for (int i = 0; i < 300; ++i) {
    const Top top = randomTop(draw);
    const double Omega_p = (top.I3 / top.Ip - 1) * top.omega0_B[2];
    const Vector3d expected = AngleAxisd(Omega_p * top.t, Vector3d::UnitZ()) * top.omega0_B;
    worst = std::max(worst, (top.motion().at(top.t).omega_B - expected).norm() / expected.norm());
  }
  expectResidual("omega in the body, relative", worst, 1e-13);  // measured 3.5e-15
}

// Eq (19): L, omega and k stay in one plane.
TEST(SymmetricTop, MomentumVelocityAndAxisLieInOnePlane) {
  Draw draw(63);
  double plane = 0;
  for (int i = 0; i < 300; ++i) {
    const Top top = randomTop(draw);
    const FreeMotion motion = top.motion();
    const RigidBodyState s = motion.at(top.t * 1e5);
    const Vector3d k = s.q_WB * Vector3d::UnitZ();
    const double L = motion.L_W().norm();
    plane = std::max(plane, std::abs(s.omega_W.dot(k.cross(motion.L_W()))) / (L * s.omega_W.norm()));
  }
  expectResidual("omega·(k × L), relative", plane, 4e-15);  // measured 6.5e-16
}

// A prolate top with Ip = 1.5, I3 = 0.9 and |L| = 2 at 25 deg from k. By hand omega_P = 4/3 rad/s, and k returns
// after 2 pi/omega_P = 4.71238898038469 s.
TEST(SymmetricTop, AxisReturnsAfterOnePrecession) {
  const double theta = 25 * 3.14159265358979323846 / 180;
  const FreeMotion motion(PrincipalMoments({1.5, 1.5, 0.9}),
                          {2 * std::sin(theta) / 1.5, 0, 2 * std::cos(theta) / 0.9}, Quaterniond::Identity());
  const Vector3d k = motion.at(4.71238898038469).q_WB * Vector3d::UnitZ();
  EXPECT_LE((k - Vector3d::UnitZ()).norm(), 4e-15);  // measured 6e-16
  const Vector3d opposite = motion.at(4.71238898038469 / 2).q_WB * Vector3d::UnitZ();
  EXPECT_NEAR(opposite.dot(Vector3d::UnitZ()), std::cos(2 * theta), 2e-15);
}

// Feynman's plate, with I3 = 2 Ip and k at 5 deg from L, wobbles twice in a turn:
// omega_P/omega_3 = 2/cos theta = 2.00763967508669.
TEST(SymmetricTop, PlateWobblesTwiceAsFastAsItSpins) {
  const double theta = 5 * 3.14159265358979323846 / 180;
  const Vector3d omega0(std::sin(theta), 0, std::cos(theta) / 2);
  const FreeMotion motion(PrincipalMoments({1, 1, 2}), omega0, Quaterniond::Identity());
  const double wobble = 2 * 3.14159265358979323846 / (2.00763967508669 * omega0[2]);
  const Vector3d k = motion.at(wobble).q_WB * Vector3d::UnitZ();
  EXPECT_LE((k - Vector3d::UnitZ()).norm(), 4e-15);  // measured 1e-16
}

}  // namespace
}  // namespace poinsot::physics
