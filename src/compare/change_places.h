// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "image/image.h"

namespace poinsot::compare {

/// Differing pixels that lie close together.
struct ChangedPlace {
  image::PixelRect box;     ///< the smallest around them
  std::int64_t pixels = 0;  ///< that differ
  friend bool operator==(const ChangedPlace&, const ChangedPlace&) = default;
};

/// Collects differing pixels into places. Pixels with fewer than 8 equal ones between them always share a place,
/// pixels with 16 or more never do unless others connect them: letters of a word are one place.
class PlaceFinder {
 public:
  explicit PlaceFinder(image::PixelSize size);
  void add(int x, int y) {
    ChangedPlace& here = cell(x / kCell, y / kCell);
    if (here.pixels++ == 0) here.box = {x, y, x, y};
    here.box = {std::min(here.box.left, x), std::min(here.box.top, y), std::max(here.box.right, x + 1),
                std::max(here.box.bottom, y + 1)};
  }

  /// Returns the places, the one with most pixels first, those of equal count from the top left. Call once.
  std::vector<ChangedPlace> places();

 private:
  static constexpr int kCell = 8;  // pixels a side

  /// Takes the place that grows from a cell over its neighbours, and leaves their cells empty.
  ChangedPlace placeFrom(int column, int row);
  ChangedPlace& cell(int column, int row) {
    return cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)];
  }

  int columns_, rows_;
  std::vector<ChangedPlace> cells_;
};

}  // namespace poinsot::compare
