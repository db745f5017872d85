// SPDX-License-Identifier: Apache-2.0
#include "render/eraser.h"

#include "render/cells.h"
#include "render/solid_pass.h"

namespace poinsot::render {

Eraser::Eraser() : program_(programWithConstants("tiles.vert", "erase.frag", 0, "")) {
  glBindVertexArray(vertices_.id());
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
  floatAttribute(0, 2, sizeof(glm::vec2), 0);
}

void Eraser::prepare(const SolidCells& cells, const Constants& ofPicture) {
  ofPicture_ = ofPicture;
  std::vector<glm::vec2> triangles;
  for (const PixelBounds& part : cells.markedAndBeside()) addRectangle(triangles, part);
  count_ = static_cast<GLsizei>(triangles.size());
  upload(GL_ARRAY_BUFFER, buffer_, triangles, GL_STREAM_DRAW);
}

void Eraser::erase() const {
  if (count_ == 0) return;
  useWith(program_, ofPicture_, {});
  glBindVertexArray(vertices_.id());
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_ALWAYS);
  glDepthRange(1, 1);
  glDrawArrays(GL_TRIANGLES, 0, count_);
  glDepthRange(0, 1);
  glDisable(GL_DEPTH_TEST);
}

}  // namespace poinsot::render
