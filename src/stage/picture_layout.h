// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "draw/picture.h"
#include "scene/scene.h"
#include "stage/palette.h"

namespace poinsot::stage {

/// A rectangle of the picture, in pixels.
struct Cell {
  glm::ivec2 origin_px{0}, size_px{1, 1};
};

/// The panels of a picture: cells of a grid that fill it, below its title.
class PictureLayout {
 public:
  /// @pre there are views, no two in one cell.
  explicit PictureLayout(const std::vector<scene::View>& views);

  /// The panels in the order of the views. `top_px` at the picture's top are the title's; of one view they are the
  /// panel's too.
  std::vector<Cell> cells(glm::ivec2 size_px, double top_px) const;

  /// Hairlines between panels.
  void addRules(draw::Picture& picture, const std::vector<Cell>& cells, double line_px,
                const Palette& colors) const;

 private:
  std::vector<scene::GridPlace> places_;
  int columns_ = 1, rows_ = 1;
};

}  // namespace poinsot::stage
