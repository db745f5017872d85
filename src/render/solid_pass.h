// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "gl/storage.h"
#include "gl/unique_name.h"

namespace poinsot::render {

/// Pass over the solids: decides which of their fragments are stored. The values are those of EDGES in emit.glsl.
enum class SolidPass { kFull = 0, kEdges = 1, kSeams = 2 };

/// Textures from earlier passes that a pass reads (emit.glsl). 0 stands for no texture.
struct PassInputs {
  GLuint edgeBefore = 0;  ///< depths of the edges found before; only edges behind these depths are stored
  GLuint fullColor = 0, fullDepth = 0;  ///< colour and depth of the full pass, for the seam pass
};

/// Binds the textures to the texture units 1 to 3. Unit 0 is left to the painter.
void bindInputs(const PassInputs& inputs);

/// Declares a vertex attribute of `components` floats, stored in the bound buffer.
void floatAttribute(GLuint index, GLint components, std::size_t stride, std::size_t offset);

/// Copies values to a buffer, which remains bound.
/// @throws core::Error(kGraphics) if the back end has no room for it.
template <typename Value>
void upload(GLenum target, const gl::BufferName& buffer, const std::vector<Value>& values, GLenum usage) {
  glBindBuffer(target, buffer.id());
  glBufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(Value)), values.data(), usage);
  gl::expectStored("a buffer", values.size() * sizeof(Value));
}

}  // namespace poinsot::render
