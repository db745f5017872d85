// SPDX-License-Identifier: Apache-2.0
#include "stage/framing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

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

std::vector<Vector3d> ball(double radius) {
  std::vector<Vector3d> points;
  for (int i = 0; i < 200; ++i)
    for (int k = 0; k < 400; ++k) {
      const double a = M_PI * (i + 0.5) / 200, b = 2 * M_PI * k / 400;
      points.emplace_back(radius * Vector3d(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)));
    }
  return points;
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

// The outline of a ball is farther out than its poles: points all over the ball must be inside, and reach the
// margin.
TEST(Framing, FitsABallWithinTheMargins) {
  const Box box = pictureOf(frameAll(view(), {{}, 0.8}, {0.06, 0.06, 0.06, 0.06}, {1000, 500}), ball(0.8));
  EXPECT_NEAR(box.top, 30, 0.1);
  EXPECT_NEAR(box.bottom, 470, 0.1);
}

TEST(Framing, KeepsTheVerticalThroughTheCentreUpright) {
  const auto lean_px = [](const std::vector<Vector3d>& points) {
    const draw::Camera camera = frameAll(view(), {points, 0.5}, {}, {1000, 500});
    return project(camera, {0, 0, 1}).x - project(camera, {0, 0, -1}).x;
  };
  EXPECT_NEAR(lean_px(kWide), 0, 1e-3);
  EXPECT_NEAR(lean_px({{0, 2.5, 0}, {1, 3, 0}, {-2, -1, 0}}), 0, 1e-3);
  EXPECT_NEAR(lean_px({{0, 20, 0}}), 0, 1e-3);
}

