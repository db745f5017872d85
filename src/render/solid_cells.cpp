// SPDX-License-Identifier: Apache-2.0
#include "render/solid_cells.h"

#include <algorithm>
#include <cmath>

#include "render/cells.h"

namespace poinsot::render {
namespace {

constexpr int kSide_px = static_cast<int>(kCell_px);

int cellsFor(float length_px) { return (static_cast<int>(length_px) + kSide_px - 1) / kSide_px; }

}  // namespace

SolidCells::SolidCells(glm::vec2 size_px)
    : size_px_(size_px),
      columns_(cellsFor(size_px.x)),
      rows_(cellsFor(size_px.y)),
      solids_(static_cast<std::size_t>(columns_ * rows_)),
      reaches_(solids_.size()) {}

float SolidCells::nextSolid() {
  // Should there be so many solids that numbers come again, those alike have no seam: that is all.
  last_ = last_ + 1 < kShared ? static_cast<std::uint16_t>(last_ + 1) : static_cast<std::uint16_t>(kNone + 1);
  return shown(last_);
}

template <typename Use>
void SolidCells::forEachCell(const PixelBounds& bounds, Use use) const {
  const PixelBounds b = bounds.clipped(size_px_);
  if (b.empty()) return;
  const int right = static_cast<int>(b.right - 1) / kSide_px, bottom = static_cast<int>(b.bottom - 1) / kSide_px;
  for (int row = static_cast<int>(b.top) / kSide_px; row <= bottom; ++row)
    for (int column = static_cast<int>(b.left) / kSide_px; column <= right; ++column)
      use(column, row, static_cast<std::size_t>(row * columns_ + column));
}

template <typename Use>
void SolidCells::forEachCell(const std::array<glm::vec2, 3>& t, Use use) const {
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
    forEachCell(part, use);
  }
}

void SolidCells::reachCell(std::size_t cell, SolidReach reach) {
  reaches_[cell] = std::max(reaches_[cell], reach);
  any_ = true;
}

void SolidCells::markCell(std::size_t cell, SolidReach reach) {
  const bool taken = solids_[cell] != 0 && solids_[cell] != last_;
  solids_[cell] = taken ? kShared : last_;
  anyShared_ = anyShared_ || taken;
  reachCell(cell, taken ? SolidReach::kEdges : reach);
}

void SolidCells::mark(const PixelBounds& bounds, SolidReach reach) {
  forEachCell(bounds, [&](int, int, std::size_t i) { markCell(i, reach); });
}

void SolidCells::mark(const std::array<glm::vec2, 3>& triangle, SolidReach reach) {
  forEachCell(triangle, [&](int, int, std::size_t i) { markCell(i, reach); });
}

void SolidCells::markFlat(const std::array<glm::vec2, 3>& triangle) {
  forEachCell(triangle, [&](int, int, std::size_t i) { reachCell(i, SolidReach::kEdges); });
}

void SolidCells::markEdge(glm::vec2 p) {
  forEachCell(PixelBounds{p.x, p.y, p.x + 0.5f, p.y + 0.5f},
              [&](int, int, std::size_t i) { reachCell(i, SolidReach::kEdges); });
}

bool SolidCells::shared(const PixelBounds& bounds) const { return !sharedPart(bounds).empty(); }

PixelBounds SolidCells::sharedPart(const PixelBounds& bounds) const {
  PixelBounds part;
  forEachCell(bounds, [&](int column, int row, std::size_t i) {
    if (solids_[i] != kShared) return;
    part.include(glm::vec2(column, row) * kCell_px);
    part.include(glm::vec2(column + 1, row + 1) * kCell_px);
  });
  return part;
}

std::array<SolidReach, 2> SolidCells::reach(const PixelBounds& bounds) const {
  std::array range{SolidReach::kEdges, SolidReach::kNone};
  forEachCell(bounds, [&](int, int, std::size_t i) {
    range[0] = std::min(range[0], reaches_[i]);
    range[1] = std::max(range[1], reaches_[i]);
  });
  return range;
}

bool SolidCells::anyAround(int column, int row) const {
  for (int y = std::max(row - 1, 0); y <= std::min(row + 1, rows_ - 1); ++y)
    for (int x = std::max(column - 1, 0); x <= std::min(column + 1, columns_ - 1); ++x)
      if (reaches_[static_cast<std::size_t>(y * columns_ + x)] != SolidReach::kNone) return true;
  return false;
}

std::vector<PixelBounds> SolidCells::markedAndBeside() const {
  std::vector<PixelBounds> parts;
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      if (!anyAround(column, row)) continue;
      const int first = column;
      while (column + 1 < columns_ && anyAround(column + 1, row)) ++column;
      const glm::vec2 from = kCell_px * glm::vec2(first, row), to = kCell_px * glm::vec2(column + 1, row + 1);
      parts.push_back({from.x, from.y, std::min(to.x, size_px_.x), std::min(to.y, size_px_.y)});
    }
  }
  return parts;
}

}  // namespace poinsot::render
