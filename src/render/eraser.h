// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gl/shader_program.h"
#include "render/constants.h"
#include "render/solid_cells.h"

namespace poinsot::render {

/// Clears layers where they will be looked at: a quarter of a usual picture, and llvmpipe's glClear takes no part.
class Eraser {
 public:
  Eraser();
  /// The places to clear: the cells that are marked, and those next to them, for neighbouring pixels are read too.
  void prepare(const SolidCells& cells, const Constants& ofPicture);
  /// Makes the bound framebuffer's colour 0 and its depth 1 there.
  void erase() const;

 private:
  gl::ShaderProgram program_;
  gl::VertexArrayName vertices_ = gl::VertexArrayName::make();
  gl::BufferName buffer_ = gl::BufferName::make();
  GLsizei count_ = 0;
  Constants ofPicture_;
};

}  // namespace poinsot::render
