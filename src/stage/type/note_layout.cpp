// SPDX-License-Identifier: Apache-2.0
#include "stage/type/note_layout.h"

#include <algorithm>
#include <array>

namespace poinsot::stage {
namespace {

using scene::Spot;

constexpr float kNoteHalo = 0.085f;    // width of the halo around text, as a fraction of the text size
constexpr double kBlocksApart = 0.35;  // gap between blocks, as a fraction of the free edge
constexpr double kRounding_px = 1e-6;  // a box that has just been moved must not count as near again
constexpr double kMostTop = 0.4, kMostBottom = 0.35,
                 kMostSide = 0.35;  // largest fractions of the picture for text at each side

// The nine positions are numbered row by row, three in a row.
int columnOf(Spot at) { return static_cast<int>(at) % 3; }
int rowOf(Spot at) { return static_cast<int>(at) / 3; }

PixelBox wishedBox(const NoteBlock& block, glm::dvec2 picture_px, double edge_px) {
  const glm::dvec2 size = block.size_px(), spare = picture_px - size - 2 * edge_px;
  const double left = edge_px + 0.5 * columnOf(block.at) * spare.x,
               top = edge_px + 0.5 * rowOf(block.at) * spare.y;
  return {left, top, left + size.x, top + size.y};
}

PixelBox movedTo(const PixelBox& box, double top) { return {box.left, top, box.right, top + box.height()}; }

/// Moves a box until it is clear of the other boxes: up if `upwards`, otherwise down.
PixelBox clearOf(const std::vector<PixelBox>& taken, PixelBox box, bool upwards, double apart) {
  const auto blocking = [&](const PixelBox& other) { return near(box, other, apart - kRounding_px); };
  for (auto other = std::ranges::find_if(taken, blocking); other != taken.end();
       other = std::ranges::find_if(taken, blocking))
    box = movedTo(box, upwards ? other->top - apart - box.height() : other->bottom + apart);
  return box;
}

// Order in which blocks are placed. Corners come first, because the title is in a corner. The middle row comes
// last, because it has room on both sides.
constexpr std::array kOrder = {Spot::kTopLeft,    Spot::kTopRight,    Spot::kTop,
                               Spot::kBottomLeft, Spot::kBottomRight, Spot::kBottom,
                               Spot::kLeft,       Spot::kRight,       Spot::kCentre};

}  // namespace

glm::dvec2 NoteBlock::size_px() const {
  glm::dvec2 size(0);
  for (const NoteRow& row : rows) {
    size.x = std::max(size.x, row.width_px);
    size.y += row.ascent_px + row.descent_px;
  }
  return size;
}

std::vector<PixelBox> placedBlocks(const std::vector<NoteBlock>& blocks, glm::dvec2 size_px, double edge_px) {
  std::vector<PixelBox> boxes(blocks.size()), taken;
  for (const Spot at : kOrder)
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      if (blocks[i].at != at) continue;
      boxes[i] = clearOf(taken, wishedBox(blocks[i], size_px, edge_px), rowOf(at) == 2, kBlocksApart * edge_px);
      taken.push_back(boxes[i]);
    }
  return boxes;
}

NoteReach reachOf(const std::vector<NoteBlock>& blocks, const std::vector<PixelBox>& boxes, glm::dvec2 size_px) {
  NoteReach reach;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const Spot at = blocks[i].at;
    if (rowOf(at) == 0) reach.top = std::max(reach.top, boxes[i].bottom);
    if (rowOf(at) == 2) reach.bottom = std::max(reach.bottom, size_px.y - boxes[i].top);
    if (at == Spot::kLeft) reach.left = boxes[i].right;
    if (at == Spot::kRight) reach.right = size_px.x - boxes[i].left;
  }
  return reach;
}

bool leavesRoom(const std::vector<PixelBox>& boxes, const NoteReach& reach, glm::dvec2 size_px) {
  const auto inside = [&](const PixelBox& b) {
    return b.left >= 0 && b.top >= 0 && b.right <= size_px.x && b.bottom <= size_px.y;
  };
  return std::ranges::all_of(boxes, inside) && reach.top <= kMostTop * size_px.y &&
         reach.bottom <= kMostBottom * size_px.y && reach.left <= kMostSide * size_px.x &&
         reach.right <= kMostSide * size_px.x;
}

void addBlocks(draw::Picture& picture, const std::vector<NoteBlock>& blocks, const std::vector<PixelBox>& boxes) {
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    double y = boxes[i].top;
    for (const NoteRow& row : blocks[i].rows) {
      const double left = boxes[i].left + 0.5 * columnOf(blocks[i].at) * (boxes[i].width() - row.width_px);
      y += row.ascent_px;
      for (const NotePiece& piece : row.pieces) {
        const auto size_px = static_cast<float>(piece.size_px);
        draw::Text& text = picture.texts.emplace_back();
        text = {piece.tex,
                glm::vec2(glm::dvec2(left + piece.x_px, y)),
                size_px,
                piece.color,
                static_cast<float>(row.opacity),
                std::nullopt,
                0};
        if (row.halo) text.halo = picture.background, text.halo_px = kNoteHalo * size_px;
      }
      y += row.descent_px;
    }
  }
}

}  // namespace poinsot::stage
