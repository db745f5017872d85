// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>

#include "core/error.h"
#include "physics/free_motion.h"
#include "physics/poinsot_construction.h"
#include "physics/polhode.h"
#include "physics/random_bodies.h"
#include "physics/residual.h"
#include "physics/taylor_oracle.h"

namespace poinsot::physics {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

double angleBetween(const Quaterniond& a, const Quaterniond& b) {
  return TaylorOracle<long double>::angle({a.w(), a.x(), a.y(), a.z()}, b);
}

struct Case {
  PrincipalMoments moments;
  Vector3d omega0_B;
  Quaterniond q0_WB;

  FreeMotion motion() const { return FreeMotion(moments, omega0_B, q0_WB); }
};

Case randomCase(Draw& draw) { return {draw.moments(), draw.direction() * draw.between(0.3, 3), draw.attitude()}; }

/// Calls visit(case, motion, state) for 200 random bodies at 5 times each.
template <typename Visit>
void forRandomStates(std::uint64_t seed, Visit visit) {
  Draw draw(seed);
  for (int i = 0; i < 200; ++i) {
    const Case c = randomCase(draw);
    const FreeMotion motion = c.motion();
    for (int j = 0; j < 5; ++j) visit(c, motion, motion.at(draw.sign() * draw.decade(-1, 8)));
  }
}

TEST(FreeMotionInvariants, EnergyAndAngularMomentumAreConstant) {
  double energy = 0, size = 0, direction = 0;
  forRandomStates(41, [&](const Case& c, const FreeMotion& motion, const RigidBodyState& s) {
    const Vector3d L_W = s.q_WB * c.moments.angularMomentum(s.omega_B);
    const double L = motion.L_W().norm();
    energy = std::max(energy, std::abs(c.moments.kineticEnergy(s.omega_B) / motion.kineticEnergy() - 1));
    size = std::max(size, std::abs(L_W.norm() / L - 1));
    direction = std::max(direction, (L_W - motion.L_W()).norm() / L);
  });
  expectResidual("T, relative", energy, 4e-15);       // measured 6.7e-16
  expectResidual("|L|, relative", size, 4e-15);       // measured 8.9e-16
  expectResidual("L_W, relative", direction, 4e-15);  // measured 1.1e-15
}

TEST(FreeMotionInvariants, StateAtTimeZeroIsTheStart) {
  Draw draw(42);
  double attitude = 0, omega = 0, momentum = 0;
  for (int i = 0; i < 300; ++i) {
    const Case c = randomCase(draw);
    const FreeMotion motion = c.motion();
    const RigidBodyState s = motion.at(0);
    attitude = std::max(attitude, angleBetween(s.q_WB, c.q0_WB));
    omega = std::max(omega, (s.omega_B - c.omega0_B).norm() / c.omega0_B.norm());
    const Vector3d L_W = c.q0_WB.normalized() * c.moments.angularMomentum(c.omega0_B);
    momentum = std::max(momentum, (motion.L_W() - L_W).norm() / L_W.norm());
  }
  expectResidual("attitude at 0, rad", attitude, 4e-15);          // measured 6.7e-16
  expectResidual("omega_B at 0, relative", omega, 2e-15);         // measured 3.9e-16
  expectResidual("L_W of the start, relative", momentum, 2e-15);  // measured 6.5e-16
}

TEST(FreeMotionInvariants, QuaternionHasLengthOneAndNonNegativeW) {
  forRandomStates(43, [&](const Case&, const FreeMotion&, const RigidBodyState& s) {
    EXPECT_NEAR(s.q_WB.norm(), 1, 4e-16);
    EXPECT_GE(s.q_WB.w(), 0);
  });
}

TEST(FreeMotionInvariants, OmegaInSpaceIsTheRotatedBodyOmega) {
  double worst = 0;
  forRandomStates(44, [&](const Case&, const FreeMotion&, const RigidBodyState& s) {
    worst = std::max(worst, (s.omega_W - s.q_WB.toRotationMatrix() * s.omega_B).norm() / s.omega_B.norm());
  });
  expectResidual("omega_W - R omega_B, relative", worst, 2e-15);  // measured 5e-16
}

// Eq (38) and (40), and the lecture's figure: the tip of omega lies on the plane and on the ellipsoid.
TEST(FreeMotionInvariants, ContactPointIsOnPlaneAndEllipsoid) {
  double plane = 0, ellipsoid = 0;
  forRandomStates(45, [&](const Case& c, const FreeMotion& motion, const RigidBodyState& s) {
    const PoinsotConstruction construction(c.moments, c.omega0_B);
    const double height = s.omega_W.dot(motion.L_W()) / motion.L_W().norm();
    plane = std::max(plane, std::abs(height / construction.planeHeight() - 1));
    const Vector3d scaled = s.omega_B.cwiseQuotient(construction.semiAxes_P());
    ellipsoid = std::max(ellipsoid, std::abs(scaled.squaredNorm() - 1));
  });
  expectResidual("height of the contact point, relative", plane, 4e-15);  // measured 1.3e-15
  expectResidual("on the ellipsoid", ellipsoid, 4e-15);                   // measured 8.9e-16
}

// Eq (39): L is normal to the ellipsoid at the point of contact, and the plane does not cut the ellipsoid. Its
// largest height along L, sqrt(sum (semi-axis_i L_i)^2)/|L|, is the height of the plane.
TEST(FreeMotionInvariants, ThePlaneTouchesTheEllipsoid) {
  double tilt = 0, support = 0;
  forRandomStates(46, [&](const Case& c, const FreeMotion& motion, const RigidBodyState& s) {
    const PoinsotConstruction construction(c.moments, c.omega0_B);
    const Vector3d squares = construction.semiAxes_P().cwiseAbs2();
    const Vector3d normal_W = s.q_WB * s.omega_B.cwiseQuotient(squares);
    tilt = std::max(tilt, std::atan2(normal_W.cross(motion.L_W()).norm(), normal_W.dot(motion.L_W())));
    const Vector3d L_B = s.q_WB.conjugate() * motion.L_W();
    const double highest = std::sqrt(squares.dot(L_B.cwiseAbs2())) / L_B.norm();
    support = std::max(support, std::abs(highest / construction.planeHeight() - 1));
  });
  expectResidual("angle of the normal to L, rad", tilt, 4e-15);         // measured 8.6e-16
  expectResidual("height of the ellipsoid, relative", support, 4e-15);  // measured 4.4e-16
}

// Rounding of the intermediate state limits the accuracy: it enters the phase as 1e-16 |omega| t.
TEST(FreeMotionInvariants, MotionFromALaterStateIsTheSameMotion) {
  Draw draw(47);
  double worst = 0;
  for (int i = 0; i < 200; ++i) {
    const Case c = randomCase(draw);
    const FreeMotion motion = c.motion();
    const double t1 = draw.between(-50, 50), t2 = draw.between(0.5, 1);
    const RigidBodyState middle = motion.at(t1);
    const FreeMotion later(c.moments, middle.omega_B, middle.q_WB);
    worst = std::max(worst, angleBetween(later.at(t2).q_WB, motion.at(t1 + t2).q_WB));
  }
  // t1 + t2 is rounded, too, by up to 7e-15 s at 3 rad/s.
  expectResidual("R(t1 + t2), rad", worst, 4e-14);  // measured 1e-14
}

// omega0 -> -omega0 with t -> -t retraces the same attitudes.
TEST(FreeMotionInvariants, TimeReversalRetracesTheAttitudes) {
  Draw draw(48);
  double worst = 0;
  for (int i = 0; i < 200; ++i) {
    const Case c = randomCase(draw);
    const double t = draw.decade(-1, 8);
    const RigidBodyState forward = c.motion().at(t);
    const RigidBodyState reversed = FreeMotion(c.moments, -c.omega0_B, c.q0_WB).at(-t);
    worst = std::max(worst, angleBetween(forward.q_WB, reversed.q_WB));
    EXPECT_LE((forward.omega_B + reversed.omega_B).norm(), 4e-15 * forward.omega_B.norm());
  }
  expectResidual("reversed attitude, rad", worst, 4e-15);  // measured 4.9e-16
}

// Another order of the axes (turned, or mirrored with signs that undo the mirror) must not change the motion.
TEST(FreeMotionInvariants, OrderOfTheAxesDoesNotMatter) {
  const int orders[][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}};
  Draw draw(49);
  double worst = 0;
  for (int i = 0; i < 100; ++i) {
    const Case c = randomCase(draw);
    const double t = draw.decade(-1, 8);
    const RigidBodyState expected = c.motion().at(t);
    for (const auto& order : orders) {
      Matrix3d S = Matrix3d::Zero();  // from body components to components along the renamed axes
      for (int k = 0; k < 3; ++k) S(k, order[k]) = 1;
      S *= S.determinant();
      const PrincipalMoments moments(S.cwiseAbs() * c.moments.values());
      const Quaterniond qS(S);
      const RigidBodyState s = FreeMotion(moments, S * c.omega0_B, c.q0_WB * qS.conjugate()).at(t);
      worst = std::max(worst, (expected.q_WB.toRotationMatrix() - (s.q_WB * qS).toRotationMatrix()).norm());
      EXPECT_LE((s.omega_B - S * expected.omega_B).norm(), 4e-15 * expected.omega_B.norm());
    }
  }
  expectResidual("attitude with renamed axes", worst, 8e-15);  // measured 1.5e-15
}

