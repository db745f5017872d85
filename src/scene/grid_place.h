// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace poinsot::scene {

/// Where a panel lies in the picture's grid, whose cells fill it.
struct GridPlace {
  int column = 0, row = 0;    ///< of its top left cell, from the picture's top left
  int columns = 1, rows = 1;  ///< cells that it spans
};

}  // namespace poinsot::scene
