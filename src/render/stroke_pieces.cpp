// SPDX-License-Identifier: Apache-2.0
#include "render/stroke_pieces.h"

#include <algorithm>
#include <cmath>

#include "core/expect.h"

namespace poinsot::render {
namespace {

using text::Point;

constexpr double kPiece_px = 64;
// Overlap of neighbouring pieces: the diagonal of a pixel, and rounding. Half the line width is added for bends.
constexpr double kOverlap_px = 2;
// Largest distance of a left-out point from the line between its neighbours. A shift of this size is not visible.
constexpr double kTolerance_px = 0.01;
// Limit of consecutive points that are left out. Each further point requires a check of all of them.
constexpr std::size_t kLeftOut = 16;

struct Range {
  double from, to;
};

double distanceToSegment(Point p, Point from, Point to) {
  const Point d = to - from, q = p - from;
  const double length2 = d.x * d.x + d.y * d.y;
  const double t = length2 > 0 ? std::clamp((q.x * d.x + q.y * d.y) / length2, 0.0, 1.0) : 0;
  return text::distance(q, d * t);
}

/// Simplifies a polyline. Curves are sampled much more finely than their shape requires.
class Simplifier {
 public:
  void add(Point p) {
    const auto near = [&](Point q) { return distanceToSegment(q, kept_.back(), p) <= kTolerance_px; };
    if (kept_.empty()) {
      kept_.push_back(p);
      return;
    }
    if (!since_.empty() && (since_.size() > kLeftOut || !std::ranges::all_of(since_, near))) keepLast();
    since_.push_back(p);
  }

  std::vector<Point> take() {
    if (!since_.empty()) keepLast();
    return std::move(kept_);
  }

 private:
  void keepLast() {
    const Point last = since_.back();
    since_.clear();
    if (last.x != kept_.back().x || last.y != kept_.back().y) kept_.push_back(last);
  }

  std::vector<Point> kept_, since_;
};

std::vector<Point> simplified(const draw::Stroke& stroke) {
  Simplifier simplifier;
  for (const glm::vec2& p : stroke.points_px) {
    POINSOT_EXPECT(std::isfinite(p.x) && std::isfinite(p.y));
    simplifier.add({static_cast<double>(p.x), static_cast<double>(p.y)});
  }
  std::vector<Point> points = simplifier.take();
  const Point first = points.front(), last = points.back();
  if (stroke.closed && (first.x != last.x || first.y != last.y)) points.push_back(first);
  return points;
}

/// Polyline with access by arc length.
class Path {
 public:
  /// @pre no point is repeated directly after itself
  explicit Path(std::vector<Point> points) : points_(std::move(points)), lengths_{0} {
    for (std::size_t i = 1; i < points_.size(); ++i)
      lengths_.push_back(lengths_.back() + text::distance(points_[i - 1], points_[i]));
  }

  const std::vector<Point>& points() const { return points_; }
  double lengthTo(std::size_t i) const { return lengths_[i]; }
  double length() const { return lengths_.back(); }

  /// Returns the part of the path within a range of arc length. A range beyond the end continues at the start.
  StrokePiece piece(Range range) const {
    StrokePiece piece{at(range.from)};
    addInner(range, 0, piece);
    addInner(range, length(), piece);
    if (range.to > range.from) push(at(range.to), piece);
    return piece;
  }

 private:
  static void push(Point p, StrokePiece& piece) {
    if (p.x != piece.back().x || p.y != piece.back().y) piece.push_back(p);
  }

  // Adds the points of the path that lie strictly within the range.
  // @param offset  arc length at which the current lap starts: 0 or length()
  void addInner(Range range, double offset, StrokePiece& piece) const {
    auto i = std::upper_bound(lengths_.begin(), lengths_.end(), range.from - offset) - lengths_.begin();
    for (; i < std::ssize(lengths_) && lengths_[static_cast<std::size_t>(i)] + offset < range.to; ++i)
      push(points_[static_cast<std::size_t>(i)], piece);
  }

