// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/abi.h"

namespace poinsot::scene {

/// Place of a panel in the grid of cells that fills the picture.
struct GridPlace {
  int column = 0, row = 0;    ///< top left cell, counted from the picture's top left
  int columns = 1, rows = 1;  ///< size in cells
};

inline bool overlap(const GridPlace& a, const GridPlace& b) {
  return a.column < b.column + b.columns && b.column < a.column + a.columns && a.row < b.row + b.rows &&
         b.row < a.row + a.rows;
}

}  // namespace poinsot::scene
