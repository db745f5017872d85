// SPDX-License-Identifier: Apache-2.0
#include "stage/plot/plot_curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace poinsot::stage {
namespace {

std::vector<PlotPoint> wave(int samples, double waves) {
  std::vector<PlotPoint> points;
  for (int i = 0; i < samples; ++i) {
    const double x = static_cast<double>(i) / (samples - 1);
    points.push_back({10 * x, x, 0.5 + 0.5 * std::sin(2 * M_PI * waves * x)});
  }
  return points;
}

bool isAmong(const PlotPoint& p, const std::vector<PlotPoint>& points) {
  return std::ranges::any_of(
      points, [&](const PlotPoint& q) { return p.filmTime_s == q.filmTime_s && p.x == q.x && p.y == q.y; });
}

TEST(PlotCurve, KeepsTheHeightOfFastOscillations) {
  const auto points = wave(100'000, 2500);  // 25 waves in each of 100 columns
  const auto kept = perColumn(points, 100);
  EXPECT_LE(kept.size(), 4u * 101);
  EXPECT_EQ(kept.front().x, 0);
  EXPECT_EQ(kept.back().x, 1);
  for (int column = 0; column < 100; ++column) {
    double low = 1, high = 0;
    for (const PlotPoint& p : kept)
      if (std::floor(100 * p.x) == column) low = std::min(low, p.y), high = std::max(high, p.y);
    EXPECT_LT(low,
              0.0016);  // of 40 samples a wave, one is within pi/40 of the crest: (1 - cos(pi/40))/2 = 0.00154
    EXPECT_GT(high, 1 - 0.0016);
  }
  for (const PlotPoint& p : kept) EXPECT_TRUE(isAmong(p, points));
}

TEST(PlotCurve, IsSimplifiedWithinItsTolerance) {
  const auto points = wave(10'000, 3);
  for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
    const auto kept = simplified(points, tolerance);
    EXPECT_LT(kept.size(), points.size() / 10);
    // Expected: the sine, compared with straight lines between the points that are kept.
    std::size_t at = 0;
    double worst = 0;
    for (const PlotPoint& p : points) {
      while (at + 2 < kept.size() && kept[at + 1].x <= p.x) ++at;
      const double share = (p.x - kept[at].x) / (kept[at + 1].x - kept[at].x);
      const double dx = kept[at + 1].x - kept[at].x, dy = kept[at + 1].y - kept[at].y;
      const double off = std::abs(std::lerp(kept[at].y, kept[at + 1].y, share) - p.y) * dx / std::hypot(dx, dy);
      worst = std::max(worst, off);
    }
    EXPECT_LE(worst, tolerance);
    EXPECT_GT(worst, 0.3 * tolerance);  // no more points are kept than needed
  }
}

TEST(PlotCurve, IsClippedAtTheEdgesOfItsRange) {
  const std::vector<PlotPoint> points = {{0, 0, -1}, {1, 1, 2}, {2, 2, 0.5}, {3, 3, 0.5}, {4, 4, -0.5}};
  const PlotPath path = insideBand(points);
  ASSERT_EQ(path.size(), 2u);
  ASSERT_EQ(path[0].size(), 2u);  // up through the whole band
  EXPECT_DOUBLE_EQ(path[0][0].x, 1.0 / 3);
  EXPECT_DOUBLE_EQ(path[0][1].x, 2.0 / 3);
  ASSERT_EQ(path[1].size(), 4u);
  EXPECT_DOUBLE_EQ(path[1][0].x, 1 + 2.0 / 3);
  EXPECT_EQ(path[1][0].y, 1);
  EXPECT_DOUBLE_EQ(path[1][3].x, 3.5);
  EXPECT_EQ(path[1][3].y, 0);
}

TEST(PlotCurve, IsInterruptedWhereTheQuantityDoesNotExist) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const PlotPath path =
      finiteStretches(std::vector<PlotPoint>{{0, 0, none}, {1, 1, 0}, {2, 2, 1}, {3, 3, none}, {4, 4, 0}});
  ASSERT_EQ(path.size(), 2u);
  EXPECT_EQ(path[0].size(), 2u);
  EXPECT_EQ(path[1].size(), 1u);
}

TEST(PlotCurve, IsSplitAtTheCursor) {
  const auto points = wave(11, 1);
  const PlotPoint cursor{4.5, 0.45, 0.6};
  const auto past = before(points, cursor), future = after(points, cursor);
  EXPECT_EQ(past.size(), 6u);
  EXPECT_EQ(past.back().y, 0.6);
  EXPECT_EQ(future.size(), 7u);
  EXPECT_EQ(future.front().y, 0.6);
}

}  // namespace
}  // namespace poinsot::stage
