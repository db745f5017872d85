// SPDX-License-Identifier: Apache-2.0
#include "figure/visibility_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "figure/visibility.h"

namespace poinsot::figure {
namespace {

/// Returns an empty list, seen from 10 away along x.
draw::DrawList emptyList() {
  draw::DrawList list;
  list.camera = draw::lookAt({10, 0, 0}, {0, 0, 0}, {0, 0, 1}, 0.8f, {600, 400});
  list.camera.near = 1;
  return list;
}

draw::Ellipsoid solid(glm::vec3 s) {
  return {glm::vec3(0), glm::mat3({s.x, 0, 0}, {0, s.y, 0}, {0, 0, s.z}), {}, {}, 0};
}

draw::Curve line(glm::vec3 from_V, glm::vec3 to_V, draw::Color color = {0, 0, 0}) {
  draw::Curve curve;
  curve.points_V = {from_V, to_V};
  curve.material.color = color;
  return curve;
}

glm::dvec2 pixel(const draw::DrawList& list, glm::dvec3 p_V) {
  return projectExactly(list.camera, toCameraExactly(list.camera, p_V));
}

double lengthOf(const SeenLine& seen) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < seen.points_px.size(); ++i)
    length += glm::distance(seen.points_px[i], seen.points_px[i + 1]);
  return length;
}

TEST(SeenLines, AStraightLineKeepsTwoPoints) {
  draw::DrawList list = emptyList();
  list.curves.push_back(line({0, -2, 0}, {0, 2, 0.5f}));
  const auto seen = seenLines(list);
  ASSERT_EQ(seen.size(), 1u);
  ASSERT_EQ(seen[0].points_px.size(), 2u);
  EXPECT_NEAR(glm::distance(seen[0].points_px[0], pixel(list, {0, -2, 0})), 0, 1e-9);
  EXPECT_NEAR(glm::distance(seen[0].points_px[1], pixel(list, {0, 2, 0.5})), 0, 1e-9);
  EXPECT_EQ(seen[0].color, draw::Color(0));
}

// The line pierces the ellipsoid x² + y²/4 + z²/0.25 = 1 where (1.5 s)² + (3 s)²/4 = 1. The line leaves the
// ellipsoid's shadow at the tangent from the eye (10, 0, 0), which touches at x = 1/10: 3 s = y0 (10 + 1.5 s) /
// 9.9.
TEST(SeenLines, ACurveThroughAnEllipsoidIsSplitWhereItIsHidden) {
  draw::DrawList list = emptyList();
  list.ellipsoids.push_back(solid({1, 2, 0.5f}));
  list.curves.push_back(line({1.5f, -3, 0}, {-1.5f, 3, 0}));
  const auto seen = seenLines(list);
  ASSERT_EQ(seen.size(), 2u);
  const double entry = -1 / std::sqrt(4.5), k = 2 * std::sqrt(0.99) / 9.9, exit = 10 * k / (3 - 1.5 * k);
  const auto at = [&](double s) { return pixel(list, {-1.5 * s, 3 * s, 0}); };
  // Measured 0.04 and 0.094 px: cuts are bisected to 0.1 px, and a piece ends on the seen side of its cut.
  EXPECT_LT(glm::distance(seen[0].points_px.back(), at(entry)), 0.1);
  EXPECT_LT(glm::distance(seen[1].points_px.front(), at(exit)), 0.1);
  EXPECT_NEAR(glm::distance(seen[0].points_px.front(), at(-1)), 0, 1e-9);
  EXPECT_NEAR(glm::distance(seen[1].points_px.back(), at(1)), 0, 1e-9);
}

TEST(SeenLines, ALineBehindGlassHasADimmedColour) {
  draw::DrawList list = emptyList();
  draw::GlassEllipsoid glass;
  glass.color = {0.1f, 0.2f, 0.9f};
  glass.nearOpacity = glass.farOpacity = glass.rimOpacity = 0.5f;
  list.glassEllipsoids.push_back(glass);
  list.curves.push_back(line({-3, -3, 0}, {-3, 3, 0}, {1, 0, 0}));
  const auto seen = seenLines(list);
  ASSERT_EQ(seen.size(), 3u);
  const auto& middle = seen[1];
  EXPECT_NEAR(middle.color.r, 0.25 * 1 + 0.75 * 0.1, 1e-6);
  EXPECT_NEAR(middle.color.b, 0.75 * 0.9, 1e-6);
  // The sphere hides the line as far as the tangent from the eye: y = 13 * 0.1 / sqrt(0.99). Ends overlap by 0.3
  // px.
  const double edge = 13 * 0.1 / std::sqrt(0.99);
  EXPECT_NEAR(middle.points_px.front().x, pixel(list, {-3, -edge, 0}).x, 0.4);
  EXPECT_NEAR(middle.points_px.back().x, pixel(list, {-3, edge, 0}).x, 0.4);
}

