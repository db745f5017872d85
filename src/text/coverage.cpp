// SPDX-License-Identifier: Apache-2.0
#include "text/coverage.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/expect.h"
#include "text/area_builder.h"
#include "text/halo.h"
#include "text/outline_segments.h"

namespace poinsot::text {
namespace {

// Largest distance of a chord from the curve. An error of this size changes an 8-bit value by at most one step.
constexpr double kFillTolerance_px = 0.005;
// Largest distance of a chord from the curve in a halo, which takes a third of the time. The error is not visible,
// because a halo usually has the colour of the background.
constexpr double kHaloTolerance_px = 0.05;

// Returns the fractional part of a coordinate, rounded to 1/1024. All arithmetic uses the fractional part. A text
// that is moved by whole pixels therefore keeps exactly the same pixel values.
double fractionOf(double coordinate_px) {
  return std::floor(1024 * (coordinate_px - std::floor(coordinate_px)) + 0.5) / 1024;
}

struct PixelBox {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
};

// Returns the rectangle of all pixels that the segments touch.
// @pre there is at least one segment
PixelBox boxOf(const std::vector<Segment>& segments) {
  Point least{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  Point most = least * -1;
  // Outlines are closed, so every point is the start of one of the segments.
  for (const Segment& s : segments) {
    least = {std::min(least.x, s.from.x), std::min(least.y, s.from.y)};
    most = {std::max(most.x, s.from.x), std::max(most.y, s.from.y)};
  }
  return {static_cast<int>(std::floor(least.x)), static_cast<int>(std::floor(least.y)),
          static_cast<int>(std::ceil(most.x)), static_cast<int>(std::ceil(most.y))};
}

void moveBy(std::vector<Segment>& segments, Point offset) {
  for (Segment& s : segments) s = {s.from + offset, s.to + offset};
}

std::vector<std::uint8_t> toBytes(const std::vector<double>& coverage) {
  std::vector<std::uint8_t> bytes(coverage.size());
  std::ranges::transform(coverage, bytes.begin(),
                         [](double share) { return static_cast<std::uint8_t>(std::floor(255 * share + 0.5)); });
  return bytes;
}

}  // namespace

std::uint8_t CoverageMap::at(int x, int y) const {
  const int column = x - left, row = y - top;
  if (column < 0 || row < 0 || column >= width || row >= height) return 0;
  return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(column)];
}

CoverageMap rasterize(const GlyphRun& run, double size_px, double originX_px, double originY_px,
                      double outline_px) {
  POINSOT_EXPECT(size_px > 0 && size_px <= 4000);
  POINSOT_EXPECT(outline_px >= 0 && outline_px <= 200);
  POINSOT_EXPECT(std::abs(originX_px) <= 1e6 && std::abs(originY_px) <= 1e6);
  const Point origin{fractionOf(originX_px), fractionOf(originY_px)};
  const double tolerance_px = outline_px > 0 ? kHaloTolerance_px : kFillTolerance_px;
  std::vector<Segment> segments = outlineSegments(run, size_px, origin, tolerance_px);
  if (segments.empty()) return {};

  const PixelBox box = boxOf(segments);
  const int margin = outline_px > 0 ? static_cast<int>(std::ceil(outline_px)) + 1 : 0;
  CoverageMap map;
  map.left = static_cast<int>(std::floor(originX_px)) + box.left - margin;
  map.top = static_cast<int>(std::floor(originY_px)) + box.top - margin;
  map.width = box.right - box.left + 2 * margin;
  map.height = box.bottom - box.top + 2 * margin;
  moveBy(segments, {static_cast<double>(margin - box.left), static_cast<double>(margin - box.top)});

  AreaBuilder area(map.width, map.height);
  for (const Segment& s : segments) area.addSegment(s);
  std::vector<double> coverage = area.coverage();
  if (outline_px > 0) {
    HaloBuilder halo(map.width, map.height, outline_px);
    for (const Segment& s : segments) halo.addSegment(s);
    halo.growInto(coverage);
  }
  map.values = toBytes(coverage);
  return map;
}

}  // namespace poinsot::text
