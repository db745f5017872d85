// SPDX-License-Identifier: Apache-2.0
#include "render/seam_mask.h"

namespace poinsot::render {
namespace {

int cellsFor(float length_px, int cell_px) { return (static_cast<int>(length_px) + cell_px - 1) / cell_px; }

}  // namespace

SeamMask::SeamMask(glm::vec2 size_px)
    : size_px_(size_px),
      columns_(cellsFor(size_px.x, kCell_px)),
      cells_(static_cast<std::size_t>(columns_ * cellsFor(size_px.y, kCell_px))) {}

float SeamMask::nextSolid() {
  // Should there be so many solids that numbers come again, those alike have no seam: that is all.
  last_ = last_ + 1 < kShared ? static_cast<std::uint16_t>(last_ + 1) : static_cast<std::uint16_t>(kNone + 1);
  return shown(last_);
}

template <typename Use>
void SeamMask::forEachCell(const PixelBounds& bounds, Use use) const {
  const PixelBounds b = bounds.clipped(size_px_);
  if (b.empty()) return;
  const int right = static_cast<int>(b.right - 1) / kCell_px, bottom = static_cast<int>(b.bottom - 1) / kCell_px;
  for (int row = static_cast<int>(b.top) / kCell_px; row <= bottom; ++row)
    for (int column = static_cast<int>(b.left) / kCell_px; column <= right; ++column)
      use(column, row, static_cast<std::size_t>(row * columns_ + column));
}

void SeamMask::mark(const PixelBounds& bounds) {
  forEachCell(bounds, [&](int, int, std::size_t i) {
    const bool taken = cells_[i] != 0 && cells_[i] != last_;
    cells_[i] = taken ? kShared : last_;
    any_ = any_ || taken;
  });
}

bool SeamMask::shared(const PixelBounds& bounds) const { return !sharedPart(bounds).empty(); }

PixelBounds SeamMask::sharedPart(const PixelBounds& bounds) const {
  PixelBounds part;
  forEachCell(bounds, [&](int column, int row, std::size_t i) {
    if (cells_[i] != kShared) return;
    part.include(glm::vec2(column, row) * static_cast<float>(kCell_px));
    part.include(glm::vec2(column + 1, row + 1) * static_cast<float>(kCell_px));
  });
  return part;
}

}  // namespace poinsot::render
