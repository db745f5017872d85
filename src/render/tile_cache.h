// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "render/cells.h"
#include "render/sheets.h"

namespace poinsot::render {

/// What the tiles of a picture showed last, where that was sheets or paper alone: a film's plane and ground stand
/// still, and need not be drawn, read and converted again. A tile is known by all numbers that decide its pixels,
/// so that the same bytes come whatever the picture before was.
class TileCache {
 public:
  /// @param common  the numbers that all tiles depend on. If they or the size are others than last time, or that
  /// picture was not ended, nothing is remembered.
  void beginPicture(glm::ivec2 size_px, Constants common);
  /// Whether the tile shows these sheets already, and just so; if not, it does from now on.
  bool shows(const PixelBounds& tile, const SheetChoice& chosen, const Sheets& sheets);
  /// Something else was drawn there.
  void forget(const PixelBounds& place);
  /// All tiles show what was said of them.
  void endPicture() { ended_ = true; }

 private:
  /// What tiles without solids may show.
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
  std::vector<int> shown_;  // the look's name by tile, row by row; 0: nothing known
  int names_ = 0;
};

}  // namespace poinsot::render
