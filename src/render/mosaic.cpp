// SPDX-License-Identifier: Apache-2.0
#include "render/mosaic.h"

#include <algorithm>

#include "render/cells.h"

namespace poinsot::render {
namespace {

void add(const PixelBounds& part, std::vector<PixelBounds>& parts) {
  if (!parts.empty() && parts.back().right == part.left && parts.back().top == part.top &&
      parts.back().bottom == part.bottom)
    parts.back().right = part.right;
  else
    parts.push_back(part);
}

class MosaicCutter {
 public:
  MosaicCutter(const Sheets& sheets, const SolidCells& solids, TileCache& tiles)
      : sheets_(sheets), solids_(solids), tiles_(tiles) {}

  void addTile(const PixelBounds& tile) {
    const auto [least, most] = solids_.reach(tile);
    SheetChoice chosen = sheets_.reaching(tile);
    const bool mixed = least != most || chosen.outlines;
    const Content content = contentOf(most, std::move(chosen));
    if (stands(tile, content)) return;
    if (content.empty()) return add(tile, mosaic_.paper);
    add(tile, mosaic_.drawn);
    if (mixed)
      cut(tile, content.sheets.shadows);
    else
      add(tile, mosaic_.parts[content]);
  }

  Mosaic take() { return std::move(mosaic_); }

 private:
  /// Reports whether the tile already shows this content. False if it has solids, because most solids move.
  bool stands(const PixelBounds& tile, const Content& content) {
    if (content.solids == SolidReach::kNone) return tiles_.shows(tile, content.sheets, sheets_);
    tiles_.forget(tile);
    return false;
  }

  void cut(const PixelBounds& tile, bool shadows) {
    for (float y = tile.top; y < tile.bottom; y += kCell_px)
      for (float x = tile.left; x < tile.right; x += kCell_px) {
        const PixelBounds cell{x, y, std::min(x + kCell_px, tile.right), std::min(y + kCell_px, tile.bottom)};
        Content content = contentOf(solids_.reach(cell)[1], sheets_.reaching(cell));
        content.sheets.shadows = shadows && !content.sheets.planes.empty();
        add(cell, mosaic_.parts[content]);
      }
  }

  /// Returns the content with which a part of the picture is drawn. Each different content needs a shader of its
  /// own. To compile fewer shaders, parts with edges, which are slow in any case, include all planes and outlines.
  Content contentOf(SolidReach solids, SheetChoice chosen) const {
    const bool edges = solids >= SolidReach::kOneEdge;
    if (edges || (chosen.outlines && !(chosen.ellipsoids.empty() && chosen.cones.empty())))
      sheets_.addPlanesTo(chosen);
    if (edges && !chosen.empty()) chosen.outlines = true;
    return {solids, std::move(chosen)};
  }

  const Sheets& sheets_;
  const SolidCells& solids_;
  TileCache& tiles_;
  Mosaic mosaic_;
};

}  // namespace

Mosaic cutIntoMosaic(glm::vec2 size_px, const Sheets& sheets, const SolidCells& solids, TileCache& tiles) {
  constexpr float side = kTile_px;
  MosaicCutter cutter(sheets, solids, tiles);
  for (float y = 0; y < size_px.y; y += side)
    for (float x = 0; x < size_px.x; x += side)
      cutter.addTile({x, y, std::min(x + side, size_px.x), std::min(y + side, size_px.y)});
  return cutter.take();
}

}  // namespace poinsot::render
