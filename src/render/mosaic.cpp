// SPDX-License-Identifier: Apache-2.0
#include "render/mosaic.h"

#include <algorithm>

#include "render/cells.h"

namespace poinsot::render {
namespace {

/// Cuts one row of tiles after another.
class MosaicCutter {
 public:
  MosaicCutter(const Sheets& sheets, const SolidCells& solids) : sheets_(sheets), solids_(solids) {}

  void beginRow() {
    mosaic_.columns.emplace_back();
    between_.clear();
  }

  /// Empty tiles wait for one that is not.
  void addTile(const PixelBounds& tile) {
    const auto [least, most] = solids_.reach(tile);
    SheetChoice chosen = sheets_.reaching(tile);
    const bool mixed = least != most || chosen.outlines;
    const Content content = contentOf(most, std::move(chosen));
    if (content.empty()) {
      if (!mosaic_.columns.back().empty()) between_.push_back(tile);
      return;
    }
    for (const PixelBounds& paper : between_) add({}, paper);
    between_.clear();
    if (mixed)
      cut(tile);
    else
      add(content, tile);
    mosaic_.columns.back().include(tile);
  }

  Mosaic take() { return std::move(mosaic_); }

 private:
  void cut(const PixelBounds& tile) {
    for (float y = tile.top; y < tile.bottom; y += kCell_px)
      for (float x = tile.left; x < tile.right; x += kCell_px) {
        const PixelBounds cell{x, y, std::min(x + kCell_px, tile.right), std::min(y + kCell_px, tile.bottom)};
        add(contentOf(solids_.reach(cell)[1], sheets_.reaching(cell)), cell);
      }
  }

  /// As many alike as can be, for each is a shader to compile: with edges, a few more sums do not count.
  Content contentOf(SolidReach solids, SheetChoice chosen) const {
    if (solids >= SolidReach::kOneEdge && !chosen.empty()) chosen.outlines = true;
    if (chosen.outlines) sheets_.addPlanesTo(chosen);
    return {solids, std::move(chosen)};
  }

  /// Grows the last of the same content where the two lie side by side.
  void add(const Content& content, const PixelBounds& part) {
    std::vector<PixelBounds>& parts = mosaic_.parts[content];
    if (!parts.empty() && parts.back().right == part.left && parts.back().top == part.top &&
        parts.back().bottom == part.bottom)
      parts.back().right = part.right;
    else
      parts.push_back(part);
  }

  const Sheets& sheets_;
  const SolidCells& solids_;
  Mosaic mosaic_;
  std::vector<PixelBounds> between_;  // empty tiles since the last that was not
};

}  // namespace

Mosaic cutIntoMosaic(glm::vec2 size_px, const Sheets& sheets, const SolidCells& solids) {
  constexpr float side = Mosaic::kTile_px;
  MosaicCutter cutter(sheets, solids);
  for (float y = 0; y < size_px.y; y += side) {
    cutter.beginRow();
    for (float x = 0; x < size_px.x; x += side)
      cutter.addTile({x, y, std::min(x + side, size_px.x), std::min(y + side, size_px.y)});
  }
  return cutter.take();
}

}  // namespace poinsot::render
