// SPDX-License-Identifier: Apache-2.0
#include "stage/framing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "stage/to_picture.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

scene::Camera view() {
  scene::Camera camera;
  camera.azimuth_rad = 0.4;
  camera.elevation_rad = 0.3;
  camera.fov_rad = 0.42;
  return camera;
}

struct Box {
  float left = 1e9f, right = -1e9f, top = 1e9f, bottom = -1e9f;
};

Box pictureOf(const draw::Camera& camera, const std::vector<Vector3d>& points) {
  Box box;
  for (const Vector3d& p : points) {
    const glm::vec2 q = project(camera, toPicture(p));
    box.left = std::min(box.left, q.x);
    box.right = std::max(box.right, q.x);
    box.top = std::min(box.top, q.y);
    box.bottom = std::max(box.bottom, q.y);
  }
  return box;
}

const std::vector<Vector3d> kWide{{1, 3, 0}, {-1, -3, 0.2}, {0.5, 2, -0.4}}, kTall{{0, 0, 3}, {0.1, 0, -2}};

TEST(Framing, FillsTheWidthOrTheHeightUpToTheMargins) {
  const Margins margins{0.1, 0.05, 0.2, 0.1};
  const Box wide = pictureOf(frameAll(view(), {kWide, 0}, margins, {1000, 500}), kWide);
  EXPECT_NEAR(wide.left, 100, 0.1);
  EXPECT_NEAR(wide.right, 950, 0.1);
  EXPECT_GE(wide.top, 100);
  EXPECT_LE(wide.bottom, 450);
  const Box tall = pictureOf(frameAll(view(), {kTall, 0}, margins, {1000, 500}), kTall);
  EXPECT_NEAR(tall.top, 100, 0.1);
  EXPECT_NEAR(tall.bottom, 450, 0.1);
}

// The outline of a ball is farther out than its poles: points all over it must be inside, and reach the margin.
TEST(Framing, HoldsABall) {
  std::vector<Vector3d> ball;
  for (int i = 0; i < 200; ++i)
    for (int k = 0; k < 400; ++k) {
      const double a = M_PI * (i + 0.5) / 200, b = 2 * M_PI * k / 400;
      ball.emplace_back(0.8 * std::sin(a) * std::cos(b), 0.8 * std::sin(a) * std::sin(b), 0.8 * std::cos(a));
    }
  const Box box = pictureOf(frameAll(view(), {{}, 0.8}, {0.06, 0.06, 0.06, 0.06}, {1000, 500}), ball);
  EXPECT_NEAR(box.top, 30, 0.1);
  EXPECT_NEAR(box.bottom, 470, 0.1);
}

TEST(Framing, ZoomEnlarges) {
  scene::Camera near = view();
  near.zoom = 2;
  const auto width = [](const scene::Camera& c) {
    const Box box =
        pictureOf(frameAll(c, {{{0, 0.1, 0}, {0, -0.1, 0}}, 2}, {}, {1000, 500}), {{0, 0.1, 0}, {0, -0.1, 0}});
    return box.right - box.left;
  };
  EXPECT_NEAR(width(near) / width(view()), 2, 0.02);
}

TEST(Framing, DrawsAllOfItBetweenNearAndFar) {
  const draw::Camera camera = frameAll(view(), {kWide, 1}, {}, {1000, 500});
  for (const Vector3d& p : kWide) {
    EXPECT_GT(depthOf(camera, toPicture(p)), camera.near);
    EXPECT_LT(depthOf(camera, toPicture(p)), camera.far);
  }
}

}  // namespace
}  // namespace poinsot::stage
