// SPDX-License-Identifier: Apache-2.0
// Cones, decomposition and theta, compared with the lecture's own relations. Expected values are worked out from
// omega and L alone; no half-angle or rate is taken from the figures.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "scene_samples.h"
#include "scenery.h"
#include "stage/figures/cones_figure.h"
#include "stage/figures/decomposition_figure.h"
#include "stage/figures/momentum_parts_figure.h"
#include "stage/figures/named_figures.h"
#include "stage/figures/polhode_cones_figure.h"
#include "stage/figures/triad_figure.h"

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

// I = (2, 2, 1) and omega = (0.5, 0, 1) give L = (1, 0, 1): i is e1 and k is e3 at the start.
const std::string kByHand = top("[2, 2, 1]", "[0.5, 0, 1]");

TEST(TriadFigure, HasIInThePlaneOfLAndK) {
  const Scenery byHand(kByHand);
  const PictureState start = byHand.motion.at(0);
  const TriadFigure atStart(byHand.setting);
  const Eigen::Matrix3d unit = atStart.axes_V(start) / atStart.axes_V(start).col(0).norm();
  EXPECT_LT((unit - start.R_VP).norm(), 1e-15);
  for (const std::string& text : {kByHand, kProlate, kOblate, kBodyFrame, kAlongX, kBackwards}) {
    const Scenery s(text, kAxisLengths);
    const TriadFigure figure(s.setting);
    for (const double t : kTimes_s) {
      const PictureState state = s.motion.at(t);
      const Eigen::Matrix3d axes = figure.axes_V(state);
      const Vector3d i = axes.col(0), j = axes.col(1), k = axes.col(2);
      const double length = i.norm();
      EXPECT_LT((i.cross(j) / (length * length) - k / length).norm(), 1e-14);
      EXPECT_LT(std::abs(j.dot(state.L_V)) / (length * state.L_V.norm()), 1e-14) << text << t;          // L2 = 0
      EXPECT_LT(std::abs(j.dot(state.omega_V)) / (length * state.omega_V.norm()), 1e-14) << text << t;  // eq 19
      EXPECT_GT(i.dot(state.L_V), 0);
    }
  }
}

// omega_1 = L sin(theta)/I1 = 1/2 and omega_3 = L cos(theta)/I3 = 1 at every time.
TEST(TriadFigure, ComponentsAreOmega1AndOmega3) {
  const Scenery s(kByHand);
  const TriadFigure figure(s.setting);
  for (const double t : kTimes_s) {
    const PictureState state = s.motion.at(t);
    const auto [alongI, alongK] = figure.components_V(state);
    EXPECT_NEAR(alongI.norm(), 0.5 * s.scales.omega, 1e-14);
    EXPECT_NEAR(alongK.norm(), 1.0 * s.scales.omega, 1e-14);
    EXPECT_LT((alongI + alongK - s.scales.omega * state.omega_V).norm(), 1e-14);
    EXPECT_LT((alongK - s.scales.omega * state.R_VP.col(2)).norm(), 1e-14);
  }
}

TEST(TriadFigure, RejectsMotionsWithoutIt) {
  EXPECT_THROW(TriadFigure(Scenery(top("[2, 3, 4]")).setting), core::Error);
  EXPECT_THROW(TriadFigure(Scenery(top("[2, 2, 1]", "[0, 0, 1]")).setting), core::Error);
  EXPECT_THROW(TriadFigure(Scenery(kProlate + "[motion.torque]\nbody = [0, 0, 1]\n").setting), core::Error);
}

TEST(NamedVector, HasComponentsAlongIJK) {
  const Scenery s(kProlate + "[[vector]]\ncomponents = [1, 2, -2]\nframe = \"precession\"\n");
  const NamedVectorFigure vector(s.setting, s.scene.vectors.at(0));
  for (const double t : kTimes_s) {
    const PictureState state = s.motion.at(t);
    const Vector3d k = state.R_VP.col(2), j = k.cross(state.L_V).normalized(), i = j.cross(k);
    EXPECT_LT((vector.arrow(state).tip_V.normalized() - (i + 2 * j - 2 * k) / 3).norm(), 1e-14) << t;
  }
}

// Eq 36. Prolate: I1 omega = (1, 0, 2), and (1 - 2)·1·k points against k. Oblate, I = (1, 1, 2): L = (0.5, 0, 2)
// is the sum of (0.5, 0, 1) and (0, 0, 1), which points along k.
TEST(MomentumPartsFigure, TheSecondPartPointsAgainstKIfProlateAndAlongKIfOblate) {
  const Scenery p(kByHand), o(top("[1, 1, 2]", "[0.5, 0, 1]"));
  const PictureState atP = p.motion.at(0), atO = o.motion.at(0);
  const auto prolate = MomentumPartsFigure(p.setting).parts_V(atP),
             oblate = MomentumPartsFigure(o.setting).parts_V(atO);
  EXPECT_LT((prolate.alongOmega / p.scales.L - atP.R_VP * Vector3d(1, 0, 2)).norm(), 1e-14);
  EXPECT_LT((prolate.alongAxis / p.scales.L - atP.R_VP * Vector3d(0, 0, -1)).norm(), 1e-14);
  EXPECT_LT((oblate.alongOmega / o.scales.L - atO.R_VP * Vector3d(0.5, 0, 1)).norm(), 1e-14);
  EXPECT_LT((oblate.alongAxis / o.scales.L - atO.R_VP * Vector3d(0, 0, 1)).norm(), 1e-14);
}

