// SPDX-License-Identifier: Apache-2.0
#include "render/cells.h"

#include <algorithm>
#include <cmath>

namespace poinsot::render {
namespace {

constexpr float kMargin_px = 1;  // of soft edge

}  // namespace

Cells cutIntoCells(const PixelBounds& b, const std::function<bool(glm::vec2)>& inside) {
  Cells cells;
  const auto firstOf = [](float p) { return kCell_px * std::floor(p / kCell_px); };
  for (float y = firstOf(b.top); y < b.bottom; y += kCell_px) {
    for (float x = firstOf(b.left); x < b.right; x += kCell_px) {
      const PixelBounds cell{std::max(x, b.left), std::max(y, b.top), std::min(x + kCell_px, b.right),
                             std::min(y + kCell_px, b.bottom)};
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
