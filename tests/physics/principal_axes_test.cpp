// SPDX-License-Identifier: Apache-2.0
#include "physics/principal_axes.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <limits>
#include <string>

#include "physics/inertia_tensor.h"
#include "physics/mass_testing.h"
#include "physics/random_bodies.h"
#include "physics/residual.h"
#include "physics/symmetric_eigen.h"

namespace poinsot::physics {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

using Real =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<60>, boost::multiprecision::et_off>;

Matrix3d diagonal(const Vector3d& moments) { return moments.asDiagonal(); }

/// Returns moments of the kind that `i` chooses: any, nearly equal or very small ones.
Vector3d hostileMoments(Draw& draw, int i) {
  const double gap = i % 3 == 1 ? draw.decade(-16, -2) : draw.unit();
  const double low = i % 3 == 2 ? draw.decade(-12, 0) : draw.between(.02, 1);
  const double middle = 1 + gap * draw.unit();
  return Vector3d(low, middle, std::max(low, middle) + gap * std::min(low, middle) * draw.unit()) *
         draw.decade(-20, 20);
}

// Expected moments are computed apart from the code.
TEST(PrincipalAxes, ObeyEquation17ForFiveMasses) {
  const Matrix3d I{{8.5045166015625, -0.052734375, 1.06787109375},
                   {-0.052734375, 7.9420166015625, 2.19287109375},
                   {1.06787109375, 2.19287109375, 8.54296875}};
  const PrincipalAxes axes(I);
  const Vector3d expected(5.81442745032073, 8.43882837573168, 10.7362461270726);
  expectResidual("moments", (axes.moments().values() - expected).cwiseQuotient(expected).cwiseAbs().maxCoeff(),
                 4e-15);  // measured 7.6e-16: 15 digits given
  EXPECT_FALSE(axes.aligned());
  EXPECT_NEAR(axes.q_BP().toRotationMatrix().determinant(), 1, 4e-16);
  expectResidual("rebuilt", relative(axes.inertia_B(), I), 5e-16);  // measured 5.2e-17
}

// Checked in 60 digits, A v = lambda v and v_i v_j = delta_ij hold far below a rounding of a double.
TEST(SymmetricEigen, HasTinyResidualsIn60Digits) {
  Draw draw(41);
  const auto real = [](const DoubleDouble& a) { return Real(a.hi) + Real(a.lo); };
  Real equation = 0, orthonormal = 0;
  for (int i = 0; i < 600; ++i) {
    const Matrix3d A = turnedTensor(draw.attitude(), diagonal(hostileMoments(draw, i)));
    const SymmetricEigen eigen = symmetricEigen(A);
    const Real largest = A.cwiseAbs().maxCoeff();
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t row = 0; row < 3; ++row) {
        Real sum = -real(eigen.values[k]) * real(eigen.vectors[k][row]), dot = k == row ? -1 : 0;
        for (std::size_t j = 0; j < 3; ++j) {
          sum += Real(A(static_cast<int>(row), static_cast<int>(j))) * real(eigen.vectors[k][j]);
          dot += real(eigen.vectors[k][j]) * real(eigen.vectors[row][j]);
        }
        equation = std::max(equation, Real(abs(sum) / largest));
        orthonormal = std::max(orthonormal, Real(abs(dot)));
      }
  }
  expectResidual("A v - lambda v", static_cast<double>(equation), 2e-30);     // measured 3.1e-32
  expectResidual("orthonormality", static_cast<double>(orthonormal), 2e-30);  // measured 1.6e-31
}

TEST(PrincipalAxes, RebuildTheTensorOfAnyBody) {
  Draw draw(42);
  double rebuilt = 0, moments = 0, unit = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vector3d given = hostileMoments(draw, i);
    const Matrix3d I = turnedTensor(draw.attitude(), diagonal(given));
    const PrincipalAxes axes(I);
    const Vector3d found = axes.moments().values();
    rebuilt = std::max(rebuilt, relative(axes.inertia_B(), I));
    moments = std::max(moments, ((found - given).cwiseAbs() / given.maxCoeff()).maxCoeff());
    EXPECT_LE(found[0], found[1]);
    EXPECT_LE(found[1], found[2]);
    unit = std::max(unit, std::abs(axes.q_BP().norm() - 1));
  }
  expectResidual("tensor rebuilt", rebuilt, 2e-15);           // measured 8.7e-16
  expectResidual("moments, of the largest", moments, 2e-15);  // measured 8.7e-16
  expectResidual("unit quaternion", unit, 5e-16);             // measured 2.2e-16
}

