// SPDX-License-Identifier: Apache-2.0
#include "text/halo.h"

#include <algorithm>
#include <limits>

namespace poinsot::text {
namespace {

double distance2(Point p, const Segment& segment) {
  const auto& [from, to] = segment;
  const Point along = to - from, towards = p - from;
  const double length2 = along.x * along.x + along.y * along.y;
  const double t = length2 > 0 ? std::clamp((towards.x * along.x + towards.y * along.y) / length2, 0.0, 1.0) : 0;
  const Point off = towards - along * t;
  return off.x * off.x + off.y * off.y;
}

}  // namespace

HaloBuilder::HaloBuilder(int width, int height, double radius_px)
    : width_(width),
      height_(height),
      radius_px_(radius_px),
      distance2_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                 std::numeric_limits<double>::infinity()) {}

void HaloBuilder::addSegment(const Segment& segment) {
  const auto& [from, to] = segment;
  const double reach = radius_px_ + 0.5;  // distance at which the coverage of the halo's edge reaches 0
  const auto first = [&](double a, double b) {
    return std::max(0, static_cast<int>(std::floor(std::min(a, b) - reach)));
  };
  const auto last = [&](double a, double b, int size) {
    return std::min(size - 1, static_cast<int>(std::floor(std::max(a, b) + reach)));
  };
  for (int y = first(from.y, to.y); y <= last(from.y, to.y, height_); ++y) {
    double* row = distance2_.data() + static_cast<std::ptrdiff_t>(y) * width_;
    for (int x = first(from.x, to.x); x <= last(from.x, to.x, width_); ++x)
      row[x] = std::min(row[x], distance2({x + 0.5, y + 0.5}, segment));
  }
}

void HaloBuilder::growInto(std::vector<double>& coverage) const {
  for (std::size_t i = 0; i < coverage.size(); ++i) {
    const double inside = coverage[i];
    const double ring = radius_px_ + 0.5 - std::sqrt(distance2_[i]);
    // A pixel mostly inside the shapes has its edge moved outwards by the radius. For other pixels, the coverage
    // falls with the distance from the outline.
    coverage[i] = std::clamp(inside >= 0.5 ? inside + radius_px_ : std::max(inside, ring), 0.0, 1.0);
  }
}

}  // namespace poinsot::text
