// SPDX-License-Identifier: Apache-2.0
#include "stage/picture_layout.h"

#include <algorithm>
#include <cmath>

#include "core/expect.h"

namespace poinsot::stage {
namespace {

constexpr double kMostTaken = 0.4;               // largest fraction of the picture that text takes at each side
constexpr double kRule = 0.75, kRuleInset = 16;  // width of a separator, and gap at its ends, in widths of a line
constexpr float kRuleOpacity = 0.35f;

/// Returns the position of grid line `i` if `n` cells of equal size lie between `from` and `to`.
int lineAt(int i, int n, int from, int to) {
  return from + static_cast<int>(std::lround(static_cast<double>(to - from) * i / n));
}

}  // namespace

PictureLayout::PictureLayout(std::vector<scene::GridPlace> places) : places_(std::move(places)) {
  POINSOT_EXPECT(!places_.empty());
  for (const scene::GridPlace& place : places_) {
    for (const scene::GridPlace* before = places_.data(); before != &place; ++before)
      POINSOT_EXPECT(!scene::overlap(*before, place));
    columns_ = std::max(columns_, place.column + place.columns);
    rows_ = std::max(rows_, place.row + place.rows);
  }
}

std::vector<Cell> PictureLayout::cells(glm::ivec2 size_px, const NoteReach& taken) const {
  const glm::dvec2 size(size_px), most = kMostTaken * size;
  const glm::ivec2 from(std::min(taken.left, most.x), std::min(taken.top, most.y));
  const glm::ivec2 to(size - glm::dvec2(std::min(taken.right, most.x), std::min(taken.bottom, most.y)));
  std::vector<Cell> cells;
  for (const scene::GridPlace& place : places_) {
    const glm::ivec2 low(lineAt(place.column, columns_, from.x, to.x), lineAt(place.row, rows_, from.y, to.y));
    const glm::ivec2 high(lineAt(place.column + place.columns, columns_, from.x, to.x),
                          lineAt(place.row + place.rows, rows_, from.y, to.y));
    cells.push_back({low, glm::max(high - low, glm::ivec2(1))});
  }
  return cells;
}

void PictureLayout::addRules(draw::Picture& picture, const std::vector<Cell>& cells, double line_px,
                             const Palette& colors) const {
  const auto width = static_cast<float>(kRule * line_px), inset = static_cast<float>(kRuleInset * line_px);
  const auto add = [&](glm::vec2 from, glm::vec2 to) {
    const glm::vec2 along = glm::vec2(to.x > from.x ? inset : 0, to.y > from.y ? inset : 0);
    picture.strokes.push_back({.points_px = {from + along, to - along},
                               .width_px = width,
                               .color = colors.quietInk,
                               .opacity = kRuleOpacity});
  };
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const glm::vec2 low(cells[i].origin_px), high(cells[i].origin_px + cells[i].size_px);
    if (places_[i].column > 0) add(low, {low.x, high.y});
    if (places_[i].row > 0) add(low, {high.x, low.y});
  }
}

}  // namespace poinsot::stage