TEST(PrincipalAxes, RoundTripVectorsBetweenAxes) {
  Draw draw(43);
  for (int i = 0; i < 200; ++i) {
    const PrincipalAxes axes(turnedTensor(draw.attitude(), diagonal(draw.moments().values())));
    const Vector3d v = draw.direction();
    EXPECT_LE((axes.toB(axes.toP(v)) - v).norm(), 1e-15);
    EXPECT_LE((axes.angularVelocity(axes.angularMomentum(v)) - v).norm(), 2e-14);  // conditioned by the moments
    EXPECT_LE((axes.angularMomentum(v) - axes.inertia_B() * v).norm(), 2e-15);
  }
}

// A vector along a principal axis has no component along the others by definition, for any axes B. A component of
// 20 units in the last place is more than rounding and stays.
TEST(PrincipalAxes, ComponentsOfAVectorAlongAnAxisAreExact) {
  Draw draw(45);
  for (int i = 0; i < 100000; ++i) {
    const PrincipalAxes axes(draw.moments(), draw.attitude());
    const double size = draw.decade(-8, 8) * draw.sign();
    const Vector3d along = axes.toP(axes.toB(size * Vector3d::Unit(i % 3)));
    EXPECT_EQ(along[(i + 1) % 3], 0);
    EXPECT_EQ(along[(i + 2) % 3], 0);
    EXPECT_NEAR(along[i % 3] / size, 1, 1e-14);  // measured 2.2e-15
    Vector3d leaning = Vector3d::Unit(i % 3);
    leaning[(i + 1) % 3] = 20 * std::numeric_limits<double>::epsilon();
    EXPECT_NE(axes.toP(axes.toB(leaning))[(i + 1) % 3], 0);
  }
}

// For three different moments, the nearest to B of the four proper frames is at most 120 degrees away.
TEST(PrincipalAxes, AreTheNearestAxesToTheBodyAxes) {
  Draw draw(44);
  for (int i = 0; i < 300; ++i) {
    const PrincipalAxes axes(turnedTensor(draw.attitude(), diagonal({1, 2, 2.5})));
    const Quaterniond& q = axes.q_BP();
    EXPECT_GE(q.w(), q.vec().cwiseAbs().maxCoeff() - 1e-15);
  }
}

TEST(PrincipalAxes, ADiagonalTensorKeepsAxesAndMomentsBitForBit) {
  Draw draw(45);
  for (int i = 0; i < 200; ++i) {
    Vector3d moments = draw.moments().values() * draw.decade(-46, 23);
    const PrincipalAxes axes(diagonal(moments));
    EXPECT_TRUE(axes.aligned());
    EXPECT_EQ(axes.moments().values(), moments);  // in the order given
    EXPECT_EQ(axes.inertia_B(), diagonal(moments));
  }
}

TEST(PrincipalAxes, RoundingErrorsOffTheDiagonalTurnNoAxis) {
  Matrix3d I = diagonal({3, 1, 2.5});
  I(0, 1) = I(1, 0) = 1e-16;
  I(1, 2) = I(2, 1) = -3e-16;
  const PrincipalAxes axes(I);
  EXPECT_TRUE(axes.aligned());
  EXPECT_EQ(axes.moments().values(), Vector3d(3, 1, 2.5));
}

TEST(PrincipalAxes, SphericalBodiesKeepTheBodyAxes) {
  Draw draw(46);
  for (int i = 0; i < 300; ++i) {
    const double I = draw.decade(-9, 9);
    const PrincipalAxes sphere(turnedTensor(draw.attitude(), diagonal({I, I, I})));
    EXPECT_TRUE(sphere.aligned());
    EXPECT_EQ(sphere.moments()[0], sphere.moments()[1]);
    EXPECT_EQ(sphere.moments()[1], sphere.moments()[2]);
    Matrix3d noisy = diagonal({I, I, I});
    for (int k = 0; k < 9; ++k) noisy(k % 3, k / 3) += I * 1e-16 * draw.between(-1, 1);
    EXPECT_TRUE(PrincipalAxes(noisy).aligned());
  }
}

