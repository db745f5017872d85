// SPDX-License-Identifier: Apache-2.0
#include "draw/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace poinsot::draw {
namespace {

Camera alongX() { return lookAt({5, 0, 0}, {0, 0, 0}, {0, 0, 1}, 1.0f, {200, 100}); }

TEST(Camera, PutsTheTargetInTheMiddle) {
  const glm::vec2 p = project(alongX(), {0, 0, 0});
  EXPECT_FLOAT_EQ(p.x, 100);
  EXPECT_FLOAT_EQ(p.y, 50);
  EXPECT_FLOAT_EQ(depthOf(alongX(), {0, 0, 0}), 5);
}

// Expected by hand: at distance 5, half the height is 5 tan(0.5), which is 50 pixels. Seen from +x with z up, +y
// is right.
TEST(Camera, ScalesByTheFieldOfView) {
  const float half = 5 * std::tan(0.5f);
  const glm::vec2 top = project(alongX(), {0, 0, half}), right = project(alongX(), {0, half, 0});
  EXPECT_NEAR(top.y, 0, 1e-4);
  EXPECT_NEAR(top.x, 100, 1e-4);
  EXPECT_NEAR(right.x, 150, 1e-4);
}

TEST(Camera, AxesAreRightHanded) {
  const Camera c = lookAt({3, -2, 4}, {1, 1, 0}, {0, 0, 1}, 0.5f, {10, 10});
  const glm::vec3 x = c.R_VC[0], y = c.R_VC[1], z = c.R_VC[2];
  EXPECT_NEAR(x.x * (y.y * z.z - y.z * z.y) - x.y * (y.x * z.z - y.z * z.x) + x.z * (y.x * z.y - y.y * z.x), 1,
              1e-6);
  EXPECT_NEAR(x.z, 0, 1e-6);  // upright
}

TEST(Camera, KeepsSizesAtAnyDistanceIfOrthographic) {
  Camera c = alongX();
  c.orthographic = true;
  c.halfHeight_V = 2;
  for (const float x : {-3.0f, 0.0f, 4.0f}) {
    const glm::vec2 p = project(c, {x, 1, 0.5f});
    EXPECT_FLOAT_EQ(p.x, 100 + 25) << x;  // 50 pixels are 2
    EXPECT_FLOAT_EQ(p.y, 50 - 12.5f) << x;
    EXPECT_FLOAT_EQ(depthOf(c, {x, 1, 0.5f}), 5 - x);
    EXPECT_FLOAT_EQ(toCamera(c, {x, 1, 0.5f}).x, 1);
    EXPECT_FLOAT_EQ(toCamera(c, {x, 1, 0.5f}).y, 0.5f);
  }
}

TEST(Camera, KeepsThePlaneOfTheTargetIfMadeOrthographic) {
  const Camera perspective = lookAt({3, -2, 4}, {1, 1, 0}, {0, 0, 1}, 0.5f, {320, 200});
  const Camera parallel = orthographic(perspective, {1, 1, 0});
  const glm::vec3 inPlane = glm::vec3(1, 1, 0) + 0.3f * perspective.R_VC[0] - 0.2f * perspective.R_VC[1];
  const glm::vec2 a = project(perspective, inPlane), b = project(parallel, inPlane);
  EXPECT_NEAR(a.x, b.x, 1e-3);
  EXPECT_NEAR(a.y, b.y, 1e-3);
  EXPECT_THROW(orthographic(perspective, {5, -6, 9}), std::logic_error);  // behind the eye
}

TEST(Camera, RefusesAnUndefinedView) {
  EXPECT_THROW(lookAt({1, 1, 1}, {1, 1, 1}, {0, 0, 1}, 1, {1, 1}), std::logic_error);
  EXPECT_THROW(lookAt({0, 0, 3}, {0, 0, 0}, {0, 0, 1}, 1, {1, 1}), std::logic_error);
  EXPECT_THROW(project(alongX(), {6, 0, 0}), std::logic_error);  // behind the eye
}

}  // namespace
}  // namespace poinsot::draw
