// SPDX-License-Identifier: Apache-2.0
// Moving cameras: where they stand, and that their subject stays in the frame at one scale.
#include "stage/camera_path.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "scene_samples.h"

namespace poinsot::stage {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr glm::ivec2 kSize(480, 270);
const std::string kOrbit = "[camera]\norbit = \"360 deg\"\n";
const std::string kMoves =
    "[camera]\nazimuth = \"20 deg\"\nelevation = \"10 deg\"\n[[timeline]]\nat = 2\nover = 4\n"
    "camera.azimuth = \"380 deg\"\n[[timeline]]\nat = 3\nover = 2\ncamera.elevation = \"60 deg\"\n"
    "[[timeline]]\nat = 7\ncamera.turn = \"-90 deg\"\n";
const std::string kZoom = "camera.zoom = 2\n";  // added to the last move

CameraPath pathOf(const std::string& text) {
  const scene::Scene scene = sample(text);
  return {scene.camera, scene.timeline, scene.time.duration_s};
}

TEST(CameraPath, StaysStillIfTheTimelineOnlyZooms) {
  const CameraPath path = pathOf("[[timeline]]\nat = 2\nspeed = 0.1\ncamera.zoom = 2\n");
  EXPECT_TRUE(path.still());
  EXPECT_EQ(path.directions().size(), 1u);
  EXPECT_EQ(path.at(0).azimuth_rad, path.at(9).azimuth_rad);
  EXPECT_EQ(path.at(9).zoom, 2);
}

TEST(CameraPath, OrbitsSteadily) {
  const CameraPath path = pathOf(kOrbit);
  EXPECT_FALSE(path.still());
  for (const double t : {0.0, 2.5, 7.0, 10.0})
    EXPECT_NEAR(path.at(t).azimuth_rad - path.at(0).azimuth_rad, 36 * t * kDegree, 1e-15);
}

TEST(CameraPath, TurnsByTheGivenAngleEvenBeyondAFullTurn) {
  const CameraPath path = pathOf(kMoves + kZoom);
  EXPECT_DOUBLE_EQ(path.at(2).azimuth_rad, 20 * kDegree);
  EXPECT_DOUBLE_EQ(path.at(4).azimuth_rad, 200 * kDegree);  // half of once round
  EXPECT_DOUBLE_EQ(path.at(6).azimuth_rad, 380 * kDegree);
  EXPECT_DOUBLE_EQ(path.at(5).elevation_rad, 60 * kDegree);
  EXPECT_NEAR(path.at(7.8).azimuth_rad, 290 * kDegree, 1e-15);
  EXPECT_DOUBLE_EQ(path.at(7.8).zoom, 2);
}

double distanceAt(const Stage& stage, double t) {
  return draw::depthOf(onlyList(stage, t, kSize).camera, glm::vec3(0));  // the target is as deep as the centre
}

TEST(MovingCamera, KeepsItsDistanceWhileItMoves) {
  for (const std::string& text : {kOrbit, kMoves}) {
    const Stage stage(sample(text));
    const double first = distanceAt(stage, 0);
    // Positions are floats; measured 2.3e-7 of the distance.
    for (double t = 0; t <= 10; t += 0.25) EXPECT_NEAR(distanceAt(stage, t), first, 1e-6 * first) << t;
  }
}

TEST(MovingCamera, ZoomsByTheFactor) {
  const Stage stage(sample(kMoves + kZoom));
  const auto unit_px = [&](double t) {
    return onlyList(stage, t, kSize).camera.scale_px(static_cast<float>(distanceAt(stage, t)));
  };
  EXPECT_NEAR(unit_px(8) / unit_px(0), 2, 1e-5);
}

TEST(MovingCamera, IsFarEnoughForEveryDirection) {
  const Stage moving(sample(kOrbit));
  double farthest = 0;
  for (int i = 0; i < 72; ++i) {
    const Stage still(sample("[camera]\nazimuth = \"" + std::to_string(5 * i - 180) + " deg\"\n"));
    farthest = std::max(farthest, distanceAt(still, 0));
  }
  // The path samples other directions than these: measured 5.4e-5 of the distance.
  EXPECT_NEAR(distanceAt(moving, 3), farthest, 2e-4 * farthest);
}

TEST(MovingCamera, KeepsThePlaneInTheFrame) {
  const Stage stage(sample(kOrbit));
  for (double t = 0; t <= 10; t += 0.5) {
    const draw::DrawList list = onlyList(stage, t, kSize);
    const draw::GridPlane& plane = list.planes.at(0);
    for (const auto& [a, b] : {std::array{1.f, 1.f}, {1.f, -1.f}, {-1.f, 1.f}, {-1.f, -1.f}}) {
      const glm::vec2 at = draw::project(list.camera, plane.centre_V + a * plane.u_V + b * plane.v_V);
      EXPECT_TRUE(at.x > 0 && at.x < kSize.x && at.y > 0 && at.y < kSize.y) << t << ": " << at.x << ", " << at.y;
    }
  }
}

TEST(MovingCamera, MovesWithoutJumps) {
  const Stage stage(sample(kMoves + kZoom));
  constexpr double h = 1.0 / 120;
  glm::vec3 before = onlyList(stage, 0, kSize).camera.eye_V;
  double farthest = 0;
  for (double t = h; t <= 10; t += h) {
    const glm::vec3 now = onlyList(stage, t, kSize).camera.eye_V;
    farthest = std::max(farthest, static_cast<double>(glm::distance(now, before)));
    before = now;
  }
  // A turn is fastest in its middle, 15/8 of once round in 4 s. Zoom and tilt add less than that.
  EXPECT_LT(farthest, 2 * 15.0 / 8 * 2 * std::numbers::pi / 4 * h * distanceAt(stage, 0));
}

}  // namespace
}  // namespace poinsot::stage
