// SPDX-License-Identifier: Apache-2.0
#include "render/cells.h"

#include <algorithm>

namespace poinsot::render {
namespace {

constexpr float kCell_px = 16;   // smaller ones cost more as triangles than they save as pixels
constexpr float kMargin_px = 1;  // of soft edge

}  // namespace

Cells cutIntoCells(const PixelBounds& b, const std::function<bool(glm::vec2)>& inside) {
  Cells cells;
  for (float y = b.top; y < b.bottom; y += kCell_px) {
    for (float x = b.left; x < b.right; x += kCell_px) {
      const PixelBounds cell{x, y, std::min(x + kCell_px, b.right), std::min(y + kCell_px, b.bottom)};
      const float l = cell.left - kMargin_px, r = cell.right + kMargin_px;
      const float t = cell.top - kMargin_px, u = cell.bottom + kMargin_px;
      // Four corners inside a convex outline: all of the cell is.
      const bool whole = inside({l, t}) && inside({r, t}) && inside({l, u}) && inside({r, u});
      addRectangle(whole ? cells.full : cells.edge, cell);
    }
  }
  return cells;
}

void addRectangle(std::vector<glm::vec2>& triangles, const PixelBounds& t) {
  const glm::vec2 a(t.left, t.top), b(t.right, t.top), c(t.left, t.bottom), d(t.right, t.bottom);
  triangles.insert(triangles.end(), {a, b, c, c, b, d});
}

}  // namespace poinsot::render
