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

// A seam, where two solids intersect, counts as an edge: the surface that appears there is stored like an edge.
SolidReach SolidCells::Cell::reach() const {
  const int edges = (strand != 0 ? 1 : 0) + (manyStrands ? 1 : 0) + (shared ? 1 : 0);
  if (edges > 0) return edges > 1 ? SolidReach::kTwoEdges : SolidReach::kOneEdge;
  return solids[0].number != 0 ? SolidReach::kInside : SolidReach::kNone;
}

SolidCells::SolidCells(glm::vec2 size_px)
    : size_px_(size_px), columns_(cellsFor(size_px.x)), rows_(cellsFor(size_px.y)), cells_(cellAt(0, rows_)) {}

float SolidCells::nextSolid() {
  // After the last number, numbering starts again. Solids with the same number merely get no seam.
  solid_ = solid_ < 0xFFFF ? static_cast<std::uint16_t>(solid_ + 1) : static_cast<std::uint16_t>(kNoSolid + 1);
  nextStrand();
  return shown(solid_);
}

template <typename Use>
void SolidCells::forEachCell(const PixelBounds& bounds, Use use) const {
  const PixelBounds b = bounds.clipped(size_px_);
  if (b.empty()) return;
  const int right = static_cast<int>(b.right - 1) / kSide_px, bottom = static_cast<int>(b.bottom - 1) / kSide_px;
  for (int row = static_cast<int>(b.top) / kSide_px; row <= bottom; ++row)
    for (int column = static_cast<int>(b.left) / kSide_px; column <= right; ++column)
      use(column, row, cellAt(column, row));
}

template <typename Use>
void SolidCells::forEachCell(const Triangle& t, Use use) const {
  PixelBounds bounds;
  for (const glm::vec2& p : t) bounds.include(p);
  const PixelBounds b = bounds.clipped(size_px_);
  for (float top = kCell_px * std::floor(b.top / kCell_px); top < b.bottom; top += kCell_px) {
    const float bottom = top + kCell_px;
    PixelBounds part;
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::vec2 a = t[k], c = t[(k + 1) % 3];
      if (std::max(a.y, c.y) < top || std::min(a.y, c.y) > bottom) continue;
      for (const float y : {std::clamp(a.y, top, bottom), std::clamp(c.y, top, bottom)})
        part.include(glm::vec2(c.y == a.y ? c.x : a.x + (y - a.y) / (c.y - a.y) * (c.x - a.x), y));
    }
    if (part.left > part.right) continue;
    // The margin keeps the part of a horizontal triangle from being empty.
    part.include(glm::vec2(part.left, part.top), 0.5f);
    part.include(glm::vec2(part.right, part.bottom), 0.5f);
    part.top = std::max(part.top, top);
    part.bottom = std::min(part.bottom, bottom);
    forEachCell(part, use);
  }
}

void SolidCells::addSolid(Cell& cell, const DepthRange& depths) {
  any_ = true;
  Solid* own = nullptr;
  for (Solid& solid : cell.solids) {
    if (solid.number == 0 || solid.number == solid_) {
      own = &solid;
      break;
    }
    cell.shared = cell.shared || solid.depths.overlaps(depths);
  }
  cell.shared = cell.shared || own == nullptr;  // no free entry: the new solid cannot be compared later
  anyShared_ = anyShared_ || cell.shared;
  if (own == nullptr) return;
  // Solids after `own` were added after this solid's first mark in the cell, so they are compared here.
  for (const Solid* other = own + 1; other != cell.solids.end(); ++other)
    cell.shared = cell.shared || (other->number != 0 && other->depths.overlaps(depths));
  anyShared_ = anyShared_ || cell.shared;
  own->number = solid_;
  own->depths.include(depths.near);
  own->depths.include(depths.far);
}

void SolidCells::addEdge(Cell& cell) {
  any_ = true;
  cell.manyStrands = cell.manyStrands || (cell.strand != 0 && cell.strand != strand_);
  cell.strand = strand_;
}

void SolidCells::markSolid(const PixelBounds& bounds, const DepthRange& depths) {
  forEachCell(bounds, [&](int, int, std::size_t i) { addSolid(cells_[i], depths); });
}

void SolidCells::markSolid(const Triangle& triangle, const DepthRange& depths) {
  forEachCell(triangle, [&](int, int, std::size_t i) { addSolid(cells_[i], depths); });
}

void SolidCells::markEdge(const PixelBounds& bounds) {
  forEachCell(bounds, [&](int, int, std::size_t i) { addEdge(cells_[i]); });
}

void SolidCells::markEdge(const Triangle& triangle) {
  forEachCell(triangle, [&](int, int, std::size_t i) { addEdge(cells_[i]); });
}

PixelBounds SolidCells::sharedPart(const PixelBounds& bounds) const {
  PixelBounds part;
  forEachCell(bounds, [&](int column, int row, std::size_t i) {
    if (!cells_[i].shared) return;
    part.include(glm::vec2(column, row) * kCell_px);
    part.include(glm::vec2(column + 1, row + 1) * kCell_px);
  });
  return part;
}

std::array<SolidReach, 2> SolidCells::reach(const PixelBounds& bounds) const {
  std::array range{SolidReach::kTwoEdges, SolidReach::kNone};
  forEachCell(bounds, [&](int, int, std::size_t i) {
    const SolidReach here = cells_[i].reach();
    range[0] = std::min(range[0], here);
    range[1] = std::max(range[1], here);
  });
  return range;
}

PixelBounds SolidCells::part() const {
  PixelBounds part;
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column)
      if (cells_[cellAt(column, row)].reach() != SolidReach::kNone) {
        part.include(kCell_px * glm::vec2(column - 1, row - 1));
        part.include(kCell_px * glm::vec2(column + 2, row + 2));
      }
  if (part.empty()) return part;
  part = part.clipped(size_px_);
  const auto tileBegin = [](float p) { return static_cast<float>(kTile_px) * std::floor(p / kTile_px); };
  part.left = tileBegin(part.left);
  part.top = tileBegin(part.top);
  return part;
}

}  // namespace poinsot::render
