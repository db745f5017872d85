// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "draw/picture.h"
#include "scene/note.h"
#include "stage/type/pixel_box.h"

/// Text at nine fixed positions of a picture: title, notes and read-outs.
namespace poinsot::stage {

/// Text on the baseline of a row, `x_px` from the row's left end.
struct NotePiece {
  std::string tex;
  double x_px = 0, size_px = 1;
  draw::Color color{0};
};

struct NoteRow {
  std::vector<NotePiece> pieces;
  double width_px = 0;
  double ascent_px = 0, descent_px = 0;  ///< heights above and below the baseline, with the gap to the next row
  bool halo = true;                      ///< rim that keeps the row legible over the drawing
  double opacity = 1;
};

struct NoteBlock {
  scene::Spot at = scene::Spot::kTop;
  std::vector<NoteRow> rows;

  glm::dvec2 size_px() const;
};

/// Returns the boxes of blocks in a picture. Boxes do not overlap, and all are inside the picture if possible.
/// Blocks at the top and at the bottom stay as near to their edge as other blocks allow. Blocks in the middle row
/// move down to avoid others.
/// @param blocks  at most one block at each position, in any order
/// @param edge_px  room that stays free at the picture's edges
std::vector<PixelBox> placedBlocks(const std::vector<NoteBlock>& blocks, glm::dvec2 size_px, double edge_px);

/// Distances that blocks reach into the picture from its sides, px.
struct NoteReach {
  double left = 0, top = 0, right = 0, bottom = 0;
};

NoteReach reachOf(const std::vector<NoteBlock>& blocks, const std::vector<PixelBox>& boxes, glm::dvec2 size_px);

/// Returns true if the blocks leave enough room for the panels, and no block reaches beyond the picture.
bool leavesRoom(const std::vector<PixelBox>& boxes, const NoteReach& reach, glm::dvec2 size_px);

/// Adds the text of the blocks. Text is left-aligned in blocks on the left, centred in the middle, and
/// right-aligned on the right.
void addBlocks(draw::Picture& picture, const std::vector<NoteBlock>& blocks, const std::vector<PixelBox>& boxes);

}  // namespace poinsot::stage
