// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "render/cells.h"
#include "render/sheets.h"

namespace poinsot::render {

/// Cache of what the tiles of a picture showed last, for tiles of sheets or paper only. A film's plane and ground
/// stand still and need not be drawn, read and converted again. All numbers that decide the pixels of a tile
/// identify its content, so that its bytes do not depend on earlier pictures.
class TileCache {
 public:
  /// Starts a picture. Clears the cache if the size or `common` has changed, or if the last picture was not ended.
  /// @param common  numbers that all tiles depend on
  void beginPicture(glm::ivec2 size_px, Constants common);
  /// Reports whether the tile already shows exactly these sheets, and records that it does from now on.
  bool shows(const PixelBounds& tile, const SheetChoice& chosen, const Sheets& sheets);
  /// Clears the entries of the tiles at a place that shows something else now.
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
  std::vector<int> shown_;  // name of the look by tile, row by row; 0: unknown
  int names_ = 0;
};

}  // namespace poinsot::render
