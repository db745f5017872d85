// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "gl/shader_program.h"
#include "render/constants.h"
#include "render/solid_cells.h"

namespace poinsot::render {

/// Clears layers where they will be looked at: a quarter of a usual picture, and llvmpipe's glClear takes no part.
class Eraser {
 public:
  Eraser();
  /// The places to clear, for each layer: where solids are, where edges, where two of them may be in a pixel.
  void prepare(const SolidCells& cells, const Constants& ofPicture);
  /// Makes the bound framebuffer's depth 1 there: nobody looks at the colour then. `layer` is 0 to 2 in that
  /// order.
  void erase(std::size_t layer) const;

 private:
  gl::ShaderProgram program_;
  gl::VertexArrayName vertices_ = gl::VertexArrayName::make();
  gl::BufferName buffer_ = gl::BufferName::make();
  std::array<GLint, 4> starts_{};  // of the layers' vertices, and their end
  Constants ofPicture_;
};

}  // namespace poinsot::render