// Scaling the moments, or omega and time, by powers of two changes no bit.
TEST(FreeMotionInvariants, ScalingByPowersOfTwoChangesNoBit) {
  Draw draw(50);
  for (int i = 0; i < 100; ++i) {
    const Case c = randomCase(draw);
    const double t = draw.between(-100, 100);
    const RigidBodyState expected = c.motion().at(t);
    for (const int exponent : {-240, -60, 77, 240}) {
      const double factor = std::ldexp(1.0, exponent);
      const PrincipalMoments heavy(c.moments.values() * factor);
      EXPECT_EQ(FreeMotion(heavy, c.omega0_B, c.q0_WB).at(t).q_WB.coeffs(), expected.q_WB.coeffs());
      const RigidBodyState fast = FreeMotion(c.moments, c.omega0_B * factor, c.q0_WB).at(t / factor);
      EXPECT_EQ(fast.q_WB.coeffs(), expected.q_WB.coeffs());
      EXPECT_EQ(fast.omega_W, expected.omega_W * factor);
    }
  }
}

TEST(FreeMotionInvariants, LengthOfTheQuaternionDoesNotMatter) {
  const PrincipalMoments moments({2, 3, 4});
  const Quaterniond q0(0.5, -1, 2, 0.25);
  const RigidBodyState expected = FreeMotion(moments, {.5, .25, 1}, q0).at(3);
  for (const double factor : {0x1p-1000, 0x1p-20, -8.0, 0x1p900}) {
    const Quaterniond scaled(q0.coeffs() * factor);
    EXPECT_EQ(FreeMotion(moments, {.5, .25, 1}, scaled).at(3).q_WB.coeffs(), expected.q_WB.coeffs()) << factor;
  }
}

