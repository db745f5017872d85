// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <vector>

#include "render/sheets.h"
#include "render/solid_cells.h"

namespace poinsot::render {

/// What a part of the picture is drawn with.
struct Content {
  SolidReach solids = SolidReach::kNone;
  SheetChoice sheets;
  auto operator<=>(const Content&) const = default;
  bool empty() const { return solids == SolidReach::kNone && sheets.empty(); }
};

/// The picture cut into rectangles by their content, those of one content together. They are as large as may be:
/// 64 pixels (llvmpipe's own tile) or wider, and about edges and outlines as small as a cell. In each row of tiles
/// they cover all from the first that is not empty to the last, empty ones between them too; paper beside them is
/// left out.
struct Mosaic {
  static constexpr int kTile_px = 64;

  /// Columns of pixels, from `from` to before `to`.
  struct Span {
    int from = 0, to = 0;

    bool empty() const { return to == 0; }
    void include(const PixelBounds& tile) {
      if (empty()) from = static_cast<int>(tile.left);
      to = static_cast<int>(tile.right);
    }
  };

  std::map<Content, std::vector<PixelBounds>> parts;
  std::vector<Span> columns;  ///< that are covered in each row of tiles
};

Mosaic cutIntoMosaic(glm::vec2 size_px, const Sheets& sheets, const SolidCells& solids);

}  // namespace poinsot::render
