// SPDX-License-Identifier: Apache-2.0
#include "render/curve_strip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace poinsot::render {
namespace {

draw::Camera camera() { return draw::lookAt({10, 0, 0}, {0, 0, 0}, {0, 0, 1}, 0.3f, {400, 300}); }

TEST(CurveStrip, OfFewerThanTwoPointsIsEmpty) {
  draw::Curve curve;
  EXPECT_TRUE(makeCurveStrip(camera(), curve).triangles.empty());
  curve.points_W = {{0, 0, 0}};
  EXPECT_TRUE(makeCurveStrip(camera(), curve).triangles.empty());
}

TEST(CurveStrip, ATubesWidthFollowsItsDistance) {
  draw::Curve curve;
  curve.points_W = {{0, -1, 0}, {0, 1, 0}};
  curve.radius_W = 0.1f;
  const float expected = 0.1f * camera().focal_px() / 10;
  for (const StripVertex& v : makeCurveStrip(camera(), curve).triangles) EXPECT_NEAR(v.across.y, expected, 1e-3);
}

TEST(CurveStrip, PartsBehindTheEyeAreLeftOut) {
  draw::Curve curve;
  curve.points_W = {{0, -1, 0}, {0, 1, 0}, {30, 1, 0}, {0, 1, 1}, {0, -1, 1}};
  for (const StripVertex& v : makeCurveStrip(camera(), curve).triangles) {
    EXPECT_TRUE(std::isfinite(v.position_px.x) && std::isfinite(v.position_px.y));
    EXPECT_GT(v.across.w, camera().near);
  }
}

// A hairpin seen flat folds back: no mitre may shoot out of it.
TEST(CurveStrip, AFoldHasNoSpike) {
  draw::Curve curve;
  curve.points_W = {{0, -1, 0}, {0, 1, 0.001f}, {0, -1, 0.002f}};
  curve.width_px = 4;
  const CurveStrip strip = makeCurveStrip(camera(), curve);
  const float right = project(camera(), {0, 1, 0}).x;
  EXPECT_LT(strip.bounds.right, right + 8);
}

TEST(CurveStrip, AClosedCurveHasNoEnds) {
  draw::Curve curve;
  for (int i = 0; i < 20; ++i)
    curve.points_W.push_back(
        {0, std::cos(0.314159f * static_cast<float>(i)), std::sin(0.314159f * static_cast<float>(i))});
  curve.closed = true;
  for (const StripVertex& v : makeCurveStrip(camera(), curve).triangles) EXPECT_GT(v.across.z, 1000);
}

float distanceTo(glm::vec2 from, glm::vec2 to, glm::vec2 p) {
  const glm::vec2 way = to - from;
  const float s = std::clamp(glm::dot(p - from, way) / glm::dot(way, way), 0.0f, 1.0f);
  return glm::distance(p, from + s * way);
}

/// From the middle of the picture's strip, where it is nearest.
float distanceFrom(const CurveStrip& strip, glm::vec2 p) {
  float least = 1e9f;
  for (std::size_t i = 0; i + 5 < strip.triangles.size(); i += 6) {
    const auto at = [&](std::size_t k) { return strip.triangles[i + k].position_px; };
    least = std::min(least, distanceTo(0.5f * (at(0) + at(1)), 0.5f * (at(2) + at(5)), p));
  }
  return least;
}

// Expected: a chord's height over an arc, c^2 / 8R, of 0.02 px at R of about 99 px is a chord of 4.0 px, so that
// 595 px need 149 pieces; the points lie 0.3 px apart. Measured: 156 pieces, 0.0188 px.
TEST(CurveStrip, PointsOnAStraightWayAreLeftOut) {
  draw::Curve curve;
  for (int i = 0; i < 2000; ++i) {
    const float angle = 0.003f * static_cast<float>(i);
    curve.points_W.emplace_back(0, std::cos(angle), std::sin(angle));
  }
  const CurveStrip strip = makeCurveStrip(camera(), curve);
  const std::size_t pieces = strip.triangles.size() / 6;
  EXPECT_GT(pieces, 149u);
  EXPECT_LT(pieces, 180u);
  float farthest = 0;
  for (const glm::vec3& p_W : curve.points_W)
    farthest = std::max(farthest, distanceFrom(strip, project(camera(), p_W)));
  EXPECT_LE(farthest, 0.0205f);
}

// What waves along the view alone keeps its waves.
TEST(CurveStrip, PointsAlongTheViewAreKept) {
  draw::Curve curve;
  for (int i = 0; i <= 200; ++i) {
    const float y = 0.01f * static_cast<float>(i - 100);
    curve.points_W.emplace_back(0.5f * std::sin(20 * y), y, 0);
  }
  float nearest = 100, farthest = 0;
  for (const StripVertex& v : makeCurveStrip(camera(), curve).triangles) {
    nearest = std::min(nearest, v.across.w);
    farthest = std::max(farthest, v.across.w);
  }
  EXPECT_NEAR(nearest, 9.5f, 0.001f);
  EXPECT_NEAR(farthest, 10.5f, 0.001f);
}

}  // namespace
}  // namespace poinsot::render
