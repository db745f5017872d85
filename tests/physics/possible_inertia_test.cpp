// SPDX-License-Identifier: Apache-2.0
// Oracles: Moreau's conditions (1962) for the projection y of x onto a closed convex cone, (x - y)·y = 0 and
// (x - y)·g <= 0 for every edge g of the cone; and random possible bodies, which must not be nearer.
#include "physics/possible_inertia.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <limits>

#include "physics/principal_axes.h"
#include "physics/random_bodies.h"

namespace poinsot::physics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Worked by hand: (1, 2, 4) violates the inequality by 1; each moment changes by a third of that. (-1, 1, 1) and
// (-3, 1, 3) lie nearest to the edge (0, 1, 1), whose least moment becomes a millionth of the others.
TEST(NearestPossibleMoments, MatchesHandComputedExamples) {
  EXPECT_LE((*nearestPossibleMoments({1, 2, 4}) - Vector3d(4, 7, 11) / 3).norm(), 1e-15);
  EXPECT_LE((*nearestPossibleMoments({4, 1, 2}) - Vector3d(11, 4, 7) / 3).norm(), 1e-15);
  EXPECT_EQ(*nearestPossibleMoments({1, -1, 1}), Vector3d(1, 1e-6, 1));
  EXPECT_EQ(*nearestPossibleMoments({-3, 1, 3}), Vector3d(2e-6, 2, 2));
  EXPECT_EQ(*nearestPossibleMoments({2, 3, 4}), Vector3d(2, 3, 4));
  EXPECT_EQ(*nearestPossibleMoments({1, 2, 3}), Vector3d(1, 2, 3));
}

TEST(NearestPossibleMoments, AreAbsentForNegativeZeroAndNaN) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(nearestPossibleMoments({-1, -2, -3}));
  EXPECT_FALSE(nearestPossibleMoments({0, 0, 0}));
  EXPECT_FALSE(nearestPossibleMoments({1, nan, 1}));
  EXPECT_FALSE(nearestPossibleTensor(-Matrix3d::Identity()));
}

Matrix3d randomSymmetric(Draw& draw, double size) {
  Matrix3d m;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j <= i; ++j) m(i, j) = m(j, i) = size * draw.between(i == j ? -0.5 : -1, 1);
  return m;
}

/// Returns a possible tensor in any axes, about as large as `size`.
Matrix3d randomPossible(Draw& draw, double size) {
  const Vector3d p(draw.unit(), draw.unit(), draw.unit());
  const Matrix3d R = draw.attitude().toRotationMatrix();
  return size * R * (p.sum() * Matrix3d::Identity() - Matrix3d(p.asDiagonal())) * R.transpose();
}

// Measured: 2.3e-16 for both conditions, without vectors whose least moment is raised to a millionth.
TEST(NearestPossibleMoments, FulfilTheConditionsOfTheProjection) {
  Draw draw(71);
  for (int i = 0; i < 1000; ++i) {
    const double size = draw.decade(-50, 50);
    const Vector3d x = Vector3d(draw.between(-0.5, 1), draw.between(-0.5, 1), draw.between(-0.5, 1));
    const auto nearest = nearestPossibleMoments(size * x);
    if (!nearest) continue;
    const Vector3d y = *nearest / size, change = x - y;
    EXPECT_NO_THROW(PrincipalMoments{*nearest});
    const bool raised = y.minCoeff() <= 2 * kLeastOfNearest * y.maxCoeff();
    const double tolerance = raised ? 1e-5 : 2e-15;
    EXPECT_LE(std::abs(change.dot(y)), tolerance);
    for (const Vector3d& edge : {Vector3d(0, 1, 1), Vector3d(1, 0, 1), Vector3d(1, 1, 0)})
      EXPECT_LE(change.dot(edge), tolerance);
  }
}

// The edges of the cone of tensors are thin rods, 1 - n nᵀ, so that the second condition is tr D <= the least
// eigenvalue of D. Measured: 9.5e-16 and 4.5e-16.
TEST(NearestPossibleTensor, FulfilsTheConditionsOfTheProjection) {
  Draw draw(72);
  int projected = 0;
  for (int i = 0; i < 1000; ++i) {
    const double size = draw.decade(-50, 50);
    const Matrix3d x = randomSymmetric(draw, 1);
    const auto nearest = nearestPossibleTensor(size * x);
    if (!nearest) continue;
    const Matrix3d y = *nearest / size, change = x - y;
    EXPECT_EQ(*nearest, nearest->transpose());
    const Vector3d moments = PrincipalAxes(*nearest).moments().values() / size;
    const bool raised = moments.minCoeff() <= 2 * kLeastOfNearest * moments.maxCoeff();
    const double tolerance = raised ? 1e-5 : 1e-14;
    EXPECT_LE(std::abs(change.cwiseProduct(y).sum()), tolerance);
    const double least = Eigen::SelfAdjointEigenSolver<Matrix3d>(change).eigenvalues()[0];
    EXPECT_LE(change.trace() - least, tolerance);
    projected += change.norm() > 1e-9;
  }
  EXPECT_GT(projected, 500);
}

// Measured: the nearest other tensor is farther by 1.3e-9 of the distance. The bound allows raised least moments.
TEST(NearestPossibleTensor, IsNoFartherThanOtherPossibleTensors) {
  Draw draw(73);
  for (int i = 0; i < 100; ++i) {
    const Matrix3d x = randomSymmetric(draw, 1);
    const auto nearest = nearestPossibleTensor(x);
    if (!nearest) continue;
    const double distance = (x - *nearest).norm();
    for (int k = 0; k < 500; ++k) {
      const Matrix3d other = randomPossible(draw, draw.decade(-2, 0.5));
      EXPECT_GE((x - other).norm(), distance * (1 - 1e-5));
      // A mixture of two possible bodies is possible, so that this gives neighbours of the result.
      const double part = draw.decade(-6, 0);
      EXPECT_GE((x - ((1 - part) * *nearest + part * other)).norm(), distance * (1 - 1e-5));
    }
  }
}

TEST(NearestPossibleTensor, EqualsATensorThatIsPossible) {
  Draw draw(74);
  for (int i = 0; i < 200; ++i) {
    const Matrix3d x = randomPossible(draw, 1) + 1e-3 * Matrix3d::Identity();
    EXPECT_LE((*nearestPossibleTensor(x) - x).norm(), 5e-16 * x.norm());  // measured 1.4e-16
  }
}

}  // namespace
}  // namespace poinsot::physics
