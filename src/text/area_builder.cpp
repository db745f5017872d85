// SPDX-License-Identifier: Apache-2.0
#include "text/area_builder.h"

#include <algorithm>

namespace poinsot::text {

AreaBuilder::AreaBuilder(int width, int height)
    : width_(width),
      height_(height),
      change_(static_cast<std::size_t>(width + 2) * static_cast<std::size_t>(height), 0.0) {}

void AreaBuilder::addSegment(Segment segment) {
  Point from = segment.from, to = segment.to;
  if (from.y == to.y) return;
  const double sign = from.y < to.y ? 1 : -1;
  if (sign < 0) std::swap(from, to);
  const double slope = (to.x - from.x) / (to.y - from.y);
  const auto xAt = [&](double y) {
    return std::clamp(from.x + (y - from.y) * slope, std::min(from.x, to.x), std::max(from.x, to.x));
  };
  const int last = std::min(height_ - 1, static_cast<int>(std::floor(to.y)));
  for (int y = static_cast<int>(std::floor(from.y)); y <= last; ++y) {
    const double top = std::max<double>(y, from.y), bottom = std::min<double>(y + 1, to.y);
    addInRow(y, sign * (bottom - top), xAt(top), xAt(bottom));
  }
}

void AreaBuilder::addInRow(int y, double signedHeight, double x0, double x1) {
  const double left = std::min(x0, x1), right = std::max(x0, x1);
  double* row = change_.data() + static_cast<std::ptrdiff_t>(y) * (width_ + 2);
  for (int x = static_cast<int>(std::floor(left)); x == std::floor(left) || x < right; ++x) {
    const double start = std::max<double>(x, left), end = std::min<double>(x + 1, right);
    const double share = right > left ? signedHeight * ((end - start) / (right - left)) : signedHeight;
    // Fraction of the pixel to the left of the edge, which the edge does not cover.
    const double beyond = (start + end) / 2 - x;
    row[x] += share * (1 - beyond);
    row[x + 1] += share * beyond;
  }
}

std::vector<double> AreaBuilder::coverage() const {
  std::vector<double> result;
  result.reserve(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  for (int y = 0; y < height_; ++y) {
    const double* row = change_.data() + static_cast<std::ptrdiff_t>(y) * (width_ + 2);
    double covered = 0;
    for (int x = 0; x < width_; ++x) {
      covered += row[x];
      result.push_back(std::min(1.0, std::abs(covered)));
    }
  }
  return result;
}

}  // namespace poinsot::text
