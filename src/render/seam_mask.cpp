// SPDX-License-Identifier: Apache-2.0
#include "render/seam_mask.h"

#include <algorithm>
#include <cmath>

#include "render/cells.h"

namespace poinsot::render {
namespace {

constexpr int kSide_px = static_cast<int>(kCell_px);

int cellsFor(float length_px) { return (static_cast<int>(length_px) + kSide_px - 1) / kSide_px; }

}  // namespace

SeamMask::SeamMask(glm::vec2 size_px)
    : size_px_(size_px),
      columns_(cellsFor(size_px.x)),
      cells_(static_cast<std::size_t>(columns_ * cellsFor(size_px.y))) {}

float SeamMask::nextSolid() {
  // Should there be so many solids that numbers come again, those alike have no seam: that is all.
  last_ = last_ + 1 < kShared ? static_cast<std::uint16_t>(last_ + 1) : static_cast<std::uint16_t>(kNone + 1);
  return shown(last_);
}

template <typename Use>
void SeamMask::forEachCell(const PixelBounds& bounds, Use use) const {
  const PixelBounds b = bounds.clipped(size_px_);
  if (b.empty()) return;
  const int right = static_cast<int>(b.right - 1) / kSide_px, bottom = static_cast<int>(b.bottom - 1) / kSide_px;
  for (int row = static_cast<int>(b.top) / kSide_px; row <= bottom; ++row)
    for (int column = static_cast<int>(b.left) / kSide_px; column <= right; ++column)
      use(column, row, static_cast<std::size_t>(row * columns_ + column));
}

void SeamMask::mark(const PixelBounds& bounds) {
  forEachCell(bounds, [&](int, int, std::size_t i) { markCell(i); });
}

void SeamMask::markCell(std::size_t cell) {
  const bool taken = cells_[cell] != 0 && cells_[cell] != last_;
  cells_[cell] = taken ? kShared : last_;
  any_ = any_ || taken;
}

void SeamMask::mark(const std::array<glm::vec2, 3>& t) {
  PixelBounds bounds;
  for (const glm::vec2& p : t) bounds.include(p);
  const PixelBounds b = bounds.clipped(size_px_);
  for (float top = kCell_px * std::floor(b.top / kCell_px); top < b.bottom; top += kCell_px) {
    const float bottom = top + kCell_px;
    PixelBounds part;  // what lies within a row of cells
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::vec2 a = t[k], c = t[(k + 1) % 3];
      if (std::max(a.y, c.y) < top || std::min(a.y, c.y) > bottom) continue;
      for (const float y : {std::clamp(a.y, top, bottom), std::clamp(c.y, top, bottom)})
        part.include(glm::vec2(c.y == a.y ? c.x : a.x + (y - a.y) / (c.y - a.y) * (c.x - a.x), y));
    }
    if (part.left > part.right) continue;
    part.include(glm::vec2(part.left, part.top), 0.5f);  // and not empty, should it be level
    part.include(glm::vec2(part.right, part.bottom), 0.5f);
    part.top = std::max(part.top, top);
    part.bottom = std::min(part.bottom, bottom);
    mark(part);
  }
}

bool SeamMask::shared(const PixelBounds& bounds) const { return !sharedPart(bounds).empty(); }

PixelBounds SeamMask::sharedPart(const PixelBounds& bounds) const {
  PixelBounds part;
  forEachCell(bounds, [&](int column, int row, std::size_t i) {
    if (cells_[i] != kShared) return;
    part.include(glm::vec2(column, row) * kCell_px);
    part.include(glm::vec2(column + 1, row + 1) * kCell_px);
  });
  return part;
}

}  // namespace poinsot::render
