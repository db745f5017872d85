// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/abi.h"

namespace poinsot::scene {

/// Position and size of a panel in the grid of the picture, in cells.
struct GridPlace {
  int column = 0, row = 0;    ///< top left cell of the panel; 0, 0 is the picture's top left cell
  int columns = 1, rows = 1;  ///< size of the panel in cells
};

inline bool overlap(const GridPlace& a, const GridPlace& b) {
  return a.column < b.column + b.columns && b.column < a.column + a.columns && a.row < b.row + b.rows &&
         b.row < a.row + a.rows;
}

}  // namespace poinsot::scene
