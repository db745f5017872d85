// SPDX-License-Identifier: Apache-2.0
// The stability map as values: the colour of a direction of L, compared with Euler's equations integrated here.
#include "stage/stability_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "core/error.h"
#include "core/magma.h"
#include "ink.h"
#include "scene_samples.h"
#include "stage/figures/globe.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

constexpr glm::ivec2 kSize{1280, 720};
const Vector3d kMoments(2, 3, 4), kOmega(1, 0.5, 1.6);  // of sample()

bool contains(const std::vector<glm::vec2>& polygon, glm::vec2 p) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const glm::vec2 a = polygon[i], b = polygon[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) inside = !inside;
  }
  return inside;
}

/// Returns the time between two sign changes of L's middle component, by the Runge-Kutta method of fourth order.
double integratedInterval(Vector3d m) {
  const auto rate = [](const Vector3d& v) -> Vector3d { return v.cross(v.cwiseQuotient(kMoments)); };
  constexpr double h = 1e-3;
  std::vector<double> crossings;
  for (int i = 0; crossings.size() < 2; ++i) {
    const Vector3d a = rate(m), b = rate(m + 0.5 * h * a), c = rate(m + 0.5 * h * b), d = rate(m + h * c);
    const Vector3d next = m + h / 6 * (a + 2 * b + 2 * c + d);
    if ((m.y() < 0) != (next.y() < 0)) crossings.push_back(h * (i + m.y() / (m.y() - next.y())));
    m = next;
  }
  return crossings[1] - crossings[0];
}

/// Returns the globe of the map, whose rim is the first area. The eye stands 0.66 rad aside from e2 and 0.42 rad
/// above.
Globe globeOf(const draw::Picture& picture) {
  glm::dvec2 low(1e9), high(0);
  for (const glm::vec2& p : picture.areas.front().points_px) {
    low = glm::min(low, glm::dvec2(p));
    high = glm::max(high, glm::dvec2(p));
  }
  const Vector3d eye(std::sin(0.66) * std::cos(0.42), std::cos(0.66) * std::cos(0.42), std::sin(0.42));
  return Globe(eye, Vector3d::UnitZ(), 0.5 * (low + high), 0.5 * (high.x - low.x));
}

draw::Color colorAt(const draw::Picture& picture, glm::vec2 at) {
  draw::Color color(-1);
  for (const draw::Area& area : picture.areas)
    if (contains(area.points_px, at)) color = area.color;
  return color;
}

/// Returns the index of a colour in the magma table, or -1.
int entryOf(const draw::Color& color) {
  for (std::size_t i = 0; i < 256; ++i) {
    const auto rgb = core::magma(i);
    if (draw::srgb8FromLinear(color.r) == rgb[0] && draw::srgb8FromLinear(color.g) == rgb[1] &&
        draw::srgb8FromLinear(color.b) == rgb[2])
      return static_cast<int>(i);
  }
  return -1;
}

TEST(StabilityMap, ColoursMatchIntegratedEulerEquations) {
  const scene::Scene scene = sample();
  const StabilityMap map(scene);
  const draw::Picture picture = map.compose(0, kSize);
  const Globe globe = globeOf(picture);
  const double L = kMoments.cwiseProduct(kOmega).norm();
  int seen = 0, told = 0;
  for (int i = 0; i < 12; ++i)
    for (int j = 1; j < 8; ++j) {
      const double azimuth = 2 * 3.14159265358979 * (i + 0.3) / 12, polar = 3.14159265358979 * j / 8;
      const Vector3d d(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar));
      if (!globe.shows(d)) continue;
      ++seen;
      const double share = map.scale().share(integratedInterval(L * d));
      told += share < 1;
      // Bands are 2.4 entries wide, and entries are whole, so that the colour is right to three entries.
      const double expected = 255 * (0.1 + 0.9 * std::min(share, 1.0));
      EXPECT_NEAR(entryOf(colorAt(picture, globe.at_px(d))), expected, 3) << d.transpose();
    }
  EXPECT_GE(seen, 35);
  EXPECT_GE(told, 30);
}

// The scale begins at pi over the faster rate of circling about the axis of smallest or largest moment. It ends at
// the longer time for a direction one degree from the middle axis.
TEST(StabilityScale, RangesFromSteadySpinToOneDegreeOffTheMiddleAxis) {
  const double L = 5;
  const StabilityScale scale(physics::PrincipalMoments(kMoments), L);
  // Linearised Euler's equations: w² = (I_k - I_i)(I_k - I_j)/(I_i I_j) times the square of the spin.
  const double about1 = 3.14159265358979 / (L / 2 * std::sqrt(1.0 * 2.0 / 12));
  const double about3 = 3.14159265358979 / (L / 4 * std::sqrt(1.0 * 2.0 / 6));
  EXPECT_NEAR(scale.least_s(), std::min(about1, about3), 1e-12);
  const double degree = 3.14159265358979 / 180;
  const double toOne = integratedInterval(L * Vector3d(std::sin(degree), std::cos(degree), 0));
  const double toThree = integratedInterval(L * Vector3d(0, std::cos(degree), std::sin(degree)));
  EXPECT_NEAR(scale.most_s() / std::max(toOne, toThree), 1, 1e-6);
  EXPECT_NEAR(scale.share(scale.timeAt(0.3)), 0.3, 1e-12);
  EXPECT_EQ(scale.color(0.5), scale.color(0.5));
}

