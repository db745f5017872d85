// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "render/cells.h"
#include "render/sheets.h"

namespace poinsot::render {

/// Cache that records which sheets each tile of a picture showed last. A tile that shows the same sheets again,
/// such as part of a fixed ground, need not be drawn again. Tiles with solids are not cached. Two tiles count as
/// equal only if all numbers that determine their pixels are equal, so pictures do not depend on earlier ones.
class TileCache {
 public:
  /// Starts a picture. Clears the cache if the size or `common` has changed, or if endPicture() was not called for
  /// the previous picture.
  /// @param common  numbers on which all tiles depend
  void beginPicture(glm::ivec2 size_px, Constants common);
  /// Reports whether the tile already shows exactly these sheets. Records that the tile shows them now.
  bool shows(const PixelBounds& tile, const SheetChoice& chosen, const Sheets& sheets);
  /// Clears the entries of all tiles that the rectangle touches, because they were painted over.
  void forget(const PixelBounds& place);
  /// Marks the picture as complete, so that the next one may reuse its tiles.
  void endPicture() { ended_ = true; }

 private:
  struct Look {
    SheetChoice chosen;
    Constants constants;
    int name = 0;
  };

  int nameOf(const SheetChoice& chosen, const Sheets& sheets);
  int& shownAt(const PixelBounds& tile);
  int& shownAt(int column, int row);

  glm::ivec2 size_px_{0}, tiles_{0};
  Constants common_;
  bool ended_ = false;
  std::vector<Look> last_, current_;
  std::vector<int> shown_;  // number of the look of each tile, row by row; 0 if unknown
  int names_ = 0;
};

}  // namespace poinsot::render
