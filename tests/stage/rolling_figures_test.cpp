// SPDX-License-Identifier: Apache-2.0
// The table under a rolling cone, and the two parts of its angular velocity.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "scenery.h"
#include "stage/figures/decomposition_figure.h"
#include "stage/figures/symmetric_top.h"
#include "stage/figures/table_figure.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

// Worked by hand: sin alpha = 0.6 and cos alpha = 0.8. With Omega_v = 1.5, omega = 2 along the line of contact, and the
// parts are 1.5 along z and -2.5 along the cone's axis.
Scenery rollingCone(const std::string& more = "") {
  return Scenery(
      "[body]\nshape='cone'\nradius=0.75\nheight=1\nmass=2\npivot=[0, 0, 0.75]\n[motion.rolling]\nrate=1.5\n" +
      more);
}

TEST(TableFigure, LineOfContactLiesOnTheTableAlongOmega) {
  for (const char* frame : {"space", "body"}) {
    const Scenery s = rollingCone("[camera]\nframe='" + std::string(frame) + "'\n");
    const TableFigure figure(s.setting);
    for (const double t : {0.0, 1.7, 6.2}) {
      const PictureState state = s.motion.at(t);
      const Vector3d end = figure.contactEnd_V(state), up = state.R_VW.col(2);
      EXPECT_NEAR(end.dot(up), 0, 1e-12);
      EXPECT_NEAR(end.norm(), 1.25 * s.scales.body, 1e-12);
      EXPECT_LT(end.cross(state.omega_V).norm(), 1e-12);
      // Seen from the cone, the line touches its side: the angle to the axis is alpha.
      EXPECT_NEAR((state.R_VB * -Vector3d::UnitZ()).dot(end) / end.norm(), 0.8, 1e-12);
      EXPECT_EQ(figure.outermostPoints(state).size(), 4u);
    }
  }
}

TEST(DecompositionFigure, PartsOfARollingConeAreVerticalAndAlongItsAxis) {
  const Scenery s = rollingCone();
  const DecompositionFigure figure(s.setting);
  for (const double t : {0.0, 2.9}) {
    const PictureState state = s.motion.at(t);
    const auto [first, second] = figure.parts_V(state);
    EXPECT_LT((first - 1.5 * s.scales.omega * Vector3d::UnitZ()).norm(), 1e-12);
    EXPECT_LT((second + 2.5 * s.scales.omega * (state.R_VB * -Vector3d::UnitZ())).norm(), 1e-12);
    EXPECT_LT((first + second - s.scales.omega * state.omega_V).norm(), 1e-12);
  }
}

// Worked by hand (rolling_cone_test.cpp): the torque is -Omega_v²·0.945 along the motion of the axis.
TEST(PictureMotion, TorqueOfARollingConeIsTheChangeOfL) {
  const Scenery s = rollingCone();
  const PictureState state = s.motion.at(0);
  EXPECT_LT((state.torque_V - Vector3d(-2.25 * 0.945, 0, 0)).norm(), 1e-12);  // the cone lies towards -y
  EXPECT_FALSE(s.motion.isFree());
  EXPECT_LT((mainAxis_P(s.motion) - Vector3d(0, 0, -1)).norm(), 1e-15);
}

}  // namespace
}  // namespace poinsot::stage