TEST(MomentumPartsFigure, ThePartsSumToL) {
  for (const std::string& text : {kByHand, kProlate, kOblate, kBodyFrame, kAlongX, kBackwards, top("[1, 1, 1]")}) {
    const Scenery s(text);
    const MomentumPartsFigure figure(s.setting);
    for (const double t : kTimes_s) {
      const PictureState state = s.motion.at(t);
      const auto [alongOmega, alongAxis] = figure.parts_V(state);
      EXPECT_LT((alongOmega + alongAxis - s.scales.L * state.L_V).norm(), 1e-14) << text << t;
      EXPECT_LT(alongOmega.cross(state.omega_V).norm(), 1e-14) << text << t;
    }
  }
  EXPECT_THROW(MomentumPartsFigure(Scenery(top("[2, 3, 4]")).setting), core::Error);
}

const std::string kAsymmetric[] = {top("[1, 1.7, 2.6]", "[1.5, 0.6, 0.5]"),
                                   top("[1, 1.7, 2.6]", "[0.3, 0.6, 1.5]"),
                                   top("[1, 1.7, 2.6]", "[-1.5, 0.6, 0.5]") + "[camera]\nframe = \"body\"\n"};

// On the body cone, the energy and L give sum I (L² - 2T I) w² = 0, the equation of a cone. The space cone's rim
// is on a plane across L, at the height 2T/L times the scale of the rim.
TEST(PolhodeConesFigure, RimsLieOnTheirCones) {
  for (const std::string& text : kAsymmetric) {
    const Scenery s(text);
    const PolhodeConesFigure figure(s.setting);
    const Vector3d I = s.motion.moments().values();
    for (const double t : kTimes_s) {
      const PictureState state = s.motion.at(t);
      const double LL = state.L_V.squaredNorm(), TT = state.omega_V.dot(state.L_V);  // L² and 2T
      const Vector3d form = I.array() * (LL - TT * I.array());
      for (const Vector3d& p_V : figure.bodyRim_V(state)) {
        const Vector3d p = state.R_VP.transpose() * p_V;
        const Vector3d terms = form.array() * p.array().square();
        EXPECT_LT(std::abs(terms.sum()), 1e-12 * terms.cwiseAbs().sum()) << text << t;
      }
      const double height = ConeLook::kSide * s.scales.omega * TT / std::sqrt(LL);
      for (const Vector3d& p_V : figure.spaceRim_V(t, state))
        EXPECT_NEAR(p_V.dot(state.L_V) / std::sqrt(LL), height, 1e-12) << text << t;
    }
  }
}

// Both rims pass through the line of omega: their nearest point is less than half the distance of two points away.
TEST(PolhodeConesFigure, BothConesTouchAlongOmega) {
  const auto gap = [](const std::vector<Vector3d>& rim, const Vector3d& tip) {
    double nearest = 1e9, widest = 0;
    for (const Vector3d& p : rim) nearest = std::min(nearest, (p - tip).norm());
    for (std::size_t i = 1; i < rim.size(); ++i) widest = std::max(widest, (rim[i] - rim[i - 1]).norm());
    return nearest / widest;
  };
  for (const std::string& text : kAsymmetric) {
    const Scenery s(text);
    const PolhodeConesFigure figure(s.setting);
    for (const double t : kTimes_s) {
      const PictureState state = s.motion.at(t);
      const Vector3d tip = ConeLook::kSide * s.scales.omega * state.omega_V;
      EXPECT_LT(gap(figure.bodyRim_V(state), tip), 0.51) << text << t;
      EXPECT_LT(gap(figure.spaceRim_V(t, state), tip), 0.51) << text << t;
    }
  }
}

TEST(PolhodeConesFigure, RejectsMotionsWithoutCones) {
  EXPECT_THROW(PolhodeConesFigure(Scenery(top("[1, 2, 2.5]", "[0, 1, 0]")).setting), core::Error);
  EXPECT_THROW(PolhodeConesFigure(Scenery(top("[3, 4, 6]", "[2, 1, 1]")).setting), core::Error);
  EXPECT_THROW(PolhodeConesFigure(Scenery(kAsymmetric[0] + "[motion.torque]\nbody = [0, 0, 1]\n").setting),
               core::Error);
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
