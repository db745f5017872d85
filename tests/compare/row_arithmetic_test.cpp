// SPDX-License-Identifier: Apache-2.0
// Checks the vectorised arithmetic of FLIP and SSIM against the standard library in extended precision, and
// against the same formulas for one column at a time.
#include "compare/row_arithmetic.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <random>

#include "compare/affected_spans.h"
#include "compare/flip_color.h"

namespace poinsot::compare {
namespace {

/// Relative error in units of 2^-53.
double errorOf(double value, long double expected) {
  return static_cast<double>(std::abs((value - expected) / expected)) / 0x1p-53;
}

// Oracle: std::cbrt for long double. Measured: 2.9 at most.
TEST(SmoothFunctions, CubeRootIsExactToTwoUnits) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-100, 10);
  for (int i = 0; i < 200000; ++i) {
    const double t = std::exp2(exponent(random));
    ASSERT_LT(errorOf(cubeRoot(t), std::cbrt(static_cast<long double>(t))), 4) << t;
  }
  EXPECT_EQ(cubeRoot(1), 1);
  EXPECT_EQ(cubeRoot(8), 2);
}

// Oracle: std::pow for long double. The exponents are those of FLIP: 0.7, and from 0 to 1. Measured: 5.4 at most
// for x from 2^-10, which is what rounding the logarithm to 2^-49 gives.
TEST(SmoothFunctions, PowerIsExactToSixUnits) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> binary(-10, 8), any(0, 1);
  for (int i = 0; i < 200000; ++i) {
    const double x = std::exp2(binary(random)), y = i % 2 ? 0.7 : any(random);
    ASSERT_LT(errorOf(power(x, y), std::pow(static_cast<long double>(x), static_cast<long double>(y))), 8)
        << x << " " << y;
  }
}

TEST(SmoothFunctions, PowerIsExactAtItsEnds) {
  EXPECT_EQ(power(1, 0.3), 1);
  EXPECT_EQ(power(0.37, 0), 1);
  EXPECT_EQ(powerFromZero(0, 0.7), 0);
  EXPECT_EQ(powerFromZero(0, 0), 0);
  EXPECT_EQ(power(4, 0.5), 2);
  EXPECT_NEAR(power(DBL_MIN, 1) / DBL_MIN, 1, 1e-13);
  EXPECT_NEAR(power(1e-300, 0.7) / 1e-210, 1, 1e-13);
}

/// Returns a row with random values in a range, the same in each run.
MarginedRow randomRow(unsigned seed, double from, double to) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> value(from, to);
  MarginedRow row(41, 3);
  for (int x = -3; x < 44; ++x) row.columns()[x] = value(random);
  return row;
}

// A vector unit computes several columns at a time, and the columns that are left one by one. The same bits must
// come out wherever a span begins and ends, and columns outside must keep their values.
TEST(RowArithmetic, GivesTheSameBitsWhereverASpanEnds) {
  const MarginedRow y = randomRow(1, -16, 100), cx = randomRow(2, -80, 80), cz = randomRow(3, -80, 80);
  const MarginedRow edge = randomRow(4, 0, 1), point = randomRow(5, 0, 1);
  for (int begin = 0; begin < 9; ++begin)
    for (int end = begin; end <= begin + 11; ++end) {
      std::array<MarginedRow, 3> lab{y, cx, cz}, rest{cx, y, cz};
      toHuntLab({lab[0].columns(), lab[1].columns(), lab[2].columns()}, {begin, end});
      MarginedRow errors = edge, length = edge;
      const PerceivedRow a{{y.columns(), cx.columns(), cz.columns()}, edge.columns(), point.columns()};
      const PerceivedRow b{{cx.columns(), y.columns(), cz.columns()}, point.columns(), cx.columns()};
      flipErrors(a, {b.color, edge.columns(), edge.columns()}, {begin, end}, errors.columns());
      toLengths(length.columns(), point.columns(), 116, {begin, end});
      for (int x = -3; x < 44; ++x) {
        if (x < begin || x >= end) {
          EXPECT_EQ(lab[0].columns()[x], y.columns()[x]);
          EXPECT_EQ(errors.columns()[x], edge.columns()[x]);
          EXPECT_EQ(length.columns()[x], edge.columns()[x]);
          continue;
        }
        const Triple color = huntLab(rgbOfOpponent({y.columns()[x], cx.columns()[x], cz.columns()[x]}));
        for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(lab[k].columns()[x], color[k]);
        const double e = edge.columns()[x], p = point.columns()[x];
        EXPECT_EQ(length.columns()[x], std::sqrt(e * e + p * p) / 116);
        const Triple ca{y.columns()[x], cx.columns()[x], cz.columns()[x]};
        const Triple cb{cx.columns()[x], y.columns()[x], cz.columns()[x]};
        EXPECT_EQ(errors.columns()[x], powerFromZero(colorError(ca, cb, largestColorDistance()),
                                                     1 - std::sqrt(std::abs(p - e) / std::numbers::sqrt2)));
      }
    }
}

