// SPDX-License-Identifier: Apache-2.0
#include "figure/visibility_tree.h"

#include <algorithm>
#include <glm/common.hpp>
#include <numeric>

namespace poinsot::figure {
namespace {

constexpr std::size_t kLeaf = 4;  // number of objects in a leaf; smaller leaves cost memory, larger ones cost time

}  // namespace

void Bounds::include(glm::dvec3 p) {
  low = glm::min(low, p);
  high = glm::max(high, p);
}

void Bounds::include(const Bounds& other) {
  low = glm::min(low, other.low);
  high = glm::max(high, other.high);
}

BoundsTree::BoundsTree(const std::vector<Bounds>& things) : order_(things.size()) {
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  if (!things.empty()) build(things, 0, things.size());
}

// Builds a node: divides the objects into two halves across the longest side of the box around their centres.
std::size_t BoundsTree::build(const std::vector<Bounds>& things, std::size_t first, std::size_t count) {
  Bounds bounds, middles;
  const auto middle = [&](std::size_t k) { return things[k].low + things[k].high; };
  for (std::size_t i = first; i < first + count; ++i) {
    bounds.include(things[order_[i]]);
    middles.include(middle(order_[i]));
  }
  const std::size_t self = nodes_.size();
  nodes_.push_back({bounds, first, count <= kLeaf ? count : 0});
  if (count <= kLeaf) return self;

  const glm::dvec3 size = middles.high - middles.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(first);
  const auto half = static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(begin, begin + half, begin + static_cast<std::ptrdiff_t>(count),
                   [&](std::size_t a, std::size_t b) { return middle(a)[axis] < middle(b)[axis]; });
  const std::size_t left = build(things, first, count / 2);
  const std::size_t right = build(things, first + count / 2, count - count / 2);
  nodes_[self].left = left;
  nodes_[self].right = right;
  return self;
}

bool BoundsTree::enters(const Bounds& bounds, const Line& line, double t) {
  double enter = 0, leave = t;
  for (int i = 0; i < 3; ++i) {
    if (line.direction[i] == 0) {
      if (line.origin[i] < bounds.low[i] || line.origin[i] > bounds.high[i]) return false;
      continue;
    }
    const double a = (bounds.low[i] - line.origin[i]) / line.direction[i];
    const double b = (bounds.high[i] - line.origin[i]) / line.direction[i];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave;
}

}  // namespace poinsot::figure
