// SPDX-License-Identifier: Apache-2.0
#include "render/curve_strip.h"

#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace
}  // namespace poinsot::render
