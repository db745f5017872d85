// SPDX-License-Identifier: Apache-2.0
#include "stage/body/body_figure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "scene_samples.h"
#include "stage/to_picture.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

// The uniform box with edges 3, 2, 1 has moments m/12 (y² + z², ...) = m/12 (5, 10, 13).
TEST(EquivalentBox, RecoversTheBoxFromItsMoments) {
  const Vector3d half = equivalentBox(physics::PrincipalMoments({5, 10, 13}));
  EXPECT_NEAR(half.y() / half.x(), 2.0 / 3, 1e-14);
  EXPECT_NEAR(half.z() / half.x(), 1.0 / 3, 1e-14);
}

TEST(EquivalentBox, KeepsALaminaVisible) {
  const Vector3d half = equivalentBox(physics::PrincipalMoments({1, 2, 3}));
  EXPECT_GT(half.minCoeff(), 0.05 * half.maxCoeff());
}

TEST(BodyFigure, TouchesTheEllipsoidWithItsCornersFirst) {
  const BodyFigure figure(sample());
  const Vector3d semiAxes(1, 0.8, 0.6);
  // The corner of a box touches first.
  EXPECT_DOUBLE_EQ(figure.reachIn(semiAxes), figure.reachAlongAxes().cwiseQuotient(semiAxes).norm());
  EXPECT_DOUBLE_EQ(figure.radius(), figure.reachAlongAxes().norm());
}

// Moments of a uniform cone about its apex, radius 0.45, height 1.7, per unit mass. By table 3.1 and eq 14 of the
// project's physics notes, they are 0.13875 + (3h/4)², and 0.06075 about the cone's axis.
TEST(EquivalentCone, RecoversTheConeFromItsMoments) {
  const Vector3d lengths = equivalentCone(physics::PrincipalMoments({1.764375, 1.764375, 0.06075}), 2);
  EXPECT_NEAR(lengths.x() / lengths.z(), 0.45 / 1.7, 1e-14);
  EXPECT_NEAR(lengths.y() / lengths.z(), 0.45 / 1.7, 1e-14);
}

// An elliptic cone of base a, b across z and height h has I_x = 3/20 m b² + 3/5 m h² and so on; its axis here is
// y.
TEST(EquivalentCone, RecoversAnEllipticConeAboutAnyAxis) {
  const double a = 0.7, b = 0.4, h = 1.1;  // a along z, b along x
  const Vector3d second(0.15 * b * b, 0.6 * h * h, 0.15 * a * a);
  const Vector3d moments = Vector3d::Constant(second.sum()) - second;
  const Vector3d lengths = equivalentCone(physics::PrincipalMoments(moments), 1);
  EXPECT_NEAR(lengths.x() / lengths.y(), b / h, 1e-14);
  EXPECT_NEAR(lengths.z() / lengths.y(), a / h, 1e-14);
}

// The body drawn for a bare tensor, whose principal axes are turned, has a tensor in the same proportions. A box
// with half edges h_i along u_i has the tensor m/3 Σ h_i² (1 - u_i u_iᵀ).
TEST(BodyFigure, DrawsATensorWithoutShapeAsABoxAlongItsAxes) {
  const Eigen::Matrix3d R = Eigen::Quaterniond(0.5, 0.3, -0.7, 0.4).normalized().toRotationMatrix();
  const Eigen::Matrix3d inertia_B = R * Vector3d(2, 3, 4).asDiagonal() * R.transpose();
  scene::Scene scene = sample();
  scene.body.axes = physics::PrincipalAxes(Eigen::Matrix3d(0.5 * (inertia_B + inertia_B.transpose())));
  draw::DrawList list;
  BodyFigure(scene).add(list, {Eigen::Matrix3d::Identity(), 1}, palette(scene::Theme::kLight), 2);
  ASSERT_EQ(list.boxes.size(), 1u);
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 3; ++i) {
    const Vector3d half = fromPicture(list.boxes[0].halfAxes_V[i]);
    second += half * half.transpose();
  }
  const Eigen::Matrix3d drawn = second.trace() * Eigen::Matrix3d::Identity() - second;
  const Eigen::Matrix3d difference = drawn / drawn.trace() - inertia_B / inertia_B.trace();
  EXPECT_LT(difference.norm(), 1e-6);  // measured 3e-8: floats
}

/// Returns the farthest points of a scene's body in 26 directions.
std::vector<Vector3d> farthestPoints(const std::string& body) {
  const BodyFigure figure(scene::parseScene(body + "[motion]\nomega_body = [0, 1, 2]\n", "test.toml"));
  std::vector<Vector3d> points;
  for (const Vector3d& direction : cubeDirections()) points.push_back(figure.supportPoint(direction));
  return points;
}

// A mass with moments is drawn as the box that has them, at its size and place. The same box, given as a shape,
// must look the same. Edges of 3, 2, 1 m and 12 kg give moments (5, 10, 13) kg m².
TEST(BodyFigure, DrawsAMassWithMomentsAsABoxAtTheCentreOfMass) {
  const std::string box = "[body]\nmass = 12\nshape = 'box'\nsize = [3, 2, 1]\n", moments = "[body]\nmass = 12\n";
  const std::string own = "principal_moments = [5, 10, 13]\n", pivot = "pivot = [0.25, 0, -2]\n";
  const std::string tensor = "inertia = [[5, 0, 0], [0, 10, 0], [0, 0, 13]]\n";
  for (const std::string& held : {std::string(), pivot})
    for (const std::string& form : {own, tensor}) {
      const auto expected = farthestPoints(box + held), drawn = farthestPoints(moments + form + held);
      for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_LE((drawn[i] - expected[i]).norm(), 1e-15) << form << held << i;  // measured: equal
    }
  const std::string shifted = moments + own + "centre_of_mass = [1, 1, 1]\npivot = [1.25, 1, -1]\n";
  EXPECT_EQ(farthestPoints(shifted), farthestPoints(moments + own + pivot));
}