image::Image blank(image::PixelSize size) { return {size, 3}; }

// Worked out by hand: a pixel at (10, 4) connects with a 5x5 square by a filter of radius 2.
TEST(AffectedSpans, HoldASquareAroundADifferingPixel) {
  const image::Image a = blank({20, 9});
  image::Image b = a;
  b.at(10, 4)[1] = 1;
  AffectedSpans spans(a, b, 2);
  for (int y = 0; y < 9; ++y) {
    const bool inside = y >= 2 && y <= 6;
    EXPECT_EQ(spans.row(y), inside ? std::vector<ColumnSpan>({{8, 13}}) : std::vector<ColumnSpan>()) << y;
  }
}

// Worked out by hand: a filter of radius 2 covers 3 columns at an edge. Spans that are 4 columns apart join, and
// spans that are 5 columns apart do not.
TEST(AffectedSpans, EndAtTheEdgesAndJoinIfNear) {
  const image::Image a = blank({20, 3});
  image::Image b = a;
  b.at(0, 0)[0] = b.at(19, 0)[0] = 1;
  EXPECT_EQ(AffectedSpans(a, b, 2).row(2), std::vector<ColumnSpan>({{0, 3}, {17, 20}}));
  b.at(9, 0)[0] = 1;
  EXPECT_EQ(AffectedSpans(a, b, 2).row(0), std::vector<ColumnSpan>({{0, 12}, {17, 20}}));
  b.at(14, 0)[0] = 1;
  EXPECT_EQ(AffectedSpans(a, b, 2).row(0), std::vector<ColumnSpan>({{0, 20}}));
}

bool isNear(const image::Image& picture, int x, int y, int radius) {
  for (int v = std::max(y - radius, 0); v <= std::min(y + radius, picture.size.height - 1); ++v)
    for (int u = std::max(x - radius, 0); u <= std::min(x + radius, picture.size.width - 1); ++u)
      if (picture.at(u, v)[2] != 0) return true;
  return false;
}

// Oracle: the definition, by trying all pixels. Each span also begins and ends at such a pixel.
TEST(AffectedSpans, CoverWhatTheDefinitionCovers) {
  constexpr int kRadius = 3;
  const image::Image a = blank({30, 25});
  std::mt19937 random(3);
  for (int pixels = 0; pixels < 20; ++pixels) {
    image::Image b = a;
    for (int i = 0; i < pixels; ++i) b.at(static_cast<int>(random() % 30), static_cast<int>(random() % 25))[2] = 9;
    AffectedSpans affected(a, b, kRadius);
    for (int y = 0; y < a.size.height; ++y) {
      const std::vector<ColumnSpan>& spans = affected.row(y);
      const auto covered = [&](int x) {
        return std::ranges::any_of(spans, [x](ColumnSpan s) { return s.begin <= x && x < s.end; });
      };
      for (int x = 0; x < a.size.width; ++x) EXPECT_TRUE(covered(x) || !isNear(b, x, y, kRadius)) << x << " " << y;
      for (const auto& [begin, end] : spans)
        EXPECT_TRUE(isNear(b, begin, y, kRadius) && isNear(b, end - 1, y, kRadius));
    }
  }
}

}  // namespace
}  // namespace poinsot::compare
