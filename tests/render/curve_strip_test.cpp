// SPDX-License-Identifier: Apache-2.0
#include "render/curve_strip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace poinsot::render {
namespace {

draw::Camera camera() { return draw::lookAt({10, 0, 0}, {0, 0, 0}, {0, 0, 1}, 0.3f, {400, 300}); }

TEST(CurveStrip, IsEmptyForFewerThanTwoPoints) {
  draw::Curve curve;
  EXPECT_TRUE(makeCurveStrip(camera(), curve).triangles.empty());
  curve.points_V = {{0, 0, 0}};
  EXPECT_TRUE(makeCurveStrip(camera(), curve).triangles.empty());
}

TEST(CurveStrip, ScalesTheWidthOfATubeWithDistance) {
  draw::Curve curve;
  curve.points_V = {{0, -1, 0}, {0, 1, 0}};
  curve.radius_V = 0.1f;
  const float expected = 0.1f * camera().focal_px() / 10;
  for (const StripVertex& v : makeCurveStrip(camera(), curve).triangles) EXPECT_NEAR(v.across.y, expected, 1e-3);
}

TEST(CurveStrip, PartsBehindTheEyeAreLeftOut) {
  draw::Curve curve;
  curve.points_V = {{0, -1, 0}, {0, 1, 0}, {30, 1, 0}, {0, 1, 1}, {0, -1, 1}};
  for (const StripVertex& v : makeCurveStrip(camera(), curve).triangles) {
    EXPECT_TRUE(std::isfinite(v.position_px.x) && std::isfinite(v.position_px.y));
    EXPECT_GT(v.across.w, camera().near);
  }
}

// A hairpin seen flat folds back on itself; no mitre may stick out of the fold.
TEST(CurveStrip, HasNoSpikeWhereACurveFoldsBack) {
  draw::Curve curve;
  curve.points_V = {{0, -1, 0}, {0, 1, 0.001f}, {0, -1, 0.002f}};
  curve.width_px = 4;
  const CurveStrip strip = makeCurveStrip(camera(), curve);
  const float right = project(camera(), {0, 1, 0}).x;
  EXPECT_LT(strip.bounds.right, right + 8);
}

TEST(CurveStrip, AClosedCurveHasNoEnds) {
  draw::Curve curve;
  for (int i = 0; i < 20; ++i)
    curve.points_V.push_back(
        {0, std::cos(0.314159f * static_cast<float>(i)), std::sin(0.314159f * static_cast<float>(i))});
  curve.closed = true;
  for (const StripVertex& v : makeCurveStrip(camera(), curve).triangles) EXPECT_GT(v.across.z, 1000);
}

/// Point of a strip's centre line that is nearest to a point of the picture.
struct Nearest {
  float distance_px = 1e9f, halfWidth_px = 0;
};

Nearest nearest(const CurveStrip& strip, glm::vec2 p) {
  Nearest best;
  for (std::size_t i = 0; i + 5 < strip.triangles.size(); i += 6) {
    const auto at = [&](std::size_t k) { return strip.triangles[i + k]; };
    const glm::vec2 from = 0.5f * (at(0).position_px + at(1).position_px);
    const glm::vec2 way = 0.5f * (at(2).position_px + at(5).position_px) - from;
    const float s = std::clamp(glm::dot(p - from, way) / glm::dot(way, way), 0.0f, 1.0f);
    const float distance = glm::distance(p, from + s * way);
    if (distance < best.distance_px) best = {distance, glm::mix(at(0).across.y, at(2).across.y, s)};
  }
  return best;
}

std::size_t pieces(const CurveStrip& strip) { return strip.triangles.size() / 6; }

draw::Curve circle() {
  draw::Curve curve;
  for (int i = 0; i < 2000; ++i) {
    const float angle = 6.2831853f / 2000 * static_cast<float>(i);
    curve.points_V.emplace_back(0, std::cos(angle), std::sin(angle));
  }
  return curve;
}

float farthest(const CurveStrip& strip, const draw::Curve& curve) {
  float far = 0;
  for (const glm::vec3& p_V : curve.points_V)
    far = std::max(far, nearest(strip, project(camera(), p_V)).distance_px);
  return far;
}

// Expected: the height of a chord over an arc, c^2 / 8R, is 0.02 px for a chord of 4.0 px at R = 99 px. A turn of
// 624 px then needs 156 pieces; the points lie 0.3 px apart. Measured: 167 pieces and two ends, 0.0177 px.
TEST(CurveStrip, DropsPointsThatAreAlmostOnAStraightLine) {
  const draw::Curve curve = circle();
  const CurveStrip strip = makeCurveStrip(camera(), curve);
  EXPECT_GE(pieces(strip), 156u);
  EXPECT_LE(pieces(strip), 180u);
  EXPECT_LE(farthest(strip, curve), 0.0205f);
}

TEST(CurveStrip, StaysClosedWhenPointsAreDropped) {
  draw::Curve curve = circle();
  curve.closed = true;
  const CurveStrip strip = makeCurveStrip(camera(), curve);
  EXPECT_LE(pieces(strip), 180u);
  for (const StripVertex& v : strip.triangles) EXPECT_GT(v.across.z, 1000);
  curve.points_V.push_back(curve.points_V.front());
  EXPECT_LE(farthest(strip, curve), 0.0205f);
}

TEST(CurveStrip, MergesAtMostSixteenPiecesIntoOne) {
  draw::Curve curve;
  for (int i = 0; i <= 99; ++i) curve.points_V.emplace_back(0, -1 + 0.02f * static_cast<float>(i), 0);
  EXPECT_EQ(pieces(makeCurveStrip(camera(), curve)), 7u + 2u);  // 99 pieces merge into 7; two ends
}

TEST(CurveStrip, KeepsThePointWhereACurveFoldsBack) {
  draw::Curve curve;
  for (int i = 0; i <= 200; ++i)
    curve.points_V.emplace_back(0, 1 - 0.01f * static_cast<float>(std::abs(i - 100)), 0);
  const CurveStrip strip = makeCurveStrip(camera(), curve);
  EXPECT_LE(farthest(strip, curve), 0.0205f);
}

// Towards the eye a tube widens as 1 / distance does, not linearly.
TEST(CurveStrip, KeepsTheWidthOfATubeThatPointsAtTheEye) {
  draw::Curve curve;
  curve.radius_V = 0.2f;
  for (int i = 0; i <= 300; ++i) curve.points_V.emplace_back(0.02f * static_cast<float>(i), 0.5f, 0.3f);
  const CurveStrip strip = makeCurveStrip(camera(), curve);
  EXPECT_LT(pieces(strip), 150u);
  float most = 0;
  for (const glm::vec3& p_V : curve.points_V) {
    const float expected = curve.radius_V * camera().focal_px() / (10 - p_V.x);
    most = std::max(most, std::abs(nearest(strip, project(camera(), p_V)).halfWidth_px - expected));
  }
  EXPECT_LE(most, 0.0205f);
}

TEST(CurveStrip, KeepsTheDepthOfWavesTowardsTheEye) {
  draw::Curve curve;
  for (int i = 0; i <= 200; ++i) {
    const float y = 0.01f * static_cast<float>(i - 100);
    curve.points_V.emplace_back(0.5f * std::sin(20 * y), y, 0);
  }
  float near = 100, far = 0;
  for (const StripVertex& v : makeCurveStrip(camera(), curve).triangles) {
    near = std::min(near, v.across.w);
    far = std::max(far, v.across.w);
  }
  EXPECT_NEAR(near, 9.5f, 0.001f);
  EXPECT_NEAR(far, 10.5f, 0.001f);
}

}  // namespace
}  // namespace poinsot::render