TEST(SeenLines, AHalfHiddenClosedCurveIsOnePiece) {
  draw::Curve ring;
  ring.closed = true;
  for (int i = 0; i < 200; ++i) {
    const float a = 0.031415926f * static_cast<float>(i);
    ring.points_V.push_back({1.5f * std::cos(a), 1.5f * std::sin(a), 0});
  }
  draw::DrawList list = emptyList();
  list.curves.push_back(ring);
  auto seen = seenLines(list);
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_TRUE(seen[0].closed);
  // The ring starts in front of the ball and passes behind it, so that its seen part is one piece across its
  // start.
  list.ellipsoids.push_back(solid({1, 1, 1}));
  seen = seenLines(list);
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_FALSE(seen[0].closed);
}

// Every point of the line must lie within the tolerance of the circle's picture; 0.05 px is promised.
TEST(SeenLines, DropsPointsOnlyWithinTheTolerance) {
  draw::Curve ring;
  ring.closed = true;
  for (int i = 0; i < 5000; ++i) {
    const double a = 2 * M_PI * i / 5000;
    ring.points_V.push_back({0, static_cast<float>(std::cos(a)), static_cast<float>(std::sin(a))});
  }
  draw::DrawList list = emptyList();
  list.curves.push_back(ring);
  const auto seen = seenLines(list);
  ASSERT_EQ(seen.size(), 1u);
  const double radius = glm::distance(pixel(list, {0, 1, 0}), pixel(list, {0, 0, 0}));
  const auto& points = seen[0].points_px;
  EXPECT_LT(points.size(), 160u);  // measured 128 of 1500
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::dvec2 middle = 0.5 * (points[i] + points[(i + 1) % points.size()]);
    EXPECT_NEAR(glm::distance(middle, pixel(list, {0, 0, 0})), radius, 0.051);
  }
}

// Two lines cross twice, and each is once over the other: no order of whole lines is right.
TEST(SeenLines, CrossingLinesArePaintedFromFarToNear) {
  draw::DrawList list = emptyList();
  list.curves.push_back(line({0, -2, 0}, {0, 2, 0}, {1, 0, 0}));
  draw::Curve woven;  // in front of the first at y = -1, behind it at y = 1
  for (int i = 0; i <= 200; ++i) {
    const float y = -2 + 0.02f * static_cast<float>(i);
    woven.points_V.push_back({y < 0 ? 0.5f : -0.5f, y, 0.5f * (std::abs(y) - 1)});
  }
  woven.material.color = {0, 0, 1};
  list.curves.push_back(woven);
  const auto seen = seenLines(list);

  const auto paintedLast = [&](glm::dvec2 place) {
    draw::Color top{0};
    for (const SeenLine& s : seen)
      for (std::size_t i = 0; i + 1 < s.points_px.size(); ++i) {
        const glm::dvec2 a = s.points_px[i], along = s.points_px[i + 1] - a;
        const double share = glm::clamp(glm::dot(place - a, along) / glm::dot(along, along), 0.0, 1.0);
        if (glm::distance(place, a + share * along) < 1) top = s.color;
      }
    return top;
  };
  // In perspective, the second line crosses the first line's picture where its z is 0, at |y| = 1.
  EXPECT_EQ(paintedLast(pixel(list, {0.5, -1, 0})), draw::Color(0, 0, 1));
  EXPECT_EQ(paintedLast(pixel(list, {-0.5, 1, 0})), draw::Color(1, 0, 0));
  double red = 0;
  for (const SeenLine& s : seen) red += s.color.r > 0 ? lengthOf(s) : 0;
  EXPECT_NEAR(red, glm::distance(pixel(list, {0, -2, 0}), pixel(list, {0, 2, 0})),
              6);  // pieces overlap by a pixel
}

TEST(SeenLines, PartsBehindTheCameraAreLeftOut) {
  draw::DrawList list = emptyList();
  list.curves.push_back(line({0, 0, 0}, {12, 1, 0}));
  EXPECT_TRUE(seenLines(list).empty());
  list.curves[0].points_V = {{0, -1, 0}, {0, 1, 0}, {12, 1, 0}, {0, 2, 0}, {0, 3, 0}};
  EXPECT_EQ(seenLines(list).size(), 2u);
}

TEST(SeenLines, TubesAreOmittedBecauseTheyAreSurfaces) {
  draw::DrawList list = emptyList();
  list.curves.push_back(line({0, -2, 0}, {0, 2, 0}));
  list.curves[0].radius_V = 0.1f;
  EXPECT_TRUE(seenLines(list).empty());
}

}  // namespace
}  // namespace poinsot::figure
