// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/named_figures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "scenery.h"
#include "stage/figures/ghosts_figure.h"
#include "stage/figures/plane_of_L_figure.h"
#include "stage/figures/triad_figure.h"
#include "stage/figures/vector_figures.h"
#include "stage/palette.h"
#include "stage/stage.h"

// Figures that a scene adds to its pictures: vectors, angles, the torque, the plane of L, poses at other times.
// Expected values are the definitions, with the motion's own state.

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

constexpr double kTimes_s[] = {0, 1.3, 4, 9.9};
const std::string kTop =
    "[body]\nshape = \"cylinder\"\nradius = 1\nheight = 3\nmass = 1\n[motion]\nomega_body = [0.6, 0.3, 2]\n";

TEST(NamedVector, HasTheDirectionOfItsComponentsInItsAxes) {
  const Scenery s(kTop +
                  "[[vector]]\ncomponents = [1, 2, -2]\nframe = \"body\"\n[[vector]]\ncomponents = [0, 3, 4]\n");
  const NamedVectorFigure body(s.setting, s.scene.vectors.at(0)), space(s.setting, s.scene.vectors.at(1));
  for (const double t : kTimes_s) {
    const PictureState state = s.motion.at(t);
    EXPECT_LT((body.arrow(state).tip_V.normalized() - state.R_VB * Vector3d(1, 2, -2) / 3).norm(), 1e-15) << t;
    EXPECT_LT((space.arrow(state).tip_V.normalized() - state.R_VW * Vector3d(0, 0.6, 0.8)).norm(), 1e-15) << t;
    EXPECT_TRUE(space.arrow(state).from_V.isZero(0));
  }
}

TEST(NamedVector, HasTheColourThatTheSceneNames) {
  const Palette colors = palette(scene::Style());
  const auto colorOf = [&](const std::string& color) {
    const Scenery s(kTop + "[[vector]]\nname = 'a'\ncomponents = [0, 0, 1]\n" + color);
    draw::DrawList list;
    std::vector<Label> labels;
    NamedVectorFigure(s.setting, s.scene.vectors.at(0))
        .add({list, labels, colors, s.scene.labels}, 0, s.motion.at(0));
    return labels.at(0).color;
  };
  EXPECT_EQ(colorOf(""), colors.vector);
  EXPECT_EQ(colorOf("color = 'vector'\n"), colors.vector);
  EXPECT_EQ(colorOf("color = 'ink'\n"), colors.ink);
  EXPECT_EQ(colorOf("color = 'L'\n"), colors.L);
}

// The velocity of a point that is fixed in the body is omega x r, perpendicular to both.
TEST(NamedVector, VelocityIsOmegaCrossR) {
  const Scenery s(kTop + "[[vector]]\nvelocity_of = [0.5, -0.2, 1]\n[[vector]]\nposition_of = [0.5, -0.2, 1]\n");
  const NamedVectorFigure velocity(s.setting, s.scene.vectors.at(0)), position(s.setting, s.scene.vectors.at(1));
  const auto ratio = [&](double t) {
    const PictureState state = s.motion.at(t);
    const NamedVectorFigure::Arrow v = velocity.arrow(state), r = position.arrow(state);
    EXPECT_LT((v.from_V - r.tip_V).norm(), 1e-15) << t;
    EXPECT_LT((r.tip_V - s.scales.body * state.R_VB * Vector3d(0.5, -0.2, 1)).norm(), 1e-15) << t;
    const Vector3d drawn = v.tip_V - v.from_V, expected = state.omega_V.cross(r.tip_V);
    EXPECT_LT(drawn.normalized().cross(expected.normalized()).norm(), 1e-14) << t;
    return drawn.norm() / expected.norm();
  };
  for (const double t : kTimes_s) EXPECT_NEAR(ratio(t) / ratio(0), 1, 1e-13) << t;
}

// The arc ends on both directions, and all of its points have the same distance.
TEST(Angle, IsAnArcFromOneDirectionToTheOther) {
  const Scenery s(kTop + "[[angle]]\nbetween = [\"omega\", \"e1\"]\n");
  const AngleFigure figure(s.setting, s.scene.angles.at(0));
  for (const double t : kTimes_s) {
    const PictureState state = s.motion.at(t);
    const std::vector<Vector3d> arc = figure.arc(state);
    ASSERT_FALSE(arc.empty());
    EXPECT_LT((arc.front().normalized() - state.omega_V.normalized()).norm(), 1e-14) << t;
    EXPECT_LT((arc.back().normalized() - state.R_VP.col(0)).norm(), 1e-14) << t;
    for (const Vector3d& p : arc) EXPECT_NEAR(p.norm(), arc.front().norm(), 1e-14);
  }
}

