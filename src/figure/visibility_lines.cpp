// SPDX-License-Identifier: Apache-2.0
#include "figure/visibility_lines.h"

#include <glm/geometric.hpp>
#include <utility>

#include "figure/visibility_pieces.h"

namespace poinsot::figure {
namespace {

constexpr double kOffLine_px = 0.05;

using Points = std::vector<glm::dvec2>;

double distanceToSegment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
  const glm::dvec2 along = b - a;
  const double length2 = glm::dot(along, along);
  const double share = length2 > 0 ? glm::clamp(glm::dot(p - a, along) / length2, 0.0, 1.0) : 0;
  return glm::distance(p, a + share * along);
}

std::pair<std::size_t, double> farthest(const Points& points, std::size_t first, std::size_t last) {
  std::pair<std::size_t, double> found{first, 0};
  for (std::size_t i = first + 1; i < last; ++i) {
    const double d = distanceToSegment(points[i], points[first], points[last]);
    if (d > found.second) found = {i, d};
  }
  return found;
}

/// Returns a simplified line. Points of the original line are at most kOffLine_px from it. Source: Douglas and
/// Peucker, Cartographica 10 (1973) 112.
Points simplified(const Points& points) {
  std::vector<bool> kept(points.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    const auto [middle, off_px] = farthest(points, first, last);
    if (off_px <= kOffLine_px) continue;
    kept[middle] = true;
    open.insert(open.end(), {{first, middle}, {middle, last}});
  }
  Points result;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (kept[i]) result.push_back(points[i]);
  return result;
}

SeenLine lineOf(const Piece& piece) {
  Points points;
  for (const PiecePoint& point : piece.points) points.push_back(point.p_px);
  if (piece.closed) points.push_back(points.front());
  points = simplified(points);
  if (piece.closed) points.pop_back();
  return {std::move(points), piece.closed, piece.width_px, piece.color};
}

}  // namespace

std::vector<SeenLine> seenLines(const draw::DrawList& list) {
  const Visibility visibility(list);
  std::vector<Piece> pieces;
  for (const draw::Curve& curve : list.curves) {
    auto seen = visiblePieces(visibility, list.camera, curve);
    pieces.insert(pieces.end(), std::make_move_iterator(seen.begin()), std::make_move_iterator(seen.end()));
  }
  std::vector<SeenLine> lines;
  for (const Piece& piece : inPaintingOrder(pieces)) lines.push_back(lineOf(piece));
  return lines;
}

}  // namespace poinsot::figure