  Point at(double s) const {
    if (s > length()) s -= length();
    const auto after = std::upper_bound(lengths_.begin(), lengths_.end(), s);
    if (after == lengths_.end()) return points_.back();
    const auto i = static_cast<std::size_t>(after - lengths_.begin());
    return points_[i - 1] +
           (points_[i] - points_[i - 1]) * ((s - lengths_[i - 1]) / (lengths_[i] - lengths_[i - 1]));
  }

  std::vector<Point> points_;
  std::vector<double> lengths_;
};

// Narrows the range `share` of t to the values with low <= a + t b <= high.
void cut(double a, double b, double low, double high, Range& share) {
  if (b == 0) {
    if (a < low || a > high) share.to = share.from - 1;
    return;
  }
  const double t0 = (low - a) / b, t1 = (high - a) / b;
  share.from = std::max(share.from, std::min(t0, t1));
  share.to = std::min(share.to, std::max(t0, t1));
}

std::vector<Range> rangesWithin(const Path& path, const PixelBounds& rectangle, double margin) {
  const auto low = [&](float x) { return static_cast<double>(x) - margin; };
  const auto high = [&](float x) { return static_cast<double>(x) + margin; };
  std::vector<Range> ranges;
  for (std::size_t i = 0; i + 1 < path.points().size(); ++i) {
    const Point p = path.points()[i], d = path.points()[i + 1] - p;
    Range share{0, 1};
    cut(p.x, d.x, low(rectangle.left), high(rectangle.right), share);
    cut(p.y, d.y, low(rectangle.top), high(rectangle.bottom), share);
    if (share.to < share.from) continue;
    const double start = path.lengthTo(i), length = path.lengthTo(i + 1) - start;
    const Range seen{start + share.from * length,
                     share.to == 1 ? path.lengthTo(i + 1) : start + share.to * length};
    if (!ranges.empty() && ranges.back().to == seen.from)
      ranges.back().to = seen.to;
    else
      ranges.push_back(seen);
  }
  return ranges;
}

// Returns the dashes within a range of arc length. Dashes begin at even multiples of `dash`.
std::vector<Range> dashesIn(Range range, double dash) {
  std::vector<Range> dashes;
  for (double k = std::floor(range.from / (2 * dash)); 2 * dash * k < range.to; ++k) {
    const Range whole{std::max(2 * dash * k, range.from), std::min(2 * dash * k + dash, range.to)};
    if (whole.to > whole.from) dashes.push_back(whole);
  }
  return dashes;
}

}  // namespace

std::vector<StrokePiece> strokePieces(const draw::Stroke& stroke, const PixelBounds& visible) {
  if (stroke.points_px.empty()) return {};
  const Path path(simplified(stroke));
  if (path.points().size() == 1) return {{path.points().front()}};
  const double halfWidth = 0.5 * static_cast<double>(stroke.width_px);
  // The round ends of dashes close gaps that are not longer than the line's width. Such a line has no dashes.
  const bool dashed = stroke.dash_px > stroke.width_px;
  const bool loop = stroke.closed && !dashed;
  // A short loop is divided into at least three pieces, so that no piece reaches its own start.
  const double third = path.length() / 3;
  const double step = loop ? std::min(kPiece_px, third) : kPiece_px;
  const double overlap = loop ? std::min(kOverlap_px + halfWidth, third) : kOverlap_px + halfWidth;

  std::vector<StrokePiece> pieces;
  for (const Range& seen : rangesWithin(path, visible, halfWidth + kOverlap_px)) {
    const auto parts = dashed ? dashesIn(seen, static_cast<double>(stroke.dash_px)) : std::vector<Range>{seen};
    for (const Range& part : parts) {
      const double end = loop && part.to == path.length() ? part.to + overlap : part.to;
      const auto count = static_cast<int>(std::ceil((part.to - part.from) / step));
      for (int i = 0; i < count; ++i) {
        const double s = part.from + i * step;
        pieces.push_back(path.piece({s, std::min(s + step + overlap, end)}));
      }
    }
  }
  return pieces;
}

}  // namespace poinsot::render
