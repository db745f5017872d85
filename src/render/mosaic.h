// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <vector>

#include "render/sheets.h"
#include "render/solid_cells.h"
#include "render/tile_cache.h"

namespace poinsot::render {

/// Solids and sheets that a part of the picture is drawn with.
struct Content {
  SolidReach solids = SolidReach::kNone;
  SheetChoice sheets;
  auto operator<=>(const Content&) const = default;  // NOLINT(modernize-use-nullptr): of what is made here
  bool empty() const { return solids == SolidReach::kNone && sheets.empty(); }
};

/// Picture cut into rectangles, grouped by content. A rectangle is a tile or wider, but may be as small as a cell
/// at edges and outlines. Tiles that show the same as in the previous picture are left out.
struct Mosaic {
  std::map<Content, std::vector<PixelBounds>> parts;  ///< empty paper occurs only within a drawn tile
  std::vector<PixelBounds> drawn;                     ///< tiles that the parts make up; adjacent ones are joined
  std::vector<PixelBounds> paper;                     ///< tiles with nothing on them
};

/// Cuts a picture into a mosaic.
/// @param tiles  cache, begun with all numbers besides those of the sheets that the tiles depend on
Mosaic cutIntoMosaic(glm::vec2 size_px, const Sheets& sheets, const SolidCells& solids, TileCache& tiles);

}  // namespace poinsot::render
