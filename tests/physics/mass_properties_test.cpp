// SPDX-License-Identifier: Apache-2.0
#include "physics/mass_properties.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "physics/five_masses.h"
#include "physics/inertia_tensor.h"
#include "physics/mass_testing.h"
#include "physics/random_bodies.h"
#include "physics/residual.h"

namespace poinsot::physics {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

Matrix3d symmetric(double xx, double yy, double zz, double xy, double xz, double yz) {
  return Matrix3d{{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}};
}

std::vector<MassProperties> points(const std::vector<Particle>& particles) {
  std::vector<MassProperties> result;
  for (const Particle& p : particles) result.push_back(MassProperties::ofPoint(p.mass_kg, p.position_W));
  return result;
}

// Tensors of five masses whose numbers are exact in binary, computed apart from the code.
const Matrix3d kAboutOrigin = symmetric(8.560546875, 8.654296875, 9.3046875, -0.24609375, 1.01953125, 2.1796875);
const Matrix3d kAboutCentre =
    symmetric(8.5045166015625, 7.9420166015625, 8.54296875, -0.052734375, 1.06787109375, 2.19287109375);

TEST(MassProperties, ObeyEquations3And7ForFiveMasses) {
  const MassProperties body = combined(points(FiveMasses().particles));
  EXPECT_EQ(body.mass_kg(), 6);
  EXPECT_EQ(body.centre_B(), Vector3d(0.34375, 0.09375, 0.0234375));
  EXPECT_EQ(body.inertia_B(), kAboutCentre);
  EXPECT_EQ(body.inertiaAbout(Vector3d::Zero()), kAboutOrigin);
}

TEST(MassProperties, ObeyEquation14AboutAnyPoint) {
  const MassProperties body = combined(points(FiveMasses().particles));
  const ParticleSystem particles = FiveMasses().flying();  // sums over the particles themselves
  Draw draw(31);
  double residual = 0;
  for (int i = 0; i < 200; ++i) {
    const Vector3d point = 3 * draw.direction();
    residual = std::max(residual, relative(body.inertiaAbout(point), particles.inertiaAbout(point)));
  }
  expectResidual("displaced axis", residual, 1e-15);  // measured 2.8e-16
}

// The tensor of particles about a point is taken back to their centre.
TEST(MassProperties, AreRecoveredFromTheInertiaAboutAnyPoint) {
  const ParticleSystem particles = FiveMasses().flying();
  Draw draw(34);
  double residual = 0;
  for (int i = 0; i < 200; ++i) {
    const Vector3d point = 3 * draw.direction();
    const MassProperties body =
        MassProperties::fromInertiaAbout(point, 6, particles.centre_W(), particles.inertiaAbout(point));
    residual = std::max(residual, relative(body.inertia_B(), kAboutCentre));
  }
  expectResidual("displaced axis taken away", residual, 1e-14);  // measured 2.7e-15
  EXPECT_EQ(MassProperties::fromInertiaAbout({0, 0, 0}, 6, particles.centre_W(), kAboutOrigin).inertia_B(),
            kAboutCentre);
}

// The result must be possible for matter. A lamina, whose moments obey an equality, may differ by rounding.
TEST(MassProperties, RejectAnImpossibleInertiaAboutAPoint) {
  const auto left = [](double along, double far) {
    return MassProperties::fromInertiaAbout({0, 0, far}, 2, {0, 0, 0},
                                            Vector3d(2 * far * far + 1, 2 * far * far + 1, along).asDiagonal());
  };
  EXPECT_NO_THROW(left(2, 0.3));     // a disc
  EXPECT_NO_THROW(left(2, 1000.1));  // 2e6 kg m² are rounded to 2e-10
  EXPECT_THROW(left(2.001, 0.3), core::Error);
  EXPECT_THROW(MassProperties::fromInertiaAbout({0, 0, 1}, 2, {0, 0, 0}, Vector3d(1.5, 1.5, 0.25).asDiagonal()),
               core::Error);
}

TEST(MassProperties, ObeyEquation14ForACone) {
  const MassProperties cone = massProperties(Cone{.45, 1.7}, 1);
  EXPECT_NEAR(cone.inertiaAbout({0, 0, .75 * 1.7})(0, 0), 1.764375, 4e-16);  // about its apex
}

TEST(MassProperties, ObeyEquation16WhenTheBodyTurns) {
  Draw draw(32);
  double residual = 0, back = 0, invariants = 0;
  for (int i = 0; i < 300; ++i) {
    const Quaterniond q = draw.attitude();
    const Vector3d offset = draw.direction() * draw.decade(-2, 1);
    std::vector<Particle> moved = FiveMasses().particles;
    for (Particle& p : moved) p.position_W = q.toRotationMatrix() * p.position_W + offset;
    const MassProperties body = combined(points(FiveMasses().particles)), turned = body.moved(q, offset);
    residual = std::max(residual, relative(turned.inertia_B(), combined(points(moved)).inertia_B()));
    EXPECT_LE((turned.centre_B() - combined(points(moved)).centre_B()).norm(), 4e-15);
    const Matrix3d& I = turned.inertia_B();
    EXPECT_EQ(I, I.transpose());
    invariants =
        std::max({invariants, std::abs(I.trace() / 24.989501953125 - 1),
                  std::abs(I.determinant() / 526.794909412391 - 1), std::abs(I.norm() / kAboutCentre.norm() - 1)});
    back = std::max(
        back,
        relative(turned.moved(Quaterniond::Identity(), -offset).moved(q.conjugate(), Vector3d::Zero()).inertia_B(),
                 kAboutCentre));
  }
  expectResidual("tensor of the turned masses", residual,
                 5e-15);  // measured 9.6e-16, because positions are rounded
  expectResidual("trace, determinant, norm", invariants, 4e-15);  // measured 1.3e-15: 15 digits given
  expectResidual("there and back", back, 1e-15);                  // measured 1e-16
}

TEST(MassProperties, QuarterTurnsAreExact) {
  const MassProperties box = massProperties(Box{{1.2, .9, .5}}, 1);
  const Vector3d I = box.inertia_B().diagonal();
  const double h = std::sqrt(.5);
  EXPECT_EQ(box.moved(Quaterniond(h, h, 0, 0), {0, 0, 0}).inertia_B(),
            Matrix3d(Vector3d(I[0], I[2], I[1]).asDiagonal()));
  EXPECT_EQ(box.moved(Quaterniond(h, 0, -h, 0), {0, 0, 0}).inertia_B(),
            Matrix3d(Vector3d(I[2], I[1], I[0]).asDiagonal()));
  EXPECT_EQ(box.moved(Quaterniond(h, 0, 0, h), {0, 0, 0}).inertia_B(),
            Matrix3d(Vector3d(I[1], I[0], I[2]).asDiagonal()));
  EXPECT_EQ(massProperties(Hemisphere{8}, 1).moved(Quaterniond(h, h, 0, 0), {0, 0, 0}).centre_B(),
            Vector3d(0, -3, 0));
}

TEST(MassProperties, PartsOfABoxAddUpToTheBox) {
  Draw draw(33);
  double inertia = 0, centre = 0;
  for (int i = 0; i < 200; ++i) {
    const Vector3d edges(draw.between(.1, 2), draw.between(.1, 2), draw.between(.1, 2));
    const MassProperties whole = massProperties(Box{edges}, edges.prod());
    std::vector<MassProperties> parts;
    const Vector3d cut =
        edges.cwiseProduct(Vector3d(draw.unit(), draw.unit(), draw.unit()) * .9 + Vector3d::Constant(.05));
    for (int octant = 0; octant < 8; ++octant) {
      Vector3d size, middle;
      for (int axis = 0; axis < 3; ++axis) {
        const bool high = octant >> axis & 1;
        size[axis] = high ? edges[axis] - cut[axis] : cut[axis];
        middle[axis] = (high ? cut[axis] + edges[axis] : cut[axis]) / 2 - edges[axis] / 2;
      }
      parts.push_back(massProperties(Box{size}, size.prod()).moved(Quaterniond::Identity(), middle));
    }
    const MassProperties sum = combined(parts);
    inertia = std::max(inertia, relative(sum.inertia_B(), whole.inertia_B()));
    centre = std::max(centre, sum.centre_B().norm());
    MassProperties oneByOne = parts[0];
    for (std::size_t k = 1; k < parts.size(); ++k) oneByOne = oneByOne + parts[k];
    EXPECT_LE(relative(oneByOne.inertia_B(), sum.inertia_B()), 3e-15);
  }
  expectResidual("inertia", inertia, 2e-15);  // measured 4.1e-16
  expectResidual("centre", centre, 2e-15);    // measured 1.1e-16
}

TEST(MassProperties, SymmetricArrangementsAreSymmetricToTheLastBit) {
  std::vector<MassProperties> ring;
  for (const double x : {.1, -.1})
    for (const double y : {.7, -.7})
      for (const double z : {1.3, -1.3}) ring.push_back(MassProperties::ofPoint(.3, {x, y, z}));
  const MassProperties body = combined(ring);
  EXPECT_EQ(body.centre_B(), Vector3d::Zero());
  EXPECT_TRUE(body.inertia_B().isDiagonal(0));
}

TEST(MassProperties, PointHasNoInertiaAndSumOfOneIsUnchanged) {
  const MassProperties point = MassProperties::ofPoint(2, {1, 2, 3});
  EXPECT_EQ(point.inertia_B(), Matrix3d::Zero());
  EXPECT_EQ(point.inertiaAbout({1, 2, 0}), Matrix3d(Vector3d(18, 18, 0).asDiagonal()));
  const MassProperties one = combined({point});
  EXPECT_EQ(one.centre_B(), point.centre_B());
  EXPECT_EQ(one.inertia_B(), point.inertia_B());
  EXPECT_THROW(combined({}), std::logic_error);
}

std::string verdict(double mass_kg, const Vector3d& centre_B, const Matrix3d& inertia_B) {
  return refusal([&] { MassProperties(mass_kg, centre_B, inertia_B); });
}

TEST(MassProperties, RejectImpossibleMassCentreAndInertia) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const Vector3d origin = Vector3d::Zero();
  const Matrix3d I = Matrix3d::Identity();
  EXPECT_EQ(verdict(0, origin, I), "mass must be positive and finite, got 0");
  EXPECT_EQ(verdict(-1, origin, I), "mass must be positive and finite, got -1");
  EXPECT_EQ(verdict(inf, origin, I), "mass must be positive and finite, got inf");
  EXPECT_EQ(verdict(1, {0, nan, 0}, I), "centre of mass must be finite, got (0, nan, 0) m");
  EXPECT_EQ(verdict(1, origin, symmetric(1, 1, 1, 0, 0, nan)),
            "inertia tensor must be finite, got I_yz = nan kg·m²");
  EXPECT_EQ(verdict(1, origin, Matrix3d{{1, .5, 0}, {.25, 1, 0}, {0, 0, 1}}),
            "inertia tensor must be symmetric, got I_xy = 0.5 and I_yx = 0.25 kg·m²");
  EXPECT_EQ(verdict(1, origin, symmetric(-1, 1, 1, 0, 0, 0)),
            "moments of inertia must not be negative, got principal moments (-1, 1, 1) kg·m²");
  EXPECT_EQ(verdict(1, origin, symmetric(1, 1, 1, 2, 0, 0)),
            "moments of inertia must not be negative, got principal moments (-1, 1, 3) kg·m²");
  EXPECT_EQ(verdict(1, origin, symmetric(1, 2, 4, 0, 0, 0)),
            "no moment may exceed the sum of the other two (no body has these values), got principal moments (1, "
            "2, 4) kg·m²");
}

