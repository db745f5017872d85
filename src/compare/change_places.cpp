// SPDX-License-Identifier: Apache-2.0
#include "compare/change_measures.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace poinsot::compare {
namespace {

void join(ChangedPlace& place, const ChangedPlace& other) {
  if (place.pixels == 0) place.box = other.box;
  place.box = {std::min(place.box.left, other.box.left), std::min(place.box.top, other.box.top),
               std::max(place.box.right, other.box.right), std::max(place.box.bottom, other.box.bottom)};
  place.pixels += other.pixels;
}

}  // namespace

PlaceFinder::PlaceFinder(image::PixelSize size)
    : columns_((size.width + kCell - 1) / kCell),
      rows_((size.height + kCell - 1) / kCell),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

ChangedPlace PlaceFinder::placeFrom(int column, int row) {
  ChangedPlace place;
  std::vector<std::pair<int, int>> open;
  const auto take = [&](int c, int r) {
    ChangedPlace& here = cell(c, r);
    if (here.pixels == 0) return;
    join(place, std::exchange(here, {}));
    open.emplace_back(c, r);
  };
  for (take(column, row); !open.empty();) {
    const auto [c, r] = open.back();
    open.pop_back();
    for (int y = std::max(r - 1, 0); y <= std::min(r + 1, rows_ - 1); ++y)
      for (int x = std::max(c - 1, 0); x <= std::min(c + 1, columns_ - 1); ++x) take(x, y);
  }
  return place;
}

std::vector<ChangedPlace> PlaceFinder::places() {
  std::vector<ChangedPlace> found;
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column)
      if (cell(column, row).pixels > 0) found.push_back(placeFrom(column, row));
  std::ranges::sort(found, {}, [](const ChangedPlace& place) {
    return std::tuple(-place.pixels, place.box.top, place.box.left);
  });
  return found;
}

}  // namespace poinsot::compare
