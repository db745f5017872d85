// SPDX-License-Identifier: Apache-2.0
#include "render/pixel_fragment.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

namespace poinsot::render {

namespace {

using glm::dvec2;
using glm::dvec3;

// Least area of a fragment, as a fraction of a pixel. Smaller areas would only be rounding errors.
constexpr double kLeastArea = 1e-7;

double crossOf(dvec2 a, dvec2 b) { return a.x * b.y - a.y * b.x; }

/// Convex polygon. A triangle clipped by four half-planes has at most seven corners.
struct PixelPolygon {
  std::array<dvec2, 8> corners;
  std::size_t size = 0;
  void add(dvec2 p) { corners[size++] = p; }
};

// Clips a polygon by a vertical or horizontal line (Sutherland & Hodgman). With a `sign` of 1 the part with larger
// coordinates remains, with -1 the part with smaller ones.
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

// Returns the lines through the sides as (a, b, c) with a x + b y + c > 0 inside. Line k is opposite corner k.
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
  const double whole = lineAt(f.edges[0], t[0]);
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

namespace {

constexpr std::size_t kSamples = 64;
// Largest error of an area that is measured with the samples.
constexpr double kCoverageError = 0.02;

/// Sample points in a pixel, one in each of 64 columns and rows (Hammersley points). Edges of any direction,
/// upright ones too, therefore meet many different samples.
struct SamplePoints {
  std::array<float, kSamples> x{}, y{};
  constexpr SamplePoints() {
    for (std::size_t i = 0; i < kSamples; ++i) {
      std::size_t reversed = 0;
      for (std::size_t bit = 0; bit < 6; ++bit) reversed |= (i >> bit & 1) << (5 - bit);
      x[i] = (static_cast<float>(i) + 0.5f) / kSamples;
      y[i] = (static_cast<float>(reversed) + 0.5f) / kSamples;
    }
  }
};
constexpr SamplePoints kPoints;

class SampleDepths {
 public:
  SampleDepths() {
    nearest_.fill(-std::numeric_limits<float>::infinity());
    winners_.fill(-1);
  }

  int add(const PixelFragment& f, int number) {
    const glm::vec3 a(f.edges[0]), b(f.edges[1]), c(f.edges[2]), q(f.nearness);
    const auto least = static_cast<float>(f.farthest), most = static_cast<float>(f.nearest);
    int count = 0;
    for (std::size_t i = 0; i < kSamples; ++i) {
      const float x = kPoints.x[i], y = kPoints.y[i];
      const bool inside =
          (a.x * x + a.y * y + a.z >= 0) & (b.x * x + b.y * y + b.z >= 0) & (c.x * x + c.y * y + c.z >= 0);
      const float nearness = std::min(std::max(q.x * x + q.y * y + q.z, least), most);
      const bool wins = inside & (nearness > nearest_[i]);
      count += inside;
      nearest_[i] = wins ? nearness : nearest_[i];
      winners_[i] = wins ? number : winners_[i];
    }
    return count;
  }

  int wins(int number) const { return static_cast<int>(std::count(winners_.begin(), winners_.end(), number)); }
  double covered() const { return 1 - static_cast<double>(wins(-1)) / kSamples; }

 private:
  std::array<float, kSamples> nearest_;  // nearness of the nearest fragment at each sample
  std::array<int, kSamples> winners_;
};

// Reports whether another fragment hides the middle of a fragment that is too small for any sample.
bool isHidden(const PixelFragment& f, std::span<const PixelFragment> fragments) {
  const double own = f.nearnessAt(f.middle);
  return std::any_of(fragments.begin(), fragments.end(), [&](const PixelFragment& other) {
    return &other != &f && other.holds(f.middle) && other.nearnessAt(f.middle) > own;
  });
}

double total(std::span<const PixelFragment> fragments) {
  return std::accumulate(fragments.begin(), fragments.end(), 0.0,
                         [](double sum, const PixelFragment& f) { return sum + f.area; });
}

// Scales the areas so that their sum agrees with `covered`, the coverage that the samples measure. The sum can be
// wrong if many small folds of a surface are each hidden by less than a sample.
void holdTo(double covered, std::vector<double>& areas) {
  const double sum = std::accumulate(areas.begin(), areas.end(), 0.0);
  const double held = std::clamp(sum, covered - kCoverageError, covered + kCoverageError);
  if (sum > 0)
    for (double& area : areas) area *= held / sum;
}

}  // namespace

std::vector<double> visibleAreas(std::span<const PixelFragment> fragments) {
  SampleDepths samples;
  std::vector<int> counts;
  for (const PixelFragment& f : fragments) counts.push_back(samples.add(f, static_cast<int>(counts.size())));
  const bool full = samples.covered() == 1;
  std::vector<double> areas;
  std::vector<bool> estimated;
  double open = 0, partlyHidden = 0;
  for (std::size_t i = 0; i < fragments.size(); ++i) {
    const PixelFragment& f = fragments[i];
    const int wins = samples.wins(static_cast<int>(i));
    estimated.push_back(wins < counts[i]);
    double share = 1;
    if (estimated.back())
      // In a filled pixel, the parts are scaled below to fill it. A part that no sample sees must therefore keep a
      // small area (rule of succession).
      share = full ? (wins + 0.5) / (counts[i] + 1) : static_cast<double>(wins) / counts[i];
    else if (counts[i] == 0 && isHidden(f, fragments))
      share = 0;
    areas.push_back(share * f.area);
    (estimated.back() ? partlyHidden : open) += areas.back();
  }
  // Partly hidden fragments fill the area that the other fragments leave free.
  const double room = std::max(1 - open, 0.0);
  const bool fit = partlyHidden > 0 && (full || partlyHidden > room);
  const double stretch = fit ? room / partlyHidden : 1, shrink = open > 1 ? 1 / open : 1;
  for (std::size_t i = 0; i < areas.size(); ++i) areas[i] *= estimated[i] ? stretch : shrink;
  if (open < total(fragments)) holdTo(samples.covered(), areas);
  return areas;
}

}  // namespace poinsot::render
