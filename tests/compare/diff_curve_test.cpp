// SPDX-License-Identifier: Apache-2.0
// Curves of two compared films, read back from their SVG.
#include "compare/diff_curve.h"

#include <gmock/gmock.h>

#include <regex>

namespace poinsot::compare {
namespace {

/// Returns a comparison of films with 10 frames a second, in which all frames are identical except `differing`.
FilmDiff film(std::size_t frames, const std::vector<std::size_t>& differing) {
  FilmDiff diff{"", {10, 1}, FilmTimes(0), std::vector<PictureDiff>(frames)};
  for (std::size_t k = 0; k < frames; ++k) diff.times.add({{}, static_cast<double>(k) / 10, 0.1});
  for (PictureDiff& frame : diff.frames) {
    frame.verdict = Verdict::kIdentical;
    frame.hasFigures = true;
  }
  for (const std::size_t k : differing) {
    diff.frames[k].verdict = Verdict::kDifferent;
    diff.frames[k].figures.flip.max = 1;
    diff.frames[k].figures.flip.mean = 0.25;
  }
  return diff;
}

struct Point {
  double x, y;
};

/// Returns the corners of the two curves, which are blue lines.
std::vector<std::vector<Point>> curvesOf(const std::string& svg) {
  std::vector<std::vector<Point>> curves;
  const std::string start = "<path d=\"M", blue = "\" fill=\"none\" stroke=\"#0f62ad\"";
  for (std::size_t at = svg.find(start); at != std::string::npos; at = svg.find(start, at + 1)) {
    const std::size_t from = at + start.size(), to = svg.find('"', from);
    if (svg.compare(to, blue.size(), blue) != 0) continue;
    const std::string corners = svg.substr(from, to - from);
    static const std::regex corner("([0-9.]+) ([0-9.]+)");
    auto& curve = curves.emplace_back();
    for (std::sregex_iterator found(corners.begin(), corners.end(), corner), end; found != end; ++found)
      curve.push_back({std::stod((*found)[1]), std::stod((*found)[2])});
  }
  return curves;
}

std::vector<double> rowsOf(const std::vector<Point>& curve) {
  std::vector<double> rows;
  for (const Point& point : curve) rows.push_back(point.y);
  return rows;
}

TEST(DiffCurve, ShowsTheFiguresOfEachFrame) {
  FilmDiff diff = film(5, {3});
  diff.frames[1].figures.flip.max = 0.5;
  const auto curves = curvesOf(curveSvg(diff, {}));
  ASSERT_EQ(curves.size(), 2u);
  ASSERT_EQ(curves[0].size(), 5u);
  // Both axes end at the largest value, which is a tick: 1 and 0.25. Heights are measured from the lowest point.
  const double bottom = curves[0][0].y, top = curves[0][3].y;
  EXPECT_GT(bottom, top + 50);
  EXPECT_NEAR(curves[0][1].y, (bottom + top) / 2, 0.011);
  EXPECT_EQ(curves[0][2].y, bottom);
  EXPECT_EQ(curves[1][1].y, curves[1][0].y);
  EXPECT_LT(curves[1][3].y, curves[1][0].y - 50);
  for (std::size_t k = 0; k < 5; ++k)
    EXPECT_NEAR(curves[0][k].x, 1280 * (kCurveLeft + (kCurveRight - kCurveLeft) * static_cast<double>(k) / 4),
                0.006);
}

// One frame of 10 000 differs, and must show in both curves and in the strip of verdicts.
TEST(DiffCurve, LosesNoPeakOfALongFilm) {
  const std::string svg = curveSvg(film(10'000, {4321}), {});
  const auto curves = curvesOf(svg);
  ASSERT_EQ(curves.size(), 2u);
  for (const auto& curve : curves) {
    EXPECT_LE(curve.size(), 1600u);
    const auto rows = rowsOf(curve);
    EXPECT_EQ(std::ranges::count(rows, std::ranges::min(rows)), 1);
    const auto peak = curve[static_cast<std::size_t>(std::ranges::min_element(rows) - rows.begin())];
    EXPECT_NEAR(peak.x, 1280 * (kCurveLeft + (kCurveRight - kCurveLeft) * 0.4321), 1);
  }
  static const std::regex red("<rect x=\"([0-9.]+)\" y=\"[0-9.]+\" width=\"([0-9.]+)\" [^/]*#b3261e");
  std::smatch strip;
  ASSERT_TRUE(std::regex_search(svg, strip, red));
  EXPECT_NEAR(std::stod(strip[1]), 1280 * (kCurveLeft + (kCurveRight - kCurveLeft) * 0.4321), 1.5);
  EXPECT_GE(std::stod(strip[2]), 1);
}

TEST(DiffCurve, LeavesAGapAtFramesWithoutFigures) {
  FilmDiff diff = film(5, {1});
  diff.frames[2].verdict = Verdict::kDifferent;
  diff.frames[2].mismatch = "the size is 4x4, not 8x8";
  diff.frames[2].hasFigures = false;
  const std::string svg = curveSvg(diff, {});
  const auto curves = curvesOf(svg);
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(curves[0].size(), 4u);
  EXPECT_THAT(svg, testing::ContainsRegex("<path d=\"M[^M\"]*M[^M\"]*\" fill=\"none\""));  // one gap
  EXPECT_THAT(curveCsv(diff), testing::HasSubstr("\n2,0.2,different,,,,,,,,\n3,"));
}

TEST(DiffCurve, DrawsALineForALimitWithinTheAxis) {
  const auto lines = [](const FilmDiff& diff, double limit) {
    NearRule rule;
    rule.flipMax = limit;
    rule.flipMean = 100;
    const std::string svg = curveSvg(diff, rule);
    EXPECT_THAT(svg, testing::HasSubstr("(limit 100)"));
    return svg.find("stroke-dasharray") != std::string::npos;
  };
  EXPECT_TRUE(lines(film(5, {3}), 0.5));
  EXPECT_FALSE(lines(film(5, {3}), 2));
}

// A frame that passes is not the worst, even if its error is the largest.
TEST(FilmDiff, FindsTheWorstFrameAmongTheWorstVerdict) {
  FilmDiff diff = film(5, {3});
  diff.frames[1].verdict = Verdict::kNear;
  diff.frames[1].figures.flip.mean = 0.9;
  EXPECT_EQ(diff.worst(), 3u);
}

TEST(DiffCurve, WorksForOneFrameAndForIdenticalFrames) {
  for (const std::size_t frames : {1u, 2u}) {
    FilmDiff diff = film(frames, {});
    diff.fps = {0, 1};
    NearRule rule;
    rule.flipMax = rule.flipMean = 0;
    const std::string svg = curveSvg(diff, rule);
    EXPECT_THAT(svg, testing::Not(testing::ContainsRegex("nan|inf")));
    EXPECT_THAT(svg, testing::HasSubstr(">frame</text>"));
    EXPECT_EQ(curvesOf(svg).size(), 2u);
  }
}

}  // namespace
}  // namespace poinsot::compare