TEST(Framing, FitsABallThatIsNotInTheMiddle) {
  for (const double aside : {3.0, 20.0}) {
    std::vector<Vector3d> all = ball(0.8);
    const Vector3d far = aside * Vector3d(-std::sin(view().azimuth_rad), std::cos(view().azimuth_rad), 0);
    all.push_back(far);
    const Box box = pictureOf(frameAll(view(), {{far}, 0.8}, {0.05, 0.1, 0.06, 0.06}, {1000, 500}), all);
    EXPECT_NEAR(box.left, 50, 0.1) << aside;
    EXPECT_NEAR(box.right, 900, 0.1) << aside;
  }
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

// Zoom works like a longer lens: the picture is the same, but larger. Points that the eye came near to stay in
// front of the eye.
TEST(Framing, ZoomScalesThePictureAboutItsMiddle) {
  std::vector<Vector3d> points = kWide;
  points.emplace_back(2.5 * cameraAxes_V(view()).col(2));  // towards the eye
  const draw::Camera whole = frameAll(view(), {points, 0}, {0.1, 0.05, 0.2, 0.1}, {1000, 500});
  const glm::vec2 middle(0.5 * 1000 * (1 + 0.1 - 0.05), 250);
  for (const double zoom : {0.05, 0.5, 5.0, 20.0}) {
    scene::Camera enlarged = view();
    enlarged.zoom = zoom;
    const draw::Camera camera = frameAll(enlarged, {points, 0}, {0.1, 0.05, 0.2, 0.1}, {1000, 500});
    for (const Vector3d& p : points) {
      const glm::vec2 expected = middle + static_cast<float>(zoom) * (project(whole, toPicture(p)) - middle);
      EXPECT_LT(glm::distance(project(camera, toPicture(p)), expected), 1e-3 * std::max(zoom, 1.0)) << zoom;
      EXPECT_GT(depthOf(camera, toPicture(p)), camera.near) << zoom;
    }
  }
}

TEST(Framing, IgnoresPassingPointsExceptForTheFarPlane) {
  const Vector3d far = -80 * cameraAxes_V(view()).col(2);
  const draw::Camera held = frameAll(view(), {kWide, 0}, {}, {1000, 500});
  const draw::Camera camera = frameAll(view(), {.points_V = kWide, .passing_V = {far}}, {}, {1000, 500});
  EXPECT_EQ(camera.eye_V, held.eye_V);
  EXPECT_EQ(camera.focal_px(), held.focal_px());
  EXPECT_LT(held.far, depthOf(held, toPicture(far)));
  EXPECT_GT(camera.far, depthOf(camera, toPicture(far)));
}

// ---- parallel rays ----

scene::Camera parallelView() {
  scene::Camera camera = view();
  camera.projection = scene::Projection::kOrthographic;
  return camera;
}

TEST(ParallelFraming, FillsTheWidthOrTheHeightUpToTheMargins) {
  const Margins margins{0.1, 0.05, 0.2, 0.1};
  const Box wide = pictureOf(frameAll(parallelView(), {kWide, 0}, margins, {1000, 500}), kWide);
  EXPECT_NEAR(wide.left, 100, 1e-3);
  EXPECT_NEAR(wide.right, 950, 1e-3);
  EXPECT_GE(wide.top, 100);
  EXPECT_LE(wide.bottom, 450);
  const Box tall = pictureOf(frameAll(parallelView(), {kTall, 0}, margins, {1000, 500}), kTall);
  EXPECT_NEAR(tall.top, 100, 1e-3);
  EXPECT_NEAR(tall.bottom, 450, 1e-3);
}

// The outline of a ball is a great circle, 0.06 of 500 px away from the border above and below.
TEST(ParallelFraming, FitsABallWithinTheMargins) {
  const Box box = pictureOf(frameAll(parallelView(), {{}, 0.8}, {}, {1000, 500}), ball(0.8));
  EXPECT_NEAR(box.top, 30, 0.1);  // 200 x 400 points miss the outline by up to 0.03 px
  EXPECT_NEAR(box.bottom, 470, 0.1);
  EXPECT_NEAR(box.left, 500 - 220, 0.1);
  EXPECT_NEAR(box.right, 500 + 220, 0.1);
}

// A length has the same pixels near the eye, far away and at the border. A wide angle of view changes nothing,
// because parallel rays have none.
TEST(ParallelFraming, KeepsEqualLengthsEqual) {
  scene::Camera camera = parallelView();
  const std::vector<Vector3d> corners{{-2, -2, -2}, {2, 2, 2}, {-2, 2, -2}, {2, -2, 2}, {-30, 0, 0}, {30, 0, 0}};
  for (const double fov : {0.05, 0.42, 2.0}) {
    camera.fov_rad = fov;
    const draw::Camera framed = frameAll(camera, {corners, 0}, {}, {1000, 500});
    const glm::vec2 step = project(framed, toPicture(Vector3d(0.3, 0.5, -0.2))) - project(framed, glm::vec3(0));
    for (const Vector3d& corner : corners) {
      const glm::vec2 there = project(framed, toPicture(Vector3d(corner + Vector3d(0.3, 0.5, -0.2)))) -
                              project(framed, toPicture(corner));
      EXPECT_LT(glm::distance(there, step), 1e-3f) << fov;
    }
    const Box box = pictureOf(framed, corners);
    EXPECT_NEAR(std::max((box.right - box.left) / 880, (box.bottom - box.top) / 440), 1, 1e-5) << fov;
  }
}

TEST(ParallelFraming, KeepsADeepSceneBetweenNearAndFar) {
  scene::Camera camera = parallelView();
  const double ca = std::cos(camera.azimuth_rad), sa = std::sin(camera.azimuth_rad);
  const double ce = std::cos(camera.elevation_rad), se = std::sin(camera.elevation_rad);
  const Vector3d along(ca * ce, sa * ce, se);
  const std::vector<Vector3d> deep{50 * along, -50 * along, {0.1, 0.2, 0}};
  for (const double zoom : {0.05, 1.0, 20.0}) {
    camera.zoom = zoom;
    const draw::Camera framed = frameAll(camera, {deep, 0.3}, {}, {1000, 500});
    for (const Vector3d& p : deep) {
      EXPECT_GT(depthOf(framed, toPicture(p)), framed.near) << zoom;
      EXPECT_LT(depthOf(framed, toPicture(p)), framed.far) << zoom;
    }
    EXPECT_GT(framed.near, 0);
  }
}

TEST(ParallelFraming, ZoomEnlarges) {
  scene::Camera near = parallelView();
  near.zoom = 2;
  const auto unit = [](const scene::Camera& c) { return frameAll(c, {kWide, 1}, {}, {1000, 500}).focal_px(); };
  EXPECT_FLOAT_EQ(unit(near) / unit(parallelView()), 2);
}

TEST(ParallelFraming, ComputesThePixelsPerUnitOfLength) {
  const Extent extent{kWide, 1};
  const double unit = fittingUnit_px(parallelView(), extent, {}, {1000, 500});
  EXPECT_NEAR(frameAll(parallelView(), extent, {}, {1000, 500}).focal_px(), unit, 1e-3);
  EXPECT_NEAR(frameAll(parallelView(), extent, {}, {1000, 500}, unit / 3).focal_px(), unit / 3, 1e-3);
}

TEST(Framing, KeepsAllPointsBetweenNearAndFar) {
  const draw::Camera camera = frameAll(view(), {kWide, 1}, {}, {1000, 500});
  for (const Vector3d& p : kWide) {
    EXPECT_GT(depthOf(camera, toPicture(p)), camera.near);
    EXPECT_LT(depthOf(camera, toPicture(p)), camera.far);
  }
}

}  // namespace
}  // namespace poinsot::stage
