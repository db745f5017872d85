// SPDX-License-Identifier: Apache-2.0
#include "render/pixel_fragment.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace poinsot::render {
namespace {

using glm::dvec2;
using glm::dvec3;

// Less than this of a pixel is nothing, and would only be rounding.
constexpr double kLeastArea = 1e-7;

double crossOf(dvec2 a, dvec2 b) { return a.x * b.y - a.y * b.x; }

/// A convex polygon: a triangle cut by four half-planes has seven corners at most.
struct PixelPolygon {
  std::array<dvec2, 8> corners;
  std::size_t size = 0;
  void add(dvec2 p) { corners[size++] = p; }
};

// What of the polygon has sign * coordinate `axis` >= sign * limit (Sutherland & Hodgman).
PixelPolygon cut(const PixelPolygon& polygon, int axis, double sign, double limit) {
  PixelPolygon kept;
  const auto inside = [&](dvec2 p) { return sign * (p[axis] - limit); };
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const dvec2 p = polygon.corners[i], q = polygon.corners[(i + 1) % polygon.size];
    const double dp = inside(p), dq = inside(q);
    if (dp >= 0) kept.add(p);
    if ((dp >= 0) != (dq >= 0)) {
      dvec2 crossing = p + dp / (dp - dq) * (q - p);
      crossing[axis] = limit;
      kept.add(crossing);
    }
  }
  return kept;
}

PixelPolygon cutToPixel(const std::array<dvec2, 3>& t) {
  PixelPolygon polygon;
  for (const dvec2& p : t) polygon.add(p);
  for (int axis = 0; axis < 2 && polygon.size > 0; ++axis) {
    polygon = cut(polygon, axis, 1, 0);
    polygon = cut(polygon, axis, -1, 1);
  }
  return polygon;
}

// Area and its middle.
void measure(const PixelPolygon& polygon, PixelFragment& fragment) {
  const dvec2 origin = polygon.corners[0];
  double twice = 0;
  dvec2 sum(0);
  for (std::size_t i = 1; i + 1 < polygon.size; ++i) {
    const dvec2 u = polygon.corners[i] - origin, v = polygon.corners[i + 1] - origin;
    const double c = crossOf(u, v);
    twice += c;
    sum += c * (u + v);
  }
  fragment.area = -twice / 2;
  if (fragment.area > 0) fragment.middle = origin + sum / (3 * twice);
}

// Lines through the sides, positive inside; opposite corner k.
std::array<dvec3, 3> sidesOf(const std::array<dvec2, 3>& t) {
  std::array<dvec3, 3> sides;
  for (std::size_t k = 0; k < 3; ++k) {
    const dvec2 a = t[(k + 1) % 3], b = t[(k + 2) % 3];
    sides[k] = {b.y - a.y, a.x - b.x, crossOf(b, a)};
  }
  return sides;
}

double lineAt(const dvec3& line, dvec2 p) { return line.x * p.x + line.y * p.y + line.z; }

}  // namespace

bool PixelFragment::holds(dvec2 p) const {
  return std::all_of(edges.begin(), edges.end(), [&](const dvec3& e) { return lineAt(e, p) >= 0; });
}

double PixelFragment::nearnessAt(dvec2 p) const { return std::clamp(lineAt(nearness, p), farthest, nearest); }

std::optional<PixelFragment> pixelFragment(const std::array<dvec3, 3>& triangle, glm::ivec2 pixel, bool parallel) {
  std::array<dvec2, 3> t;
  for (std::size_t k = 0; k < 3; ++k) t[k] = dvec2(triangle[k]) - dvec2(pixel);
  const PixelPolygon polygon = cutToPixel(t);
  if (polygon.size < 3) return std::nullopt;
  PixelFragment f;
  measure(polygon, f);
  if (f.area < kLeastArea) return std::nullopt;

  f.edges = sidesOf(t);
  const double whole = lineAt(f.edges[0], t[0]);  // twice the triangle's area
  f.parallel = parallel;
  const dvec3 depths(triangle[0].z, triangle[1].z, triangle[2].z), inverse = 1.0 / depths;
  const dvec3 near = parallel ? -depths : inverse;
  f.nearness = (near.x * f.edges[0] + near.y * f.edges[1] + near.z * f.edges[2]) / whole;
  f.nearest = std::max({near.x, near.y, near.z});
  f.farthest = std::min({near.x, near.y, near.z});
  f.depth = f.depthAt(f.middle);
  f.near = f.far = f.depth;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const double depth = f.depthAt(polygon.corners[i]);
    f.near = std::min(f.near, depth);
    f.far = std::max(f.far, depth);
  }
  for (int k = 0; k < 3; ++k)
    f.weights[k] =
        std::max(lineAt(f.edges[static_cast<std::size_t>(k)], f.middle), 0.0) * (parallel ? 1 : inverse[k]);
  f.weights /= std::max(f.weights.x + f.weights.y + f.weights.z, 1e-300);
  return f;
}

}  // namespace poinsot::render