TEST(FreeMotionInvariants, ABodyAtRestStaysAtRest) {
  const Quaterniond q0(0.5, -1, 2, 0.25);
  const FreeMotion motion(PrincipalMoments({2, 3, 4}), Vector3d::Zero(), q0);
  const RigidBodyState s = motion.at(1e6);
  EXPECT_LE(angleBetween(s.q_WB, q0), 4e-16);
  EXPECT_EQ(s.omega_B, Vector3d::Zero());
  EXPECT_EQ(s.omega_W, Vector3d::Zero());
  EXPECT_EQ(motion.kineticEnergy(), 0);
  EXPECT_EQ(motion.L_W(), Vector3d::Zero());
}

TEST(FreeMotionInvariants, TheSeparatrixEndsOnTheMiddleAxis) {
  const PrincipalMoments moments({1, 2, 2.25});
  const FreeMotion motion(moments, {.75, .5, 1}, Quaterniond::Identity());
  for (const double t : {-1e12, -1e5, -2e3, 2e3, 1e5, 1e12}) {
    const RigidBodyState s = motion.at(t);
    EXPECT_NEAR(s.q_WB.norm(), 1, 4e-16);
    EXPECT_NEAR(s.omega_B[0], 0, 1e-300);
    EXPECT_NEAR(s.omega_B[2], 0, 1e-300);
    // The limit is L/I2, in the past towards -axis 2 because omega_2' = (I3 - I1) omega_3 omega_1/I2 > 0.
    EXPECT_NEAR(s.omega_B[1], std::copysign(1.286953767623375, t), 5e-16);
    EXPECT_LE((s.omega_W - motion.L_W() / 2).norm(), 2e-15);
  }
}

