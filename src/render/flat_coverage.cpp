// SPDX-License-Identifier: Apache-2.0
#include "render/flat_coverage.h"

#include <algorithm>
#include <cmath>

#include "core/expect.h"
#include "render/stroke_pieces.h"
#include "text/area_builder.h"

namespace poinsot::render {
namespace {

using text::Point;
using text::Segment;
using Polygon = std::vector<Point>;

// Largest distance of a chord from its arc. An error of this size changes an 8-bit value by at most one step.
constexpr double kArcTolerance_px = 0.005;

double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
Point unit(Point v) { return v * (1 / text::distance({0, 0}, v)); }

/// Outline of a stroke piece with round joins and ends. The outline follows the left side of the piece forwards
/// and the right side back, and may cross itself. Points of the stroke have a winding number of at least 1; a
/// point that the pen passes twice has about 2.
class StrokeOutline {
 public:
  StrokeOutline(StrokePiece piece, double halfWidth) : piece_(std::move(piece)), r_(halfWidth) {
    if (piece_.size() == 1) {
      addCap(piece_[0], {1, 0});
      addCap(piece_[0], {-1, 0});
      return;
    }
    addLeftSide();
    std::ranges::reverse(piece_);
    addLeftSide();
  }

  Polygon take() { return std::move(outline_); }

 private:
  static Point leftOf(Point d) { return {d.y, -d.x}; }

  void addLeftSide() {
    Point along = direction(0);
    add(piece_[0], leftOf(along));
    for (std::size_t i = 1; i + 1 < piece_.size(); ++i) {
      const Point next = direction(i);
      addJoin(i, along, next);
      along = next;
    }
    addCap(piece_.back(), along);
  }

  Point direction(std::size_t i) const { return unit(piece_[i + 1] - piece_[i]); }

  void add(Point p, Point normal) { outline_.push_back(p + normal * r_); }

  void addJoin(std::size_t i, Point in, Point out) {
    const Point p = piece_[i], a = leftOf(in), b = leftOf(out);
    const double cosine = dot(a, b);
    const bool inner = dot(a, out) > 0;
    // On the inner side of a bend, the outlines of two long enough segments meet in one point.
    const double shortest = std::min(text::distance(piece_[i - 1], p), text::distance(p, piece_[i + 1]));
    if (inner && r_ * std::abs(dot(a, out)) <= 0.5 * shortest * (1 + cosine)) {
      add(p, (a + b) * (1 / (1 + cosine)));
      return;
    }
    add(p, a);
    if (cosine > 0) {
      addArc(p, a, b);
    } else {
      const Point middle = inner ? unit(out - in) : unit(in - out);
      addArc(p, a, middle);
      addArc(p, middle, b);
    }
  }

  void addCap(Point p, Point along) {
    add(p, leftOf(along));
    addArc(p, leftOf(along), along);
    addArc(p, along, leftOf(along) * -1);
  }

  // Adds an arc from the normal `a`, whose point is already in the outline, to the normal `b`. The angle between
  // the normals is at most 90 degrees. Halving the angle needs only sqrt, which has the same bits everywhere.
  void addArc(Point p, Point a, Point b) {
    const Point sum = a + b;
    const double twiceCosine = text::distance({0, 0}, sum);  // 2 cos(angle / 2), with the angle between a and b
    if (r_ * (1 - 0.5 * twiceCosine) <= kArcTolerance_px) {
      add(p, b);
      return;
    }
    const Point middle = sum * (1 / twiceCosine);
    addArc(p, a, middle);
    addArc(p, middle, b);
  }

  StrokePiece piece_;
  double r_;
  Polygon outline_;
};

text::CoverageMap emptyMap(const PixelBounds& bounds, glm::ivec2 size_px) {
  const PixelBounds whole = bounds.clipped(size_px);
  text::CoverageMap map;
  if (whole.empty()) return map;
  map.left = static_cast<int>(whole.left);
  map.top = static_cast<int>(whole.top);
  map.width = static_cast<int>(whole.right) - map.left;
  map.height = static_cast<int>(whole.bottom) - map.top;
  return map;
}

PixelBounds boundsOf(const Polygon& polygon) {
  PixelBounds bounds;
  for (const Point& p : polygon) bounds.include({static_cast<float>(p.x), static_cast<float>(p.y)}, 0.01f);
  return bounds;
}

/// Sums the areas of segments, clipped to a map of width x height pixels. Segments to the left of the map count
/// too, because an edge covers everything to its right.
class ClippedArea {
 public:
  ClippedArea(int width, int height) : width_(width), height_(height), area_(width, height) {}