TEST(MassProperties, AcceptLaminaeAndRodsDespiteRounding) {
  const Vector3d origin = Vector3d::Zero();
  EXPECT_EQ(verdict(1, origin, symmetric(.1, .2, .30000000000000004, 0, 0, 0)), "accepted");  // a lamina
  EXPECT_EQ(verdict(1, origin, symmetric(-1e-18, 1, 1, 0, 0, 0)), "accepted");                // a rod
  Draw draw(34);
  for (int i = 0; i < 200; ++i) {
    const Quaterniond q = draw.attitude();
    EXPECT_NO_THROW(massProperties(Rod{draw.decade(-3, 3)}, draw.decade(-3, 3)).moved(q, origin));
    EXPECT_NO_THROW(massProperties(Disc{draw.decade(-3, 3)}, draw.decade(-3, 3)).moved(q, origin));
  }
}

TEST(MassProperties, RefusesPointsThatAreTooFarAway) {
  const MassProperties ball = massProperties(Sphere{.radius_m = 1}, 1);
  const std::string beyond = "the inertia about (1e+200, 0, 0) m is beyond the range of numbers";
  EXPECT_EQ(refusal([&] { ball.inertiaAbout({1e200, 0, 0}); }), beyond);
  for (const double bad : {NAN, INFINITY}) EXPECT_NE(refusal([&] { ball.inertiaAbout({0, bad, 0}); }), "accepted");
  // M a² across the line to the point hides the ball's own moment of 0.4.
  EXPECT_EQ(ball.inertiaAbout({1e150, 0, 0})(1, 1), 1e150 * 1e150);
}

