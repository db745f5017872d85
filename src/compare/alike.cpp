// SPDX-License-Identifier: Apache-2.0
#include "compare/alike.h"

#include <algorithm>
#include <functional>

namespace poinsot::compare {
namespace {

/// Bounding box of a change, as fractions of the picture's width and height.
struct Box {
  double left = 0, top = 0, right = 0, bottom = 0;

  explicit Box(const Changes& changes)
      : left(1.0 * changes.box.left / changes.size.width),
        top(1.0 * changes.box.top / changes.size.height),
        right(1.0 * changes.box.right / changes.size.width),
        bottom(1.0 * changes.box.bottom / changes.size.height) {}

  double area() const { return (right - left) * (bottom - top); }
};

bool areAtTheSamePlace(const Box& a, const Box& b) {
  const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
  const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
  if (width <= 0 || height <= 0) return false;
  const double common = width * height;
  return 2 * common >= a.area() + b.area() - common;
}

bool areAlike(const PictureDiff& more, const PictureDiff& less) {
  constexpr double kMostRatio = 2;
  return more.verdict == less.verdict && more.figures.flip.mean <= kMostRatio * less.figures.flip.mean &&
         kindOf(more.changes) == kindOf(less.changes) && areAtTheSamePlace(Box(more.changes), Box(less.changes));
}

}  // namespace

std::vector<AlikeGroup> alikeChanges(const std::vector<const PictureDiff*>& diffs) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < diffs.size(); ++i)
    if (diffs[i]->changes.pixels > 0) order.push_back(i);
  std::ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return diffs[i]->figures.flip.mean; });
  std::vector<AlikeGroup> groups;
  for (const std::size_t i : order) {
    const auto group = std::ranges::find_if(
        groups, [&](const AlikeGroup& g) { return areAlike(*diffs[g.members.front()], *diffs[i]); });
    if (group == groups.end())
      groups.push_back({kindOf(diffs[i]->changes), {i}});
    else
      group->members.push_back(i);
  }
  std::erase_if(groups, [](const AlikeGroup& group) { return group.members.size() < 2; });
  std::ranges::stable_sort(groups, std::greater(), [](const AlikeGroup& group) { return group.members.size(); });
  return groups;
}

}  // namespace poinsot::compare
