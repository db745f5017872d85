// SPDX-License-Identifier: Apache-2.0
// Cones, decomposition and theta, compared with the lecture's own relations. Expected values are worked out from
// omega and L alone; no half-angle or rate is taken from the figures.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.h"
#include "scene_samples.h"
#include "scenery.h"
#include "stage/figures/cones_figure.h"
#include "stage/figures/decomposition_figure.h"
#include "stage/figures/named_figures.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

constexpr double kTimes_s[] = {0, 0.7, 3.3, 5, 9.9};

const Vector3d kAxisLengths(1.2, 1.1, 1.3);

std::string top(const std::string& moments, const std::string& omega = "[1.1, 0.3, 2]") {
  return "[body]\nprincipal_moments = " + moments + "\n[motion]\nomega_body = " + omega +
         "\n[show]\nplane = false\n";
}

const std::string kProlate = top("[2, 2, 0.8]"), kOblate = top("[1, 1, 1.9]"),
                  kBodyFrame = kProlate + "[camera]\nframe = \"body\"\n",
                  kAlongX = top("[0.8, 2, 2]", "[2, 0.3, 1.1]"), kBackwards = top("[2, 2, 0.8]", "[1.1, 0.3, -2]");

Vector3d onCone(const ConesFigure::Cone& cone, const Vector3d& direction) {
  return {direction.normalized().dot(cone.axis_V), std::cos(cone.halfAngle_rad), 0};
}

TEST(ConesFigure, BothConesTouchAlongOmega) {
  for (const std::string& text : {kProlate, kOblate, kBodyFrame, kAlongX, kBackwards}) {
    const Scenery s(text, kAxisLengths);
    const ConesFigure figure(s.setting);
    for (const double t : kTimes_s) {
      const PictureState state = s.motion.at(t);
      for (const auto& cone : {figure.bodyCone(state), figure.spaceCone(state)}) {
        const Vector3d cosines = onCone(cone, state.omega_V);
        EXPECT_NEAR(cosines.x(), cosines.y(), 1e-14) << text << t;  // measured 6e-16
      }
      // The cones touch without crossing: both axes and omega are in one plane.
      const double volume =
          figure.bodyCone(state).axis_V.dot(figure.spaceCone(state).axis_V.cross(state.omega_V.normalized()));
      EXPECT_NEAR(volume, 0, 1e-14) << text << t;  // measured 2.2e-16
    }
  }
}

// Lecture: the cones of a prolate top are outside each other; the space cone of an oblate top is inside its
// body cone.
TEST(ConesFigure, ConesTouchOutsideIfProlateInsideIfOblate) {
  const auto angleBetweenAxes = [](const Scenery& s, const ConesFigure& figure) {
    const PictureState state = s.motion.at(2);
    return std::acos(figure.bodyCone(state).axis_V.dot(figure.spaceCone(state).axis_V));
  };
  const Scenery p(kProlate), o(kOblate);
  const ConesFigure prolate(p.setting), oblate(o.setting);
  const PictureState atP = p.motion.at(2), atO = o.motion.at(2);
  EXPECT_NEAR(angleBetweenAxes(p, prolate),
              prolate.bodyCone(atP).halfAngle_rad + prolate.spaceCone(atP).halfAngle_rad, 1e-14);
  EXPECT_NEAR(angleBetweenAxes(o, oblate),
              oblate.bodyCone(atO).halfAngle_rad - oblate.spaceCone(atO).halfAngle_rad, 1e-14);
}

TEST(ConesFigure, RejectsBodiesAndMotionsWithoutCones) {
  EXPECT_THROW(ConesFigure(Scenery(top("[2, 3, 4]")).setting), core::Error);
  EXPECT_THROW(ConesFigure(Scenery(kProlate + "[motion.torque]\nbody = [0, 0, 1]\n").setting), core::Error);
}

// Eq 32 and 34: the parallelogram closes on omega. One side is along L and as long as |L|/I1, the other along
// k.
TEST(DecompositionFigure, ThePartsSumToOmega) {
  for (const auto& [text, I1] : {std::pair{kProlate, 2.0}, {kOblate, 1.0}, {kBodyFrame, 2.0}, {kBackwards, 2.0}}) {
    const Scenery s(text, kAxisLengths);
    const DecompositionFigure figure(s.setting);
    for (const double t : kTimes_s) {
      const PictureState state = s.motion.at(t);
      const auto [precession, spin] = figure.parts_V(state);
      EXPECT_LT((precession + spin - s.scales.omega * state.omega_V).norm(), 1e-14);  // measured 1.1e-16
      EXPECT_LT((precession - s.scales.omega / I1 * state.L_V).norm(), 1e-13);        // measured 4e-16
      EXPECT_LT(spin.cross(state.R_VP.col(2)).norm(), 1e-14);                         // measured 4e-17
    }
  }
}

TEST(ThetaFigure, TheArcEndsOnBothArrows) {
  for (const std::string& text : {kProlate, kOblate, kBodyFrame, top("[2, 3, 4]")}) {
    const Scenery s(text, kAxisLengths);
    const ThetaFigure figure(s.setting);
    for (const double t : kTimes_s) {
      const PictureState state = s.motion.at(t);
      const std::vector<Vector3d> arc = figure.arc(state);
      ASSERT_FALSE(arc.empty());
      const double radius = arc.front().norm();
      for (const Vector3d& p : arc) EXPECT_NEAR(p.norm(), radius, 1e-13);  // measured 3.3e-16
      EXPECT_LT((arc.front() - radius * state.L_V.normalized()).norm(), 1e-14);
      EXPECT_LT((arc.back() - radius * state.R_VP.col(2)).norm(), 1e-14);
      EXPECT_LT(radius, 1.3);
      EXPECT_LT(radius, s.scales.L * state.L_V.norm());
    }
  }
}

TEST(ThetaFigure, UnderGravityTheArcBeginsOnTheVertical) {
  const Scenery s(top("[2, 2, 0.8]", "[0, 0, 9]") + "[motion.gravity]\nmgr_body = [0, 0, 3]\n", kAxisLengths);
  // The second scene starts tilted, so that the vertical and the axis differ. The first starts upright and has no
  // arc.
  const Scenery tilted(
      "[body]\nprincipal_moments = [2, 2, 0.8]\n[motion]\nomega_body = [0, 0, 9]\norientation = [0.9, 0.3, 0, 0]\n"
      "[motion.gravity]\nmgr_body = [0, 0, 3]\n");
  const std::vector<Vector3d> arc = ThetaFigure(tilted.setting).arc(tilted.motion.at(1));
  ASSERT_FALSE(arc.empty());
  EXPECT_LT(arc.front().normalized().cross(Vector3d::UnitZ()).norm(), 1e-14);
  EXPECT_TRUE(ThetaFigure(s.setting).arc(s.motion.at(1)).empty());
}

}  // namespace
}  // namespace poinsot::stage
