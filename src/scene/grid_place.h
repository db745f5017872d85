// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/abi.h"

namespace poinsot::scene {

/// Where a panel lies in the picture's grid, whose cells fill it.
struct GridPlace {
  int column = 0, row = 0;    ///< of its top left cell, from the picture's top left
  int columns = 1, rows = 1;  ///< cells that it spans
};

/// Whether two panels lie over one cell.
inline bool overlap(const GridPlace& a, const GridPlace& b) {
  return a.column < b.column + b.columns && b.column < a.column + a.columns && a.row < b.row + b.rows &&
         b.row < a.row + a.rows;
}

}  // namespace poinsot::scene