// Two moments are nearly equal. The times differ so much that the scale is even in their logarithms.
TEST(StabilityScale, IsLogarithmicIfTimesDifferMuch) {
  const StabilityScale near(physics::PrincipalMoments({1, 1.001, 1.9}), 1);
  EXPECT_TRUE(near.isLogarithmic());
  EXPECT_NEAR(near.timeAt(0.5), std::sqrt(near.least_s() * near.most_s()), 1e-9 * near.most_s());
  for (const auto& tick : near.ticks(1)) {
    EXPECT_GE(tick.time_s, near.least_s());
    EXPECT_LE(tick.time_s, near.most_s());
    EXPECT_NEAR(std::stod(tick.digits), tick.time_s, 1e-9 * tick.time_s);
  }
  EXPECT_GE(near.ticks(1).size(), 2u);
}

// The separatrix is two great circles through the middle axis, m_3/m_1 = ± sqrt(I3 (I2 - I1)/(I1 (I3 - I2))) = ±
// sqrt 2.
TEST(StabilityMap, DrawsTheSeparatrixAsTwoGreatCircles) {
  const draw::Picture picture = StabilityMap(sample()).compose(0, kSize);
  const Globe globe = globeOf(picture);
  const draw::Color color = palette(scene::Theme::kLight).separatrix;
  for (const double sign : {-1.0, 1.0}) {
    const Vector3d d = Vector3d(1, 1, sign * std::sqrt(2)).normalized();
    ASSERT_TRUE(globe.shows(d));
    float nearest = 1e9f;
    for (const draw::Stroke& stroke : picture.strokes)
      if (stroke.color == color && stroke.points_px.size() > 2)
        for (const glm::vec2& p : stroke.points_px) nearest = std::min(nearest, glm::distance(p, globe.at_px(d)));
    EXPECT_LT(nearest, 4) << sign;  // points of the curve are 6 px apart
  }
}

TEST(StabilityMap, MarksTheScenesLAndNamesTheAxes) {
  for (const char* omega : {"[1, 0.5, 1.6]", "[-1, 0.5, -1.6]", "[0.01, -4, -0.01]"}) {
    const scene::Scene scene = scene::parseScene(
        "[body]\nprincipal_moments = [2, 3, 4]\n[motion]\nomega_body = " + std::string(omega), "sample.toml");
    const draw::Picture picture = StabilityMap(scene).compose(0, kSize);
    int names = 0, marks = 0;
    for (const draw::Text& text : picture.texts) {
      names += text.tex.find("\\mathbf{e}") != std::string::npos;
      marks += text.tex.find("\\mathbf{L}") != std::string::npos;
      const PixelBox ink = inkOf(text);
      EXPECT_TRUE(ink.left >= 0 && ink.top >= 0 && ink.right <= kSize.x && ink.bottom <= kSize.y) << text.tex;
    }
    EXPECT_EQ(names, 3);
    EXPECT_EQ(marks, 4);  // in the subtitle, in |L|, on the sphere and at the scale
  }
}

TEST(StabilityMap, IsTheSameAtAllTimesAndFitsAnyPicture) {
  const StabilityMap map(sample());
  EXPECT_EQ(map.compose(0, kSize).areas.size(), map.compose(9, kSize).areas.size());
  for (const glm::ivec2 size : {glm::ivec2(500, 800), glm::ivec2(800, 200), glm::ivec2(16, 16)}) {
    const draw::Picture picture = map.compose(0, size);
    EXPECT_EQ(picture.size_px, size);
    EXPECT_GT(picture.areas.size(), 100u);
  }
  EXPECT_NEAR(map.sceneTime_s() / integratedInterval(kMoments.cwiseProduct(kOmega)), 1, 1e-6);
}