// A wobble far below the rounding of omega must not be lost. It grows about the middle axis, so that each decade
// of the disturbance delays the flip by the same time.
TEST(FreeMotionInvariants, FaintDisturbanceFlipsTheMiddleAxis) {
  const PrincipalMoments moments({1, 2, 3});
  const double lambda = 1 / std::sqrt(3.0);  // sqrt((I3-I2)(I2-I1)/(I1 I3)) omega_2
  double before = 0;
  for (const double disturbance : {1e-20, 1e-40, 1e-60, 1e-80}) {
    const Polhode polhode(moments, {disturbance, 1, 0});
    const double flip = polhode.period() / 2;
    if (before > 0) {
      EXPECT_NEAR(flip - before, 2 * 20 * std::log(10.0) / lambda, 1e-12 * flip);
    }
    before = flip;
    const FreeMotion motion(moments, {disturbance, 1, 0}, Quaterniond::Identity());
    EXPECT_NEAR(motion.at(flip).omega_B[1], -1, 1e-14);
    EXPECT_NEAR(motion.at(2 * flip).omega_B[1], 1, 1e-14);
  }
}

TEST(FreeMotionInvariants, HugeTimesStillGiveARotation) {
  const FreeMotion motion(PrincipalMoments({2, 3, 4}), {.5, .25, 1}, Quaterniond::Identity());
  for (const double t : {1e18, -1e30, 1e100, 1e280}) {
    const RigidBodyState s = motion.at(t);
    EXPECT_NEAR(s.q_WB.norm(), 1, 4e-16) << t;
    EXPECT_NEAR(PrincipalMoments({2, 3, 4}).kineticEnergy(s.omega_B) / motion.kineticEnergy(), 1, 4e-15) << t;
  }
}

TEST(FreeMotionErrors, RejectInvalidStarts) {
  const PrincipalMoments moments({2, 3, 4});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto messageOf = [&](const Vector3d& omega, const Quaterniond& q) -> std::string {
    try {
      FreeMotion(moments, omega, q);
    } catch (const core::Error& error) {
      EXPECT_EQ(error.kind(), core::ErrorKind::kPhysics);
      return error.message();
    }
    return "accepted";
  };
  EXPECT_EQ(messageOf({1, nan, 0}, Quaterniond::Identity()),
            "angular velocity must be finite, got (1, nan, 0) rad/s");
  EXPECT_EQ(messageOf({1, 2, 3}, Quaterniond(0, 0, 0, 0)),
            "orientation must be a nonzero, finite quaternion, got (0, 0, 0, 0)");
  EXPECT_EQ(messageOf({1, 2, 3}, Quaterniond(1, nan, 0, 0)),
            "orientation must be a nonzero, finite quaternion, got (1, nan, 0, 0)");
  EXPECT_THROW(FreeMotion(PrincipalMoments({1e-25, 1, 1}), {1, 1, 1}, Quaterniond::Identity()), core::Error);
}

}  // namespace
}  // namespace poinsot::physics
