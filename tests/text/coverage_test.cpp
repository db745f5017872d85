// SPDX-License-Identifier: Apache-2.0
#include "text/coverage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "text/font_oracle.h"
#include "text/math_setter.h"

namespace poinsot::text {
namespace {

struct Moments {
  double area_px2 = 0;
  double x_px = 0;
  double y_px = 0;
};

Moments momentsOf(const CoverageMap& map) {
  Moments m;
  for (int y = map.top; y < map.top + map.height; ++y)
    for (int x = map.left; x < map.left + map.width; ++x) {
      const double covered = map.at(x, y) / 255.0;
      m.area_px2 += covered;
      m.x_px += covered * (x + 0.5);
      m.y_px += covered * (y + 0.5);
    }
  m.x_px /= m.area_px2;
  m.y_px /= m.area_px2;
  return m;
}

// Expected: the shoelace area of the outline, which the test reads from the font's file and flattens. Measured:
// 4.2e-4 at worst, from rounding to bytes; bound 2e-3.
TEST(Coverage, SumsToTheAreaOfTheOutlines) {
  const testing::FontOracle font;
  for (const char* tex :
       {"L", "e", "o", "Poinsot", "$\\boldsymbol{\\omega}$", "$\\hat{\\mathbf{e}}_1$", "$\\frac{2T}{L}$"})
    for (const double size_px : {64.0, 120.0, 300.0}) {
      const GlyphRun run = setTex(tex);
      double expected = 0;
      for (const PlacedGlyph& g : run.glyphs) expected += g.scale * g.scale * font.area(g.id);
      for (const Rule& r : run.rules) expected += r.width_em * r.height_em;
      expected *= size_px * size_px;
      const double error = momentsOf(rasterize(run, size_px, 10.3, 80.7)).area_px2 / expected - 1;
      EXPECT_LT(std::abs(error), 2e-3) << tex << " at " << size_px;
    }
}

TEST(Coverage, HasTheBoundsOfTheInk) {
  const GlyphRun run = setTex("$\\hat{\\mathbf{e}}_1$");
  const double size_px = 50, x_px = 100.25, y_px = 60.5;
  const CoverageMap map = rasterize(run, size_px, x_px, y_px);
  EXPECT_EQ(map.left, static_cast<int>(std::floor(x_px + size_px * run.inkLeft_em)));
  EXPECT_EQ(map.left + map.width, static_cast<int>(std::ceil(x_px + size_px * run.inkRight_em)));
  EXPECT_EQ(map.top, static_cast<int>(std::floor(y_px - size_px * run.inkTop_em)));
  EXPECT_EQ(map.top + map.height, static_cast<int>(std::ceil(y_px - size_px * run.inkBottom_em)));
}

// A pixel's ink counts at its centre, so that the centroid of an upright stem w pixels wide is off by up to 1/(8
// w). Large type keeps that small. Measured: 0.0051 px at worst; bound 0.01.
TEST(Coverage, FollowsSubPixelShifts) {
  for (const char* tex : {"$\\mathbf{L}$", "$\\boldsymbol{\\omega}$", "$\\hat{\\mathbf{e}}_1$"}) {
    const GlyphRun run = setTex(tex);
    const Moments before = momentsOf(rasterize(run, 160, 20, 150));
    const Moments after = momentsOf(rasterize(run, 160, 20.5, 150.25));
    EXPECT_NEAR(after.x_px - before.x_px, 0.5, 0.01) << tex;
    EXPECT_NEAR(after.y_px - before.y_px, 0.25, 0.01) << tex;
  }
}

TEST(Coverage, IsUnchangedByShiftsOfWholePixels) {
  const GlyphRun run = setTex("$\\hat{\\mathbf{e}}_1 = 2T/L$");
  const CoverageMap here = rasterize(run, 33.3, 20.37, 50.81, 2.5);
  const CoverageMap there = rasterize(run, 33.3, 20.37 + 512, 50.81 - 256, 2.5);
  EXPECT_EQ(there.left - here.left, 512);
  EXPECT_EQ(there.top - here.top, -256);
  EXPECT_EQ(there.values, here.values);
}

// The rectangle's place is known, so that coverage is a product of lengths.
TEST(Coverage, IsExactForARectangle) {
  GlyphRun run;
  run.rules.push_back({0, 0, 1, 0.5});
  const CoverageMap map = rasterize(run, 8, 10.25, 20.5);  // x 10.25..18.25, y 16.5..20.5
  EXPECT_EQ(map.left, 10);
  EXPECT_EQ(map.top, 16);
  EXPECT_EQ(map.width, 9);
  EXPECT_EQ(map.height, 5);
  EXPECT_EQ(map.at(12, 18), 255);
  EXPECT_NEAR(map.at(10, 18), 255 * 0.75, 1);
  EXPECT_NEAR(map.at(18, 18), 255 * 0.25, 1);
  EXPECT_NEAR(map.at(12, 16), 255 * 0.5, 1);
  EXPECT_NEAR(map.at(18, 20), 255 * 0.125, 1);
  EXPECT_EQ(map.at(9, 18), 0);
  EXPECT_EQ(map.at(12, 21), 0);
}

TEST(Coverage, DoesNotCountInkTwice) {
  GlyphRun once, twice;
  once.rules = {{0, 0, 2, 1}};
  twice.rules = {{0, 0, 1.5, 1}, {0.5, 0, 1.5, 1}};
  EXPECT_EQ(rasterize(once, 16, 3, 40).values, rasterize(twice, 16, 3, 40).values);
}

TEST(Coverage, IsEmptyForBlanks) {
  EXPECT_TRUE(rasterize(setTex("  "), 40, 0, 0).values.empty());
  EXPECT_EQ(rasterize(setTex(""), 40, 0, 0, 3).width, 0);
  EXPECT_EQ(CoverageMap{}.at(0, 0), 0);
}

TEST(Coverage, RejectsArgumentsOutOfRange) {
  const GlyphRun run = setTex("L");
  EXPECT_THROW(rasterize(run, 0, 0, 0), std::logic_error);
  EXPECT_THROW(rasterize(run, std::nan(""), 0, 0), std::logic_error);
  EXPECT_THROW(rasterize(run, 40, 1e7, 0), std::logic_error);
  EXPECT_THROW(rasterize(run, 40, 0, 0, -1), std::logic_error);
}

}  // namespace
}  // namespace poinsot::text
