// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "text/coverage.h"
#include "text/math_setter.h"

namespace poinsot::text {
namespace {

double areaOf(const CoverageMap& map) {
  double sum = 0;
  for (const std::uint8_t value : map.values) sum += value / 255.0;
  return sum;
}

// The dot of \cdot is a disc; grown by r, it is a disc whose radius follows from its area. Measured: 0.036 px too
// small at worst, because of the chords (kHaloTolerance_px); bound 0.1.
TEST(Halo, GrowsADiscByItsRadius) {
  const GlyphRun dot = setTex("$\\cdot$");
  const double size_px = 200;
  const double radius_px = size_px * (dot.inkRight_em - dot.inkLeft_em) / 2;
  for (const double outline_px : {0.5, 1.0, 2.5, 6.0}) {
    const double grown_px = std::sqrt(areaOf(rasterize(dot, size_px, 7.3, 90.6, outline_px)) / std::numbers::pi);
    EXPECT_NEAR(grown_px, radius_px + outline_px, 0.1) << outline_px;
  }
}

// Steiner's formula: a convex shape grows to area + perimeter * r + pi r²; the last term distinguishes round
// corners from square ones. Measured 1.8e-4; bound 3e-3, where square corners would be 3.3e-2 off.
TEST(Halo, RoundsCorners) {
  GlyphRun run;
  run.rules.push_back({0, 0, 2, 1});
  const double r = 9;
  const double expected = 40 * 20 + 2 * (40 + 20) * r + std::numbers::pi * r * r;
  EXPECT_NEAR(areaOf(rasterize(run, 20, 30.3, 60.6, r)), expected, 0.003 * expected);
}

// Along a straight edge the halo ends at its radius, to a fraction of a pixel. Measured 0.002; bound 0.1.
TEST(Halo, EndsAtItsRadiusOnEverySide) {
  GlyphRun run;
  run.rules.push_back({0, 0, 2, 1});
  const double r = 3.25;
  const CoverageMap map = rasterize(run, 20, 30, 60, r);  // x 30..70, y 40..60
  const auto rowSum = [&](int y) {
    double sum = 0;
    for (int x = map.left; x < map.left + map.width; ++x) sum += map.at(x, y) / 255.0;
    return sum;
  };
  const auto columnSum = [&](int x) {
    double sum = 0;
    for (int y = map.top; y < map.top + map.height; ++y) sum += map.at(x, y) / 255.0;
    return sum;
  };
  EXPECT_NEAR(rowSum(50), 40 + 2 * r, 0.1);
  EXPECT_NEAR(columnSum(50), 20 + 2 * r, 0.1);
}

TEST(Halo, ContainsTheGlyphs) {
  for (const char* tex : {"$\\boldsymbol{\\omega}$", "$\\hat{\\mathbf{e}}_1$", "Poinsot's", "$\\frac{2T}{L}$"})
    for (const double outline_px : {0.2, 1.0, 4.0}) {
      const GlyphRun run = setTex(tex);
      const CoverageMap glyphs = rasterize(run, 30, 20.4, 60.2);
      const CoverageMap halo = rasterize(run, 30, 20.4, 60.2, outline_px);
      for (int y = glyphs.top; y < glyphs.top + glyphs.height; ++y)
        for (int x = glyphs.left; x < glyphs.left + glyphs.width; ++x)
          ASSERT_GE(halo.at(x, y), glyphs.at(x, y)) << tex << " " << outline_px;
    }
}

TEST(Halo, DoesNotAddUpWhereGlyphsOverlap) {
  GlyphRun once = setTex("$e$"), twice = once;
  twice.glyphs.push_back(twice.glyphs[0]);
  EXPECT_EQ(rasterize(twice, 40, 10.4, 50.3, 2).values, rasterize(once, 40, 10.4, 50.3, 2).values);
}

// Narrow parts of letters are filled without holes: the eye of an e is less than 2 x 4 pixels high here.
TEST(Halo, FillsNarrowGapsInsideLetters) {
  const GlyphRun e = setTex("e");
  const CoverageMap halo = rasterize(e, 24, 10, 40, 4);
  for (double v = 0.1; v < 0.95; v += 0.1) {
    const double y_em = e.inkBottom_em + v * (e.inkTop_em - e.inkBottom_em);
    const double x_em = (e.inkLeft_em + e.inkRight_em) / 2;
    EXPECT_EQ(halo.at(static_cast<int>(10 + 24 * x_em), static_cast<int>(40 - 24 * y_em)), 255) << v;
  }
}

}  // namespace
}  // namespace poinsot::text