TEST(PrincipalAxes, ASymmetricTopHasItsAxisAndEqualMoments) {
  Draw draw(47);
  double direction = 0;
  for (int i = 0; i < 300; ++i) {
    const double ratio = draw.between(.1, 1.9);
    const Quaterniond q = draw.attitude();
    const PrincipalAxes axes(turnedTensor(q, diagonal({1, 1, ratio})));
    const int k = ratio < 1 ? 0 : 2;  // where the axis stands among ascending moments
    EXPECT_EQ(axes.moments()[k == 0 ? 1 : 0], axes.moments()[k == 0 ? 2 : 1]);
    const Vector3d axis_B = axes.toB(Vector3d::Unit(k)), given_B = q.toRotationMatrix().col(2);
    direction = std::max(direction, axis_B.cross(given_B).norm() * std::abs(ratio - 1));
    EXPECT_NEAR(axes.q_BP().vec()[k], 0, 1e-15);  // the shortest turn: none about the axis itself
    EXPECT_GE(axis_B[k], 0);
  }
  expectResidual("axis, times the gap", direction, 2e-15);  // measured 3e-16
}

// Moments 1 and 1 + gap must have the axes of the exact doubles if the gap is more than rounding.
TEST(PrincipalAxes, NearlyEqualMomentsHaveTheirOwnAxes) {
  Draw draw(48);
  for (const double gap : {1e-4, 1e-8, 1e-11, 1e-13}) {
    const Quaterniond q = draw.attitude();
    const Matrix3d I = turnedTensor(q, diagonal({1, 1 + gap, 1.5}));
    const PrincipalAxes axes(I);
    EXPECT_LT(axes.moments()[0], axes.moments()[1]) << gap;
    EXPECT_NEAR((axes.moments()[1] - axes.moments()[0]) / gap, 1, 5e-16 / gap) << gap;
    const Vector3d first_B = axes.toB(Vector3d::UnitX());
    EXPECT_LE(first_B.cross(q.toRotationMatrix().col(0)).norm(), 5e-16 / gap) << gap;  // the tensor is rounded
  }
  const PrincipalAxes equal(turnedTensor(draw.attitude(), diagonal({1, 1 + 4e-16, 1.5})));
  EXPECT_EQ(equal.moments()[0], equal.moments()[1]);
}

std::string verdict(const Matrix3d& I) {
  return refusal([&] { PrincipalAxes axes(I); });
}

TEST(PrincipalAxes, RejectImpossibleTensors) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(verdict(diagonal({1, 1, inf})), "inertia tensor must be finite, got I_zz = inf kg·m²");
  EXPECT_EQ(verdict(Matrix3d{{2, 0, .1}, {0, 2, 0}, {.2, 0, 2}}),
            "inertia tensor must be symmetric, got I_xz = 0.1 and I_zx = 0.2 kg·m²");
  EXPECT_EQ(verdict(diagonal({1, -1, 1})), "principal moments must be positive, got (1, -1, 1) kg·m²");
  EXPECT_EQ(verdict(Matrix3d::Zero()), "principal moments must be positive, got (0, 0, 0) kg·m²");
  EXPECT_EQ(verdict(Matrix3d{{1, 2, 0}, {2, 1, 0}, {0, 0, 1}}),
            "principal moments must be positive, got (-1, 1, 3) kg·m²");
  EXPECT_EQ(verdict(Matrix3d{{5, 1, 0}, {1, 5, 0}, {0, 0, 1}}),
            "no moment may exceed the sum of the other two (a solid body cannot have these values), got "
            "(1, 4, 6) kg·m²");
  EXPECT_EQ(verdict(diagonal({0, 1, 1})), "principal moments must be positive, got (0, 1, 1) kg·m²");  // a rod
}

TEST(PrincipalAxes, RejectARodInAnyDirection) {
  Draw draw(49);
  for (int i = 0; i < 300; ++i)
    EXPECT_EQ(verdict(turnedTensor(draw.attitude(), diagonal({0, 1, 1}))).substr(0, 34),
              "principal moments must be positive");
  EXPECT_EQ(verdict(Matrix3d{{1e-17, 1e-17, 0}, {1e-17, 1, 0}, {0, 0, 1}}),
            "principal moments must be positive; the least of (1e-17, 1, 1) kg·m² is only a rounding error: "
            "matter on one line has no moment about that line; add another part, or give the body an extent");
}

TEST(PrincipalAxes, RemoveAsymmetryCausedByRounding) {
  Matrix3d I{{2, .25, 0}, {.25, 3, 0}, {0, 0, 4}};
  I(0, 1) += 1e-14;
  EXPECT_EQ(verdict(I), "accepted");
  EXPECT_EQ(PrincipalAxes(I).inertia_B(), PrincipalAxes(I).inertia_B().transpose());
}

TEST(PrincipalAxes, ThrowALogicErrorForANonUnitQuaternion) {
  EXPECT_THROW(PrincipalAxes(PrincipalMoments({1, 1, 1}), Quaterniond(1, 1, 0, 0)), std::logic_error);
}

}  // namespace
}  // namespace poinsot::physics
