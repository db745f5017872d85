// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "core/error.h"
#include "physics/principal_moments.h"
#include "physics/residual.h"
#include "physics/shape_inertia.h"

namespace poinsot::physics {
namespace {

using Eigen::Vector3d;

std::string refusal(const std::function<void()>& make) {
  try {
    make();
  } catch (const core::Error& error) {
    EXPECT_EQ(error.kind(), core::ErrorKind::kPhysics);
    return error.message();
  }
  return "accepted";
}

TEST(PrincipalMoments, AcceptsWhatABodyCanHave) {
  EXPECT_EQ(PrincipalMoments({3, 1, 2}).values(), Vector3d(3, 1, 2));  // a lamina
  EXPECT_EQ(PrincipalMoments({0.1, 0.2, 0.30000000000000004}).values()[2], 0.1 + 0.2);
  EXPECT_EQ(PrincipalMoments({1e300, 1e300, 1e300})[1], 1e300);
}

TEST(PrincipalMoments, RefusesWhatNoBodyHas) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal([] {
              PrincipalMoments({0.9, 0.2, 0.1});
            }),
            "no moment may exceed the sum of the other two (a solid body cannot have these values), got "
            "(0.9, 0.2, 0.1) kg·m²");
  EXPECT_EQ(refusal([] {
              PrincipalMoments({1, 0, 1});
            }),
            "principal moments must be positive, got (1, 0, 1) kg·m²");
  EXPECT_EQ(refusal([&] {
              PrincipalMoments({1, nan, 1});
            }),
            "principal moments must be finite, got (1, nan, 1) kg·m²");
}

TEST(PrincipalMoments, MomentumAndEnergy) {
  const PrincipalMoments moments({2, 3, 4});
  EXPECT_EQ(moments.angularMomentum({.5, .25, 1}), Vector3d(1, .75, 4));
  EXPECT_EQ(moments.kineticEnergy({.5, .25, 1}), 2.34375);  // (0.5 + 0.1875 + 4)/2
}

void expectMoments(const PrincipalMoments& moments, const Vector3d& expected) {
  EXPECT_LE((moments.values() - expected).cwiseQuotient(expected).cwiseAbs().maxCoeff(),
            2e-15);  // 15 digits given
}

// Values of the project's table of inertias, computed apart from the code.
TEST(ShapeInertia, TableOfBodies) {
  expectMoments(solidEllipsoidMoments(1, {1.3, .8, .5}), {0.178, 0.388, 0.466});
  expectMoments(solidBoxMoments(1, {.205, .135, .03}), {0.00159375, 0.00357708333333333, 0.00502083333333333});
  expectMoments(solidCylinderMoments(1, .45, 1.7), {0.291458333333333, 0.291458333333333, 0.10125});
  expectMoments(racketMoments(0.33, .42 + .26, .26), {0.0014365, 0.0133167424242424, 0.0147532424242424});
}

TEST(ShapeInertia, MassIsAFactor) {
  expectMoments(solidBoxMoments(12, {1, 2, 3}), {13, 10, 5});
  expectMoments(racketMoments(0.66, .68, .26), Vector3d(0.0014365, 0.0133167424242424, 0.0147532424242424) * 2);
}

/// Moments of a body by summing cells of its bounding box: slow, coarse and independent of every formula.
Vector3d summed(const Vector3d& extent, int cells, const std::function<bool(const Vector3d&)>& inside) {
  Vector3d moments = Vector3d::Zero();
  int count = 0;
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j)
      for (int k = 0; k < cells; ++k) {
        const Vector3d r = extent.cwiseProduct(Vector3d(i + .5, j + .5, k + .5) / cells - Vector3d::Constant(.5));
        if (!inside(r)) continue;
        moments += Vector3d::Constant(r.squaredNorm()) - r.cwiseAbs2();
        ++count;
      }
  return moments / count;
}

TEST(ShapeInertia, AgreesWithASumOverCells) {
  const auto near = [](const PrincipalMoments& moments, const Vector3d& sum) {
    return (moments.values() - sum).cwiseQuotient(sum).cwiseAbs().maxCoeff();
  };
  const Vector3d semi(1.3, .8, .5);
  const auto inEllipsoid = [&](const Vector3d& r) { return r.cwiseQuotient(semi).squaredNorm() < 1; };
  const auto inCylinder = [](const Vector3d& r) { return r[0] * r[0] + r[1] * r[1] < .45 * .45; };
  expectResidual("ellipsoid", near(solidEllipsoidMoments(1, semi), summed(2 * semi, 60, inEllipsoid)),
                 2e-4);  // measured 4e-05
  expectResidual("cylinder", near(solidCylinderMoments(1, .45, 1.7), summed({.9, .9, 1.7}, 60, inCylinder)),
                 1e-3);  // measured 0.0002
  const Vector3d book(.205, .135, .03);
  expectResidual("box", near(solidBoxMoments(1, book), summed(book, 60, [](const Vector3d&) { return true; })),
                 4e-4);  // measured 0.00028 = 1/60^2
}

TEST(ShapeInertia, RefusesWhatIsNoBody) {
  EXPECT_EQ(refusal([] { solidBoxMoments(0, {1, 1, 1}); }), "mass must be positive and finite, got 0");
  EXPECT_EQ(refusal([] {
              solidBoxMoments(1, {1, -1, 1});
            }),
            "edge of the box must be positive and finite, got -1");
  EXPECT_EQ(refusal([] { solidCylinderMoments(1, 0, 1); }),
            "radius of the cylinder must be positive and finite, got 0");
  EXPECT_EQ(refusal([] { racketMoments(1, .25, .25); }),
            "length of the racket less its width must be positive and finite, got 0");
}

}  // namespace
}  // namespace poinsot::physics
