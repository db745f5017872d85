// SPDX-License-Identifier: Apache-2.0
// The trace of a body point. Expected in closed form if there is one: the axis of a free symmetric top goes round
// L in a circle (lecture, eq 20).
#include "stage/figures/trace_figure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "scene_samples.h"
#include "scenery.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

constexpr glm::ivec2 kSize{960, 540};
const std::string kTop =
    "[body]\nprincipal_moments = [2, 2, 0.8]\n[motion]\nomega_body = [1.1, 0.3, 2]\n[show]\n"
    "ellipsoid = false\nplane = false\nherpolhode = false\npolhode = false\ncontact = false\n"
    "principal_axes = false\nL = false\nomega = false\nbody = false\nlabels = false\ntrace = true\n";

TEST(TraceFigure, LiesOnItsSphereAndEndsAtThePoint) {
  for (const char* more : {"", "[camera]\nframe = \"body\"\n"}) {
    const Stage stage(scene::parseScene(kTop + more, "t.toml"));
    for (const double t : {1.0, 4.2, 8.0}) {
      const auto list = onlyList(stage, t, kSize);
      ASSERT_EQ(list.glassEllipsoids.size(), 1u);
      ASSERT_EQ(list.ellipsoids.size(), 1u);
      const float radius = glm::length(list.glassEllipsoids[0].semiAxes_V[0]);
      const glm::vec3 dot = list.ellipsoids[0].centre_V;
      EXPECT_NEAR(glm::length(dot), radius, 2e-6);
      ASSERT_EQ(list.curves.size(), 3u);  // future, past, last second
      for (const auto& curve : list.curves)
        for (const auto& p : curve.points_V) ASSERT_NEAR(glm::length(p), radius, 2e-6);  // measured 1.2e-7
      EXPECT_LT(glm::distance(list.curves[0].points_V.front(), dot), 2e-6f);
      EXPECT_LT(glm::distance(list.curves[2].points_V.back(), dot), 2e-6f);
    }
  }
}

TEST(TraceFigure, TheAxisOfAFreeTopDrawsACircleAboutL) {
  const auto list = onlyList(Stage(scene::parseScene(kTop, "t.toml")), 3, kSize);
  // At the start, tan theta = I1 w/(I3 omega_3), where w is the part of omega across the axis.
  const double theta = std::atan2(2 * std::hypot(1.1, 0.3), 0.8 * 2),
               radius = glm::length(list.ellipsoids[0].centre_V);
  for (const auto& curve : list.curves)
    for (const auto& p : curve.points_V) EXPECT_NEAR(p.z, radius * std::cos(theta), 3e-6);  // measured 6e-9
}

TEST(TraceFigure, AppliesTheInitialOrientationToThePoint) {
  const std::string text =
      "[body]\nprincipal_moments = [2, 3, 4]\n[motion]\nomega_body = [1.1, 0.3, 2]\n"
      "orientation = [1, 0, 0, 1]\n[show.trace]\nvisible = true\npoint = [0.1, 0.2, -0.3]\n";
  const Scenery s(text);
  const TraceFigure figure(s.setting);
  // The orientation is a quarter turn about z: x to y, y to -x.
  EXPECT_LT((figure.point_V(s.motion.at(0)) - s.scales.body * Vector3d(-0.2, 0.1, -0.3)).norm(), 1e-15);
}

}  // namespace
}  // namespace poinsot::stage
