// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <vector>

#include "render/sheets.h"
#include "render/solid_cells.h"
#include "render/tile_cache.h"

namespace poinsot::render {

/// Solids and sheets that are drawn in one part of the picture.
struct Content {
  SolidReach solids = SolidReach::kNone;
  SheetChoice sheets;
  auto operator<=>(const Content&) const = default;  // NOLINT(modernize-use-nullptr): of what is made here
  bool empty() const { return solids == SolidReach::kNone && sheets.empty(); }
};

/// Picture divided into rectangles with equal content. Most rectangles are whole tiles or rows of tiles; at edges
/// and outlines they may be as small as a cell. Tiles unchanged since the previous picture are left out.
struct Mosaic {
  /// rectangles to draw, by content; empty background only within drawn tiles
  std::map<Content, std::vector<PixelBounds>> parts;
  std::vector<PixelBounds> drawn;  ///< tiles that `parts` cover; adjacent tiles are joined
  std::vector<PixelBounds> paper;  ///< tiles that show only the background
};

/// Divides a picture into a mosaic.
/// @param tiles  cache of this picture, on which beginPicture() was called with all numbers except the sheets'
Mosaic cutIntoMosaic(glm::vec2 size_px, const Sheets& sheets, const SolidCells& solids, TileCache& tiles);

}  // namespace poinsot::render
