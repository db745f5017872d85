// SPDX-License-Identifier: Apache-2.0
#include "stage/body_figure.h"

#include <gtest/gtest.h>

#include "scene_samples.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

// The uniform box with edges 3, 2, 1: moments m/12 (y² + z², ...) = m/12 (5, 10, 13).
TEST(EquivalentBox, GivesTheBoxBack) {
  const Vector3d half = equivalentBox(physics::PrincipalMoments({5, 10, 13}));
  EXPECT_NEAR(half.y() / half.x(), 2.0 / 3, 1e-14);
  EXPECT_NEAR(half.z() / half.x(), 1.0 / 3, 1e-14);
}

TEST(EquivalentBox, KeepsALaminaVisible) {
  const Vector3d half = equivalentBox(physics::PrincipalMoments({1, 2, 3}));
  EXPECT_GT(half.minCoeff(), 0.05 * half.maxCoeff());
}

TEST(BodyFigure, FitsInsideTheEllipsoidItIsScaledTo) {
  const BodyFigure figure(sample());
  const Vector3d semiAxes(1, 0.8, 0.6);
  // A box touches first with its corner.
  EXPECT_DOUBLE_EQ(figure.reachIn(semiAxes), figure.reachAlongAxes().cwiseQuotient(semiAxes).norm());
  EXPECT_DOUBLE_EQ(figure.radius(), figure.reachAlongAxes().norm());
}

TEST(BodyFigure, DrawsTheShapeAskedFor) {
  const auto shapes = [](const std::string& shape) {
    draw::DrawList list;
    BodyFigure(sample("[show.body]\nshape = \"" + shape + "\"\n"))
        .add(list, Eigen::Matrix3d::Identity(), 1, palette(scene::Theme::kLight), 2);
    return list;
  };
  EXPECT_EQ(shapes("box").boxes.size(), 1u);
  EXPECT_EQ(shapes("ellipsoid").ellipsoids.size(), 1u);
  EXPECT_EQ(shapes("cylinder").frustums.size(), 1u);
  EXPECT_GT(shapes("racket").curves.size(), 10u);  // frame, throat and strings
}

}  // namespace
}  // namespace poinsot::stage