// Axes of one's own that are turned by a quarter about z: their x axis is the y axis of the body.
TEST(NamedVector, MayBeAlongOwnAxes) {
  const Scenery s(
      "[body]\nprincipal_moments = [1, 2, 2.5]\nown_axes.rotation = [1, 0, 0, 1]\n[motion]\nomega_body = [0.3, 1, "
      "2]\n"
      "[[vector]]\ncomponents = [1, 0, 0]\nframe = \"own\"\n");
  const NamedVectorFigure figure(s.setting, s.setting.scene.vectors.at(0));
  for (const double t : kTimes_s) {
    const PictureState state = s.motion.at(t);
    EXPECT_LT((figure.arrow(state).tip_V.normalized() - state.R_VB.col(1)).norm(), 1e-15) << t;
  }
}

// The torque of a top under gravity is M g r k x (-z): horizontal, across the axis, M g r sin(theta) large.
TEST(Torque, IsHorizontalAndPerpendicularToTheAxisOfATop) {
  const Scenery s(
      "[body]\nprincipal_moments = [2, 2, 0.8]\n[motion]\nomega_body = [0.4, 0, 9]\n"
      "orientation = [0.9, 0.3, 0, 0]\n[motion.gravity]\nmgr_body = [0, 0, 3]\n"
      "[show.torque]\nvisible = true\n");
  const TorqueFigure figure(s.setting);
  double longest = 0;
  for (const double t : kTimes_s) {
    const PictureState state = s.motion.at(t);
    const Vector3d k = state.R_VP.col(2), up = state.R_VW.col(2);
    EXPECT_LT((state.torque_V - 3 * k.cross(-up)).norm(), 1e-14) << t;
    const Vector3d tip = figure.outermostPoints(state).at(0);
    EXPECT_LT(std::abs(tip.dot(up)), 1e-14) << t;
    longest = std::max(longest, tip.norm());
  }
  EXPECT_LE(longest, 0.9 * (1 + 1e-12));
  EXPECT_GT(longest, 0.5);
}

TEST(Torque, IsZeroForAFreeBody) {
  const Scenery s(kTop + "[show.torque]\nvisible = true\n");
  EXPECT_TRUE(TorqueFigure(s.setting).outermostPoints(s.motion.at(1)).at(0).isZero(0));
}

// L, omega and the axis of a symmetric top are in one plane (lecture, eq 34), inside the edges of the sheet.
TEST(PlaneOfL, ContainsLOmegaAndTheAxis) {
  const Scenery s(kTop + "[show.plane_of_L]\nvisible = true\n");
  const PlaneOfLFigure figure(s.setting);
  for (const double t : kTimes_s) {
    const PictureState state = s.motion.at(t);
    const std::vector<Vector3d> c = figure.corners_V(state);
    ASSERT_EQ(c.size(), 4u);
    const Vector3d u = c[1] - c[0], v = c[3] - c[0], n = u.cross(v).normalized();
    EXPECT_NEAR(u.dot(v), 0, 1e-14);
    for (const Vector3d& p : {Vector3d(s.scales.L * state.L_V), Vector3d(s.scales.omega * state.omega_V),
                              Vector3d(s.setting.axisLengths[2] * state.R_VP.col(2))}) {
      EXPECT_NEAR(p.dot(n), 0, 1e-14) << t;
      const double x = (p - c[0]).dot(u) / u.squaredNorm(), y = (p - c[0]).dot(v) / v.squaredNorm();
      EXPECT_TRUE(x > 0 && x < 1 && y > 0 && y < 1) << x << " " << y;
    }
  }
}

// The dashes of a position vector lie in front of the body, but not so near that the camera cuts them off.
TEST(NamedVector, IsDashedWhereTheBodyHidesIt) {
  const Stage stage(
      scene::parseScene(kTop + "[[vector]]\nname = '$r$'\nposition_of = [0.1, 0.1, 0.1]\n", "r.toml"));
  const draw::DrawList list = stage.compose(1, {640, 360}).panels.at(0).list;
  std::size_t dashes = 0;
  for (const draw::Curve& curve : list.curves) {
    if (curve.points_V.size() != 2 || curve.lift_V < 0.1f) continue;
    ++dashes;
    for (const glm::vec3& point : curve.points_V)
      EXPECT_GT(depthOf(list.camera, point) - curve.lift_V, list.camera.near);
  }
  EXPECT_GE(dashes, 1u);
}