TEST(MassProperties, RejectAQuaternionThatIsNoRotation) {
  const Vector3d origin = Vector3d::Zero();
  const Quaternion none(0, 0, 0, 0), notANumber(1, NAN, 0, 0);
  const std::string zero = "a rotation must be a nonzero, finite quaternion, got (0, 0, 0, 0)";
  const MassProperties box = massProperties(Box{{1, 2, 3}}, 1);
  EXPECT_EQ(refusal([&] { box.moved(none, origin); }), zero);
  EXPECT_EQ(refusal([&] { box.moved(notANumber, origin); }),
            "a rotation must be a nonzero, finite quaternion, got (1, nan, 0, 0)");
  EXPECT_EQ(refusal([&] { massProperties(SolidPart{Box{{1, 2, 3}}, 1, none}); }), zero);
  EXPECT_EQ(refusal([&] { turnedVector(none, {1, 2, 3}); }), zero);
  EXPECT_EQ(refusal([&] { turnedTensor(none, box.inertia_B()); }), zero);
}

TEST(TurnedTensor, AcceptsQuaternionsOfAnyLength) {
  // Scaling by a power of two is exact, so that the bits of the result must not change.
  const Quaternion q(1, 2, -3, 4);
  const Eigen::Matrix3d inertia_B = massProperties(Box{{1, 2, 3}}, 1).inertia_B(),
                        expected = turnedTensor(q, inertia_B);
  for (const int exponent : {-1074, -600, 600, 1021}) {
    const Quaternion scaled(q.coeffs() * std::ldexp(1.0, exponent));
    EXPECT_EQ(turnedTensor(scaled, inertia_B), expected) << exponent;
  }
}

}  // namespace
}  // namespace poinsot::physics
