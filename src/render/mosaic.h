// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <vector>

#include "render/sheets.h"
#include "render/solid_cells.h"
#include "render/tile_cache.h"

namespace poinsot::render {

/// What a part of the picture is drawn with.
struct Content {
  SolidReach solids = SolidReach::kNone;
  SheetChoice sheets;
  auto operator<=>(const Content&) const = default;  // NOLINT(modernize-use-nullptr): of what is made here
  bool empty() const { return solids == SolidReach::kNone && sheets.empty(); }
};

/// The picture cut into rectangles by their content, those of one content together. They are as large as may be:
/// a tile or wider, and about edges and outlines as small as a cell. Tiles that show the
/// same as in the picture before are left out.
struct Mosaic {
  std::map<Content, std::vector<PixelBounds>> parts;  ///< none of them empty paper but within a tile
  std::vector<PixelBounds> drawn;                     ///< the tiles that they make up, those side by side as one
  std::vector<PixelBounds> paper;                     ///< tiles with nothing on them
};

/// @param tiles  of a picture begun with all numbers that the tiles depend on beside the sheets'.
Mosaic cutIntoMosaic(glm::vec2 size_px, const Sheets& sheets, const SolidCells& solids, TileCache& tiles);

}  // namespace poinsot::render
