// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "draw/picture.h"
#include "scene/note.h"
#include "stage/type/pixel_box.h"

/// Type that stands still at nine places of a picture: title, notes, read-outs.
namespace poinsot::stage {

/// Type on one baseline, `x_px` from the row's left end.
struct NotePiece {
  std::string tex;
  double x_px = 0, size_px = 1;
  draw::Color color{0};
};

struct NoteRow {
  std::vector<NotePiece> pieces;
  double width_px = 0;
  double ascent_px = 0, descent_px = 0;  ///< above and below the baseline, with the space to the next row
  bool halo = true;                      ///< rim that keeps the row legible over the drawing
  double opacity = 1;
};

struct NoteBlock {
  scene::Spot at = scene::Spot::kTop;
  std::vector<NoteRow> rows;

  glm::dvec2 size_px() const;
};

/// Returns the boxes of blocks in a picture: none over another, and all inside if possible. Blocks at the top and
/// at the bottom stay as near to that edge as others allow; blocks in the middle row give way downwards.
/// @param blocks  at most one at each place, in any order
/// @param edge_px  room that stays free at the picture's edges
std::vector<PixelBox> placedBlocks(const std::vector<NoteBlock>& blocks, glm::dvec2 size_px, double edge_px);

/// Distances that blocks reach into the picture from its sides, px.
struct NoteReach {
  double left = 0, top = 0, right = 0, bottom = 0;
};

NoteReach reachOf(const std::vector<NoteBlock>& blocks, const std::vector<PixelBox>& boxes, glm::dvec2 size_px);

/// Returns true if panels keep enough of the picture and no block leaves it.
bool leavesRoom(const std::vector<PixelBox>& boxes, const NoteReach& reach, glm::dvec2 size_px);

/// Adds the blocks' type, aligned in each box by the block's place: left, centred or right.
void addBlocks(draw::Picture& picture, const std::vector<NoteBlock>& blocks, const std::vector<PixelBox>& boxes);

}  // namespace poinsot::stage
