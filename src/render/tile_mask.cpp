// SPDX-License-Identifier: Apache-2.0
#include "render/tile_mask.h"

#include <algorithm>

namespace poinsot::render {
namespace {

int tilesFor(float length_px) {
  return (static_cast<int>(length_px) + TileMask::kTile_px - 1) / TileMask::kTile_px;
}

}  // namespace

TileMask::TileMask(glm::vec2 size_px)
    : size_px_(size_px),
      columns_(tilesFor(size_px.x)),
      rows_(tilesFor(size_px.y)),
      marks_(static_cast<std::size_t>(columns_ * rows_)) {}

void TileMask::mark(const PixelBounds& bounds) {
  const PixelBounds b = bounds.clipped(size_px_);
  if (b.empty()) return;
  any_ = true;
  const int right = static_cast<int>(b.right - 1) / kTile_px, bottom = static_cast<int>(b.bottom - 1) / kTile_px;
  for (int row = static_cast<int>(b.top) / kTile_px; row <= bottom; ++row)
    for (int column = static_cast<int>(b.left) / kTile_px; column <= right; ++column)
      marks_[index(column, row)] = true;
}

PixelBounds TileMask::tile(int column, int row) const {
  const auto x = static_cast<float>(column * kTile_px), y = static_cast<float>(row * kTile_px);
  return {x, y, std::min(x + kTile_px, size_px_.x), std::min(y + kTile_px, size_px_.y)};
}

}  // namespace poinsot::render
