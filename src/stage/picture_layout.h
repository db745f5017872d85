// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "draw/picture.h"
#include "scene/grid_place.h"
#include "stage/palette.h"
#include "stage/type/note_layout.h"

namespace poinsot::stage {

/// A rectangle of the picture, in pixels.
struct Cell {
  glm::ivec2 origin_px{0}, size_px{1, 1};
};

/// The panels of a picture: cells of a grid that fills it, but for what its type takes.
class PictureLayout {
 public:
  /// @pre there are places, no two over one cell.
  explicit PictureLayout(std::vector<scene::GridPlace> places);

  /// The panels in the order of the places.
  std::vector<Cell> cells(glm::ivec2 size_px, const NoteReach& taken) const;

  /// Hairlines between panels.
  void addRules(draw::Picture& picture, const std::vector<Cell>& cells, double line_px,
                const Palette& colors) const;

 private:
  std::vector<scene::GridPlace> places_;
  int columns_ = 1, rows_ = 1;
};

}  // namespace poinsot::stage
