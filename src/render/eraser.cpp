// SPDX-License-Identifier: Apache-2.0
#include "render/eraser.h"

#include "render/cells.h"
#include "render/solid_pass.h"

namespace poinsot::render {

Eraser::Eraser() : program_(programWithConstants("squares.vert", "erase.frag", 0, "")) {
  glBindVertexArray(vertices_.id());
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
  floatAttribute(0, 3, sizeof(Square), 0);
}

void Eraser::prepare(const SolidCells& cells, const Constants& ofPicture) {
  ofPicture_ = ofPicture;
  std::vector<Square> squares;
  const auto add = [&](std::size_t layer, SolidReach least, bool beside) {
    for (const PixelBounds& part : cells.partsWith(least, beside)) addSquares(squares, part);
    starts_[layer + 1] = static_cast<GLint>(squares.size());
  };
  add(0, SolidReach::kInside, true);  // of this layer neighbouring pixels are read too
  add(1, SolidReach::kOneEdge, false);
  add(2, SolidReach::kTwoEdges, false);
  upload(GL_ARRAY_BUFFER, buffer_, squares, GL_STREAM_DRAW);
}

void Eraser::erase(std::size_t layer) const {
  const GLint first = starts_[layer], count = starts_[layer + 1] - first;
  if (count == 0) return;
  useWith(program_, ofPicture_, {});
  glBindVertexArray(vertices_.id());
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_ALWAYS);
  glDepthRange(1, 1);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glDrawArrays(GL_POINTS, first, count);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthRange(0, 1);
  glDisable(GL_DEPTH_TEST);
}

}  // namespace poinsot::render