  void add(Segment s) {
    if (!cutRows(s)) return;
    const double right = width_;
    const bool leftwards = s.to.x < s.from.x;
    for (const double side : {leftwards ? right : 0.0, leftwards ? 0.0 : right}) {
      const double before = s.from.x - side, after = s.to.x - side;
      if ((before < 0) == (after < 0)) continue;
      const Point crossing{side, s.from.y + (s.to.y - s.from.y) * (before / (before - after))};
      addClamped({s.from, crossing});
      s.from = crossing;
    }
    addClamped(s);
  }

  std::vector<double> coverage() const { return area_.coverage(); }

 private:
  bool cutRows(Segment& s) const {
    const double low = std::min(s.from.y, s.to.y), high = std::max(s.from.y, s.to.y);
    if (high <= 0 || low >= height_ || high == low) return false;
    const Segment whole = s;
    const auto at = [&](double y) {
      return whole.from.x + (whole.to.x - whole.from.x) * ((y - whole.from.y) / (whole.to.y - whole.from.y));
    };
    for (Point* p : {&s.from, &s.to}) {
      const double y = std::clamp(p->y, 0.0, static_cast<double>(height_));
      if (y != p->y) *p = {at(y), y};
    }
    return true;
  }

  void addClamped(Segment s) {
    for (Point* p : {&s.from, &s.to}) {
      p->x = std::clamp(p->x, 0.0, static_cast<double>(width_));
      p->y = std::clamp(p->y, 0.0, static_cast<double>(height_));
    }
    area_.addSegment(s);
  }

  int width_, height_;
  text::AreaBuilder area_;
};

text::CoverageMap polygonCoverage(const Polygon& polygon, glm::ivec2 size_px) {
  text::CoverageMap map = emptyMap(boundsOf(polygon), size_px);
  if (map.width == 0) return map;
  ClippedArea area(map.width, map.height);
  const Point corner{static_cast<double>(map.left), static_cast<double>(map.top)};
  for (std::size_t i = 0; i < polygon.size(); ++i)
    area.add({polygon[i] - corner, polygon[(i + 1) % polygon.size()] - corner});
  const std::vector<double> shares = area.coverage();
  map.values.resize(shares.size());
  std::ranges::transform(shares, map.values.begin(),
                         [](double share) { return static_cast<std::uint8_t>(std::lround(255 * share)); });
  return map;
}

void takeLarger(const text::CoverageMap& part, text::CoverageMap& whole) {
  for (int y = 0; y < part.height; ++y) {
    const std::uint8_t* from = part.values.data() + static_cast<std::ptrdiff_t>(y) * part.width;
    std::uint8_t* to = whole.values.data() + static_cast<std::ptrdiff_t>(part.top + y - whole.top) * whole.width +
                       (part.left - whole.left);
    for (int x = 0; x < part.width; ++x) to[x] = std::max(to[x], from[x]);
  }
}

}  // namespace

text::CoverageMap strokeCoverage(const draw::Stroke& stroke, glm::ivec2 size_px) {
  if (stroke.width_px <= 0) return {};
  const PixelBounds picture{0, 0, static_cast<float>(size_px.x), static_cast<float>(size_px.y)};
  PixelBounds bounds;
  std::vector<text::CoverageMap> parts;
  for (StrokePiece& piece : strokePieces(stroke, picture)) {
    const Polygon outline = StrokeOutline(std::move(piece), 0.5 * static_cast<double>(stroke.width_px)).take();
    parts.push_back(polygonCoverage(outline, size_px));
    if (parts.back().width > 0) bounds.include(boundsOf(outline));
  }
  if (parts.size() == 1) return std::move(parts.front());
  text::CoverageMap whole = emptyMap(bounds, size_px);
  whole.values.resize(static_cast<std::size_t>(whole.width) * static_cast<std::size_t>(whole.height));
  for (const text::CoverageMap& part : parts) takeLarger(part, whole);
  return whole;
}

text::CoverageMap areaCoverage(const draw::Area& area, glm::ivec2 size_px) {
  Polygon polygon;
  for (const glm::vec2& p : area.points_px) {
    POINSOT_EXPECT(std::isfinite(p.x) && std::isfinite(p.y));
    polygon.push_back({static_cast<double>(p.x), static_cast<double>(p.y)});
  }
  return polygonCoverage(polygon, size_px);
}

}  // namespace poinsot::render