// Bodies at the limits of what a scene may have: nearly symmetric ones, rods, planets, grains, slow and fast.
TEST(StabilityMap, WorksForAnyBodyThatFlips) {
  for (const char* text : {"[1, 1.000000000001, 2]\n[motion]\nomega_body = [1, 0.5, 1.6]",
                           "[1, 1.999999999999, 2]\n[motion]\nomega_body = [0, 1, 0]",
                           "[1e-9, 1, 1.0000000005]\n[motion]\nomega_body = [1, 1, 1]",
                           "[1e50, 2e50, 2.5e50]\n[motion]\nomega_body = [1e-30, 1e-32, 0]",
                           "[1e-50, 2.5e-50, 2e-50]\n[motion]\nomega_body = [1e30, 1e32, 0]",
                           "[3, 1, 2]\n[motion]\nomega_body = [0, 0, 1]"}) {
    SCOPED_TRACE(text);
    const StabilityMap map(
        scene::parseScene(std::string("[body]\nprincipal_moments = ") + text + "\n", "sample.toml"));
    EXPECT_TRUE(map.scale().least_s() > 0 && map.scale().least_s() < map.scale().most_s());
    const draw::Picture picture = map.compose(0, {640, 360});
    EXPECT_GE(map.scale().ticks(1).size(), 1u);
    for (const draw::Area& area : picture.areas)
      for (const glm::vec2& p : area.points_px)
        ASSERT_TRUE(p.x >= -1 && p.y >= -1 && p.x <= 641 && p.y <= 361) << p.x << " " << p.y;
  }
}

std::string refusal(const std::string& text) {
  try {
    StabilityMap map(scene::parseScene(text, "sample.toml"));
  } catch (const core::Error& error) {
    EXPECT_EQ(error.kind(), core::ErrorKind::kPhysics);
    return error.what();
  }
  return "none";
}

TEST(StabilityMap, RejectsBodiesThatDoNotFlip) {
  const std::string nothing =
      "L = false\nomega = false\nellipsoid = false\nplane = false\ncontact = false\npolhode = false\n"
      "herpolhode = false\nheight = false\n";
  const std::string start = "[motion]\nomega_body = [1, 0.5, 1.6]\n";
  for (const char* moments : {"[2, 2, 3]", "[2, 3, 3]", "[2, 2, 2]"})
    EXPECT_THAT(refusal("[body]\nprincipal_moments = " + std::string(moments) + "\n" + start),
                HasSubstr("two principal moments are equal: such a body has no middle axis, and never flips"));
  EXPECT_THAT(refusal("[body]\nprincipal_moments = [2, 3, 4]\n[show]\n" + nothing +
                      "[motion]\nomega_body = [0, 0, 0]\norientation = [1, 0, 0, 0]\n"),
              HasSubstr("at rest"));
  EXPECT_THAT(refusal("[body]\nprincipal_moments = [2, 3, 4]\n" + start + "drag.rate = 0.1\n"),
              HasSubstr("not free"));
}

// A circle round the eye's direction is whole, a circle round a point of the rim is half, and a circle behind is
// absent.
TEST(Globe, ClipsCirclesAtItsRim) {
  const Globe globe(Vector3d::UnitX(), Vector3d::UnitZ(), {100, 100}, 50);
  const auto circle = [](const Vector3d& about, double angle) {
    const Vector3d u = about.unitOrthogonal(), v = about.cross(u);
    std::vector<Vector3d> points;
    for (int i = 0; i < 60; ++i) {
      const double a = 2 * 3.14159265358979 * i / 60;
      points.push_back(std::cos(angle) * about + std::sin(angle) * (std::cos(a) * u + std::sin(a) * v));
    }
    return points;
  };
  const auto areaOf = [](const std::vector<glm::vec2>& p) {
    double sum = 0;
    for (std::size_t i = 0, j = p.size() - 1; i < p.size(); j = i++)
      sum += static_cast<double>(p[j].x) * static_cast<double>(p[i].y) -
             static_cast<double>(p[i].x) * static_cast<double>(p[j].y);
    return 0.5 * std::abs(sum);
  };
  const auto part = [&](const Vector3d& about, double angle) {
    return areaOf(globe.visiblePart(circle(about, angle),
                                    [&](const Vector3d& d) { return d.dot(about) > std::cos(angle); }));
  };
  constexpr double kPi = 3.14159265358979;
  EXPECT_NEAR(part(Vector3d::UnitX(), 0.5), kPi * std::pow(50 * std::sin(0.5), 2), 6);
  EXPECT_EQ(part(-Vector3d::UnitX(), 0.5), 0);
  // A cap of angle a round a point of the rim shows the segment that a chord at cos a cuts off the disc.
  const double segment = 2500 * (0.5 - std::sin(0.5) * std::cos(0.5));
  EXPECT_NEAR(part(Vector3d::UnitY(), 0.5), segment, 3);
  // The globe without such a cap goes the other way along the rim.
  EXPECT_NEAR(part(-Vector3d::UnitY(), kPi - 0.5), kPi * 2500 - segment, 12);
  EXPECT_EQ(globe.at_px(Vector3d::UnitZ()), glm::vec2(100, 50));
  EXPECT_EQ(globe.at_px(Vector3d::UnitY()), glm::vec2(150, 100));
}

}  // namespace
}  // namespace poinsot::stage
