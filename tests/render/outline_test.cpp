// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "render/cells.h"
#include "render/frustum_outline.h"

namespace poinsot::render {
namespace {

using glm::vec2;
using glm::vec3;

draw::Camera camera() { return draw::lookAt({10, 1, 2}, {0, 0, 0}, {0, 0, 1}, 0.3f, {400, 300}); }

double rho(const ScreenEllipse& e, vec2 p) {
  const vec2 q = p - e.centre_px;
  return std::sqrt(double(e.form.x) * q.x * q.x + 2 * double(e.form.y) * q.x * q.y + double(e.form.z) * q.y * q.y);
}

// The outline encloses the picture of every point of the surface, and touches the outermost.
TEST(EllipseOutline, EnclosesTheProjectionOfTheEllipsoid) {
  const draw::Camera c = camera();
  const vec3 centre(0.5f, -0.4f, 0.3f);
  const glm::mat3 axes_V(0.8f, 0.2f, 0, -0.1f, 0.4f, 0.1f, 0, -0.15f, 0.6f);
  const auto outline = ellipseOutline(c, toCamera(c, centre), glm::transpose(c.R_VC) * axes_V);
  double farthest = 0;
  for (int i = 0; i < 300; ++i) {
    for (int k = 0; k < 600; ++k) {
      const double lat = std::numbers::pi * (i + 0.5) / 300, lon = 2 * std::numbers::pi * k / 600;
      const vec3 s(std::sin(lat) * std::cos(lon), std::sin(lat) * std::sin(lon), std::cos(lat));
      farthest = std::max(farthest, rho(outline, project(c, centre + axes_V * s)));
    }
  }
  EXPECT_NEAR(farthest, 1, 2e-4);  // measured 5e-6 below 1: the densest point of the grid
}

TEST(EllipseOutline, ADiscSeenEdgeOnIsALine) {
  const draw::Camera c = draw::lookAt({10, 0, 0}, {0, 0, 0}, {0, 0, 1}, 0.3f, {400, 300});
  const glm::mat3 axes_V(vec3(1, 0, 0), vec3(0, 1, 0), vec3(0));  // horizontal, at eye level
  const auto outline = ellipseOutline(c, toCamera(c, vec3(0)), glm::transpose(c.R_VC) * axes_V);
  EXPECT_NEAR(outline.bounds.bottom - outline.bounds.top, 3, 0.2);  // the margins alone
  EXPECT_GT(outline.bounds.right - outline.bounds.left, 150);
}

TEST(FrustumOutline, FindsTheCapThatFacesTheEye) {
  const draw::Camera c = camera();
  const draw::Frustum towards{{0, 0, 0}, {1, 0, 0}, 0.3f, 0.3f, {}};
  const draw::Frustum away{{1, 0, 0}, {0, 0, 0}, 0.3f, 0.3f, {}};
  EXPECT_EQ(frustumOutline(c, towards).visibleCap, 2);
  EXPECT_EQ(frustumOutline(c, away).visibleCap, 1);
  // A cone's apex is not a cap, although the eye is far out along x.
  EXPECT_EQ(frustumOutline(c, {{0, 0, 0}, {1, 0, 0}, 0.3f, 0, {}}).visibleCap, 0);
}

TEST(FrustumOutline, IsEmptyBehindTheCamera) {
  EXPECT_TRUE(frustumOutline(camera(), {{20, 0, 0}, {21, 0, 0}, 0.3f, 0.3f, {}}).bounds.empty());
}

TEST(Cells, CoverTheBoundsOnceAndSeparateInsideFromEdge) {
  const PixelBounds bounds{1, 2, 198, 117};
  const auto inside = [](vec2 p) { return std::hypot(p.x - 100, p.y - 60) < 55; };
  const Cells cells = cutIntoCells(bounds, inside);
  std::map<std::pair<int, int>, int> times;
  const auto count = [&](const std::vector<Square>& squares) {
    int pixels = 0;
    for (const Square& square : squares) {
      const PixelBounds b = square.bounds();
      for (int y = int(b.top); y < int(b.bottom); ++y)
        for (int x = int(b.left); x < int(b.right); ++x, ++pixels) ++times[{x, y}];
    }
    return pixels;
  };
  EXPECT_EQ(count(cells.edge) + count(cells.full), 197 * 115);
  EXPECT_EQ(times.size(), 197 * 115);
  EXPECT_GT(count(cells.full), 0.4 * std::numbers::pi * 55 * 55);
  for (const Square& square : cells.full) {
    const PixelBounds b = square.bounds();
    for (const vec2& p :
         {vec2(b.left, b.top), vec2(b.right, b.top), vec2(b.left, b.bottom), vec2(b.right, b.bottom)})
      EXPECT_TRUE(inside(p));
  }
}

// OpenGL discards a point whose centre is outside the picture.
TEST(Squares, CoverARectangleOnceAndHaveTheirCentresInIt) {
  for (const PixelBounds& r :
       {PixelBounds{0, 0, 199, 121}, {64, 128, 192, 192}, {16, 48, 33, 49}, {7, 9, 8, 100}}) {
    std::vector<Square> squares;
    addSquares(squares, r);
    float area = 0;
    for (const Square& square : squares) {
      const PixelBounds b = square.bounds();
      area += square.side_px * square.side_px;
      EXPECT_TRUE(b.left >= r.left && b.top >= r.top && b.right <= r.right && b.bottom <= r.bottom);
      EXPECT_EQ(std::fmod(b.left, square.side_px) + std::fmod(b.top, square.side_px), 0);
      for (const Square& other : squares) {
        if (&other == &square) continue;
        const glm::vec2 apart = glm::abs(other.centre_px - square.centre_px);
        EXPECT_GE(std::max(apart.x, apart.y), 0.5f * (square.side_px + other.side_px));
      }
    }
    EXPECT_EQ(area, (r.right - r.left) * (r.bottom - r.top));
  }
}

}  // namespace
}  // namespace poinsot::render