// All of the mass is in one point, 2 m from the pivot. A small box is drawn there, not a box of no size.
TEST(BodyFigure, DrawsAMassInOnePointAsAVisibleBox) {
  const std::vector<Vector3d> points = farthestPoints(
      "[body]\nmass = 1\nprincipal_moments = [4, 4, 1e-12]\npivot = [0, 0, -2]\nmoments_about = 'pivot'\n");
  Eigen::AlignedBox3d box;
  for (const Vector3d& point : points) box.extend(point);
  EXPECT_LE((box.center() - Vector3d(0, 0, 2)).norm(), 1e-15);  // measured: equal
  EXPECT_NEAR(box.sizes().minCoeff(), 0.28, 2e-15);             // measured: equal
  EXPECT_NEAR(box.sizes().maxCoeff(), 0.28, 2e-15);             // measured 2.2e-16
}

TEST(BodyFigure, HasTheReachOfItsFarthestCorner) {
  const Eigen::Quaterniond q = Eigen::Quaterniond(0.8, 0.1, -0.5, 0.3).normalized();
  scene::Scene scene = sample();
  scene.body.parts = {scene::Part{physics::Solid(physics::Box{{0.6, 0.4, 1.2}}), 1, q, {0.3, -0.2, 0.1}}};
  const Vector3d semiAxes(1, 0.5, 0.7);
  double farthest = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3d p((corner & 1 ? 0.3 : -0.3), (corner & 2 ? 0.2 : -0.2), (corner & 4 ? 0.6 : -0.6));
    farthest = std::max(farthest, (q * p + Vector3d(0.3, -0.2, 0.1)).cwiseQuotient(semiAxes).norm());
  }
  EXPECT_NEAR(BodyFigure(scene).reachIn(semiAxes), farthest, 1e-14);
}

// The five masses and their centre of mass are those of the project's physics notes. They are drawn as balls of
// one density, each on a rod from the centre of mass.
TEST(BodyFigure, DrawsPointMassesAsBallsOnRods) {
  const double masses[] = {1.5, 0.75, 2.25, 1.125, 0.375};
  const Vector3d places[] = {
      {0.5, -1.25, 0.75}, {-1, 0.25, 1.5}, {0.125, 0.875, -0.625}, {1.75, 0.5, -0.25}, {-0.5, -0.75, -1.125}};
  scene::Scene scene = sample();
  std::vector<physics::MassProperties> points;
  for (std::size_t i = 0; i < 5; ++i) {
    points.push_back(physics::MassProperties::ofPoint(masses[i], places[i]));
    scene.body.parts.push_back({scene::PointMass{}, masses[i], Eigen::Quaterniond::Identity(), places[i]});
  }
  scene.body.mass = physics::combined(points);
  draw::DrawList list;
  BodyFigure(scene).add(list, {Eigen::Matrix3d::Identity(), 1}, palette(scene::Theme::kLight), 2);
  ASSERT_EQ(list.ellipsoids.size(), 6u);  // the sixth is the joint in the middle
  ASSERT_EQ(list.frustums.size(), 5u);
  const Vector3d centre(0.34375, 0.09375, 0.0234375);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_LT((fromPicture(list.ellipsoids[i].centre_V) - (places[i] - centre)).norm(), 1e-6);
    EXPECT_LT((fromPicture(list.frustums[i].to_V) - (places[i] - centre)).norm(), 1e-6);
    EXPECT_LT(fromPicture(list.frustums[i].from_V).norm(), 1e-6);
    const double ratio = static_cast<double>(glm::length(list.ellipsoids[i].semiAxes_V[0]) /
                                             glm::length(list.ellipsoids[2].semiAxes_V[0]));
    EXPECT_NEAR(ratio * ratio * ratio, masses[i] / 2.25, 1e-5);
  }
}

TEST(BodyFigure, HasItsPivotAtTheOrigin) {
  scene::Scene scene = sample();
  scene.body.parts = {scene::Part{physics::Solid(physics::Rod{2}), 1}};
  scene.body.mass = physics::massProperties(physics::Rod{2}, 1);
  scene.body.pivot_B = Vector3d(-1, 0, 0);
  const BodyFigure figure(scene);
  EXPECT_NEAR(figure.supportPoint({1, 0, 0}).x(), 2, 1e-14);
  EXPECT_NEAR(figure.supportPoint({-1, 0, 0}).x(), 0, 1e-14);
}

TEST(BodyFigure, DrawsTheRequestedShape) {
  const auto shapes = [](const std::string& shape) {
    draw::DrawList list;
    BodyFigure(sample("[show.body]\nshape = \"" + shape + "\"\n"))
        .add(list, {Eigen::Matrix3d::Identity(), 1}, palette(scene::Theme::kLight), 2);
    return list;
  };
  EXPECT_EQ(shapes("box").boxes.size(), 1u);
  EXPECT_EQ(shapes("ellipsoid").ellipsoids.size(), 1u);
  EXPECT_EQ(shapes("cylinder").frustums.size(), 1u);
  EXPECT_GT(shapes("racket").curves.size(), 10u);  // frame, throat and strings
}

}  // namespace
}  // namespace poinsot::stage
