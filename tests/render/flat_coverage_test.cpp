// SPDX-License-Identifier: Apache-2.0
// Checks areas of strokes and polygons that are worked out by hand: rectangles, discs and their overlaps.
#include "render/flat_coverage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "render/stroke_pieces.h"

namespace poinsot::render {
namespace {

using glm::vec2;
using std::numbers::pi;

constexpr glm::ivec2 kPicture{300, 200};

draw::Stroke strokeOf(std::vector<vec2> points, float width, float dash = 0, bool closed = false) {
  draw::Stroke stroke;
  stroke.points_px = std::move(points);
  stroke.width_px = width;
  stroke.dash_px = dash;
  stroke.closed = closed;
  return stroke;
}

double area(const text::CoverageMap& map) {
  return std::accumulate(map.values.begin(), map.values.end(), 0.0) / 255;
}
double area(const draw::Stroke& stroke) { return area(strokeCoverage(stroke, kPicture)); }

// The area is a rectangle and two half discs, at any angle and width.
TEST(StrokeCoverage, ALineHasItsAreaAndRoundEnds) {
  double worst = 0;
  for (const float width : {0.1f, 0.5f, 1.0f, 2.0f, 7.3f, 30.0f}) {
    for (int i = 0; i < 24; ++i) {
      const double angle = 2 * pi * i / 24, length = 10 + 3.3 * i, r = width / 2.0;
      const vec2 from(150.3f, 100.7f),
          to = from + vec2(glm::dvec2(length * std::cos(angle), length * std::sin(angle)));
      const double expected = length * width + pi * r * r;
      const double outline = 2 * length + 2 * pi * r;
      const double error = std::abs(area(strokeOf({from, to}, width)) - expected) / outline;
      worst = std::max(worst, error);
      // Each pixel of the outline is a byte, at most 1/510 off, and chords lie 0.003 within their arcs.
      EXPECT_LT(error, 0.004) << width << " at " << i;
    }
  }
  RecordProperty("worst_per_pixel_of_outline", std::to_string(worst));  // measured 0.0023
}

TEST(StrokeCoverage, CoverageOfAThinLineIsProportionalToItsWidth) {
  const auto map = strokeCoverage(strokeOf({{10, 50.5f}, {90, 50.5f}}, 0.25f), kPicture);
  for (int x = 12; x < 88; ++x) EXPECT_EQ(map.at(x, 50), 64) << x;  // 0.25 * 255 = 63.75
  EXPECT_EQ(map.at(50, 49), 0);
  EXPECT_EQ(map.at(50, 51), 0);
}

// A right angle covers two rectangles less the square that they share, a quarter disc outside, and two half discs.
TEST(StrokeCoverage, JoinsAreRoundOutsideAndSharpInside) {
  const float width = 12;
  const double r = 6, expected = 2 * 60 * 12 - r * r + pi * r * r / 4 + pi * r * r;
  EXPECT_NEAR(area(strokeOf({{100, 40}, {100, 100}, {160, 100}}, width)), expected, 0.1);  // measured 0.06
  const auto map = strokeCoverage(strokeOf({{100, 40}, {100, 100}, {160, 100}}, width), kPicture);
  EXPECT_EQ(map.at(106, 93), 0);  // beyond the inner corner (106, 94)
  EXPECT_EQ(map.at(105, 93), 255);
  EXPECT_EQ(map.at(94, 105), 0);  // the outer corner is rounded off: 8.1 pixels from the joint
}

TEST(StrokeCoverage, AClosedCircleHasTheAreaOfARing) {
  for (const int points : {12, 90, 5000}) {
    std::vector<vec2> circle;
    for (int i = 0; i < points; ++i) {
      const double s = 2 * pi * i / points;
      circle.emplace_back(glm::dvec2(150 + 80 * std::cos(s), 100 + 80 * std::sin(s)));
    }
    const double width = 5, side = 2 * 80 * std::sin(pi / points), bend = 2 * pi / points;
    const double kites =
        points * width * width / 4 * (bend / 2 - std::tan(bend / 2));  // each joint, outside less inside
    const double expected = points * side * width + kites;
    EXPECT_NEAR(area(strokeOf(circle, 5, 0, true)), expected, 1.0) << points;  // of 2500; measured 0.3
  }
}

// Laps on one another are one line: the largest coverage counts, not the sum.
TEST(StrokeCoverage, CountsRepeatedLapsOnce) {
  std::vector<vec2> once, ten;
  for (int i = 0; i <= 4000; ++i) {
    const double s = 2 * pi * i / 400;
    const vec2 p(glm::dvec2(150 + 80 * std::cos(s), 100 + 60 * std::sin(s)));
    ten.push_back(p);
    if (i < 400) once.push_back(p);
  }
  EXPECT_NEAR(area(strokeOf(ten, 2)), area(strokeOf(once, 2, 0, true)), 0.5);
}

TEST(StrokeCoverage, ExtraPointsOnALineDoNotChangeCoverage) {
  std::vector<vec2> fine;
  for (int i = 0; i <= 640; ++i) fine.push_back(vec2(20, 30) + vec2(0.4f, 0.2f) * static_cast<float>(i));
  const auto many = strokeCoverage(strokeOf(fine, 3), kPicture);
  const auto one = strokeCoverage(strokeOf({fine.front(), fine.back()}, 3), kPicture);
  int worst = 0;
  for (int y = 0; y < kPicture.y; ++y)
    for (int x = 0; x < kPicture.x; ++x) worst = std::max(worst, std::abs(many.at(x, y) - one.at(x, y)));
  EXPECT_LE(worst, 1);
}

TEST(StrokeCoverage, DashesAreMeasuredFromTheStart) {
  // 10 on, 10 off, round ends: dashes from 0, 20, 40, 60 and the rest of one at 80.
  const draw::Stroke stroke = strokeOf({{50.5f, 20}, {50.5f, 60}, {95.5f, 60}}, 3, 10);
  const double r = 1.5;
  EXPECT_NEAR(area(stroke), 4 * (30 + pi * r * r) + 5 * 3 + pi * r * r, 0.05);
  const auto map = strokeCoverage(stroke, kPicture);
  EXPECT_EQ(map.at(50, 25), 255);
  EXPECT_EQ(map.at(50, 35), 0);
  EXPECT_EQ(map.at(50, 45), 255);
  EXPECT_EQ(map.at(50, 55), 0);
  EXPECT_EQ(map.at(55, 60), 255);  // 45 along: the third
  EXPECT_EQ(map.at(66, 60), 0);    // 55 along
  EXPECT_EQ(map.at(93, 60), 255);  // 83 along
}

// The dashes inside the picture do not depend on the part outside.
TEST(StrokeCoverage, KeepsDashesOfALineThatBeginsOutsideThePicture) {
  const auto all = strokeCoverage(strokeOf({{-997.25f, 50}, {250, 50}}, 3, 10), {1300, 200});
  const auto map = strokeCoverage(strokeOf({{-997.25f, 50}, {250, 50}}, 3, 10), kPicture);
  for (int x = 0; x < 250; ++x) {
    EXPECT_EQ(map.at(x, 50), all.at(x, 50));
    const double along = std::fmod(x + 0.5 + 997.25, 20);
    if (along > 2.5 && along < 7.5) {
      EXPECT_EQ(map.at(x, 50), 255) << x;
    }
    if (along > 12.5 && along < 17.5) {
      EXPECT_EQ(map.at(x, 50), 0) << x;
    }
  }
}

TEST(StrokeCoverage, ClipsLinesToThePicture) {
  const PixelBounds picture{0, 0, 300, 200};
  EXPECT_TRUE(strokePieces(strokeOf({{-1e6f, -50}, {1e6f, -50}}, 3), picture).empty());
  EXPECT_LT(strokePieces(strokeOf({{-1e6f, 50}, {1e6f, 50}}, 3, 10), picture).size(), 20u);
  EXPECT_NEAR(area(strokeOf({{-1e6f, 50.5f}, {1e6f, 50.5f}}, 3)), 3 * 300, 1e-9);
}

TEST(StrokeCoverage, DrawsADotForAPointAndNothingForNoPoints) {
  EXPECT_NEAR(area(strokeOf({{100.2f, 80.9f}}, 9)), pi * 4.5 * 4.5, 0.1);
  EXPECT_NEAR(area(strokeOf({{100.2f, 80.9f}, {100.2f, 80.9f}}, 9, 0, true)), pi * 4.5 * 4.5, 0.1);
  EXPECT_EQ(area(strokeOf({}, 9)), 0);
  EXPECT_EQ(area(strokeOf({{10, 10}, {50, 50}}, 0)), 0);
}

TEST(StrokeCoverage, RejectsPointsThatAreNotFinite) {
  EXPECT_THROW(area(strokeOf({{0, 0}, {NAN, 1}}, 2)), std::logic_error);
  EXPECT_THROW(areaCoverage({{{0, 0}, {INFINITY, 1}, {3, 3}}, {}, 1}, kPicture), std::logic_error);
}

TEST(AreaCoverage, PolygonsHaveTheirArea) {
  // A triangle with base 100.5 and height 70.25; and the same walked the other way.
  const std::vector<vec2> triangle{{20.25f, 30.5f}, {120.75f, 30.5f}, {61.0f, 100.75f}};
  const double expected = 100.5 * 70.25 / 2;
  EXPECT_NEAR(area(areaCoverage({triangle, {}, 1}, kPicture)), expected, 0.3);  // bytes; measured 0.21
  EXPECT_NEAR(area(areaCoverage({{triangle.rbegin(), triangle.rend()}, {}, 1}, kPicture)), expected, 0.3);
}

TEST(AreaCoverage, ClipsPolygonsAtThePicture) {
  // A square on its corner about the middle, half diagonal 180: |x - 150| + |y - 100| <= 180.
  const std::vector<vec2> square{{330, 100}, {150, 280}, {-30, 100}, {150, -80}};
  // Four corners with legs of 70 (150 + 100 - 180) are missing from the picture's 300 x 200.
  EXPECT_NEAR(area(areaCoverage({square, {}, 1}, kPicture)), 300 * 200 - 2 * 70 * 70,
              0.6);  // 280 times half a byte
  EXPECT_EQ(area(areaCoverage({{{-50, -50}, {-10, -50}, {-10, -10}}, {}, 1}, kPicture)), 0);
  EXPECT_EQ(area(areaCoverage({{{-9, -9}, {900, -9}, {900, 900}, {-9, 900}}, {}, 1}, kPicture)), 300 * 200);
}

}  // namespace
}  // namespace poinsot::render
