// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "draw/picture.h"
#include "scene/grid_place.h"
#include "stage/palette.h"
#include "stage/type/note_layout.h"

namespace poinsot::stage {

struct Cell {
  glm::ivec2 origin_px{0}, size_px{1, 1};
};

/// Layout of a picture's panels: cells of a grid that fills the picture, except for the room that text takes.
class PictureLayout {
 public:
  /// @pre `places` is not empty, and no two places overlap.
  explicit PictureLayout(std::vector<scene::GridPlace> places);

  /// Returns the cells of the panels, in the order of the places that the constructor got.
  /// @param taken  room for text at each side of the picture
  std::vector<Cell> cells(glm::ivec2 size_px, const NoteReach& taken) const;

  void addRules(draw::Picture& picture, const std::vector<Cell>& cells, double line_px,
                const Palette& colors) const;

 private:
  std::vector<scene::GridPlace> places_;
  int columns_ = 1, rows_ = 1;
};

}  // namespace poinsot::stage