TEST(PlaneOfL, ReachesBeyondTheAxesIAndK) {
  const Scenery s(kTop + "[show.plane_of_L]\nvisible = true\n[show.triad]\nvisible = true\nscale = 3\n");
  const PictureState state = s.motion.at(1);
  const std::vector<Vector3d> c = PlaneOfLFigure(s.setting).corners_V(state);
  ASSERT_EQ(c.size(), 4u);
  const Eigen::Matrix3d axes = TriadFigure(s.setting).axes_V(state);
  const Vector3d u = c[1] - c[0], v = c[3] - c[0];
  for (const int axis : {0, 2}) {
    const Vector3d p = axes.col(axis) - c[0];
    const double x = p.dot(u) / u.squaredNorm(), y = p.dot(v) / v.squaredNorm();
    EXPECT_TRUE(x > 0 && x < 1 && y > 0 && y < 1) << x << " " << y;
  }
}

TEST(PlaneOfL, IsAbsentIfLAndOmegaAreParallel) {
  const Scenery s(
      "[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [0, 0, 2]\n"
      "[show.plane_of_L]\nvisible = true\n");
  EXPECT_TRUE(PlaneOfLFigure(s.setting).corners_V(s.motion.at(1)).empty());
}

TEST(Ghosts, ShowThePosesAtTheGivenTimes) {
  const Scenery s(kTop +
                  "[show.ghosts]\nvisible = true\ntimes = [0.5, \"2 s\", 7]\nstep = [1, 0.5, "
                  "0]\n[camera]\nazimuth = 0\nelevation = 0\n");
  const GhostsFigure figure(s.setting);
  ASSERT_EQ(figure.poses().size(), 3u);
  const double times_s[] = {0.5, 2, 7};
  for (std::size_t i = 0; i < 3; ++i) {
    const PictureState state = s.motion.at(times_s[i]);
    const GhostsFigure::Pose& pose = figure.poses()[i];
    EXPECT_LT((pose.R_WB - state.R_VW.transpose() * state.R_VB).norm(), 1e-15);
    // The cylinder's extent is its length of 3 m, so that a step is 3 m of the body. Seen from the x axis, y
    // points right.
    const Vector3d place = static_cast<double>(i + 1) * 3 * s.scales.body * Vector3d(0, 1, 0.5);
    EXPECT_LT((pose.place_V - place).norm(), 1e-14);
  }
}

TEST(Ghosts, AreEvenlySpacedOverTheFilmIfNoTimesAreGiven) {
  const Scenery s(kTop + "[show.ghosts]\nvisible = true\ncount = 4\n[time]\nduration = 8\n");
  const GhostsFigure figure(s.setting);
  ASSERT_EQ(figure.poses().size(), 4u);
  const PictureState state = s.motion.at(6);
  EXPECT_LT((figure.poses()[3].R_WB - state.R_VW.transpose() * state.R_VB).norm(), 1e-15);
}

std::vector<std::string> labelsOf(const std::string& text) {
  const Stage stage(scene::parseScene(text, "labels.toml"));
  std::vector<std::string> labels;
  const draw::Picture picture = stage.compose(1, {640, 360});
  for (const draw::Text& label : picture.panels.at(0).list.texts) labels.push_back(label.tex);
  return labels;
}

TEST(LabelTexts, AreThoseOfTheSceneOrTheDefaults) {
  using ::testing::Contains;
  using ::testing::Not;
  const auto usual = labelsOf(kTop);
  for (const char* tex :
       {"$\\mathbf{L}$", "$\\boldsymbol{\\omega}$", "$\\hat{\\mathbf{e}}_3$", "invariable plane"})
    EXPECT_THAT(usual, Contains(tex));
  const auto own =
      labelsOf(kTop + "[label]\nL = '$\\vec L$'\ne3 = '$z$'\nplane = 'plan invariable'\nomega = ''\n");
  for (const char* tex : {"$\\vec L$", "$z$", "plan invariable"}) EXPECT_THAT(own, Contains(tex));
  EXPECT_THAT(own, Not(Contains("$\\boldsymbol{\\omega}$")));
  EXPECT_EQ(own.size() + 1, usual.size());
}

}  // namespace
}  // namespace poinsot::stage
