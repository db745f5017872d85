// SPDX-License-Identifier: Apache-2.0
#include "render/cells.h"

#include <algorithm>
#include <cmath>

namespace poinsot::render {
namespace {

constexpr float kMargin_px = 1;
constexpr float kLargest_px = kTile_px;

/// Adds the part of an aligned square that lies within the rectangle. Splits a square that lies partly within.
void addSquares(std::vector<Square>& squares, const PixelBounds& r, glm::vec2 corner, float side) {
  if (corner.x >= r.right || corner.y >= r.bottom || corner.x + side <= r.left || corner.y + side <= r.top) return;
  if (corner.x >= r.left && corner.y >= r.top && corner.x + side <= r.right && corner.y + side <= r.bottom)
    return squares.push_back({corner + 0.5f * side, side});
  const float half = 0.5f * side;
  for (const glm::vec2& step : {glm::vec2(0), glm::vec2(half, 0), glm::vec2(0, half), glm::vec2(half)})
    addSquares(squares, r, corner + step, half);
}

}  // namespace

PixelBounds Square::bounds() const {
  const float half = 0.5f * side_px;
  return {centre_px.x - half, centre_px.y - half, centre_px.x + half, centre_px.y + half};
}

Cells cutIntoCells(const PixelBounds& b, const std::function<bool(glm::vec2)>& inside) {
  Cells cells;
  const auto firstOf = [](float p) { return kCell_px * std::floor(p / kCell_px); };
  for (float y = firstOf(b.top); y < b.bottom; y += kCell_px) {
    for (float x = firstOf(b.left); x < b.right; x += kCell_px) {
      const PixelBounds cell{std::max(x, b.left), std::max(y, b.top), std::min(x + kCell_px, b.right),
                             std::min(y + kCell_px, b.bottom)};
      const float l = cell.left - kMargin_px, r = cell.right + kMargin_px;
      const float t = cell.top - kMargin_px, u = cell.bottom + kMargin_px;
      // The outline is convex, so the whole cell is inside if its four corners are inside.
      const bool whole = inside({l, t}) && inside({r, t}) && inside({l, u}) && inside({r, u});
      addSquares(whole ? cells.full : cells.edge, cell);
    }
  }
  return cells;
}

void addSquares(std::vector<Square>& squares, const PixelBounds& r) {
  const auto first = [](float p) { return kLargest_px * std::floor(p / kLargest_px); };
  for (float y = first(r.top); y < r.bottom; y += kLargest_px)
    for (float x = first(r.left); x < r.right; x += kLargest_px) addSquares(squares, r, {x, y}, kLargest_px);
}

}  // namespace poinsot::render
