// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "gl/storage.h"
#include "gl/unique_name.h"

namespace poinsot::render {

/// Selects the fragments of solids that a pass keeps. The values are EDGES in emit.glsl.
enum class SolidPass { kFull = 0, kEdges = 1, kSeams = 2 };

/// Textures of earlier passes that a pass reads (emit.glsl); 0 if unused.
struct PassInputs {
  GLuint edgeBefore = 0;                ///< depths; only edges behind them are kept
  GLuint fullColor = 0, fullDepth = 0;  ///< results of the full pass, for the seams
};

/// Binds the inputs to texture units 1 to 3. Unit 0 is the painter's own.
void bindInputs(const PassInputs& inputs);

/// Declares an attribute of `components` floats per vertex in the bound buffer.
void floatAttribute(GLuint index, GLint components, std::size_t stride, std::size_t offset);

/// Fills a buffer, which stays bound. @throws core::Error(kGraphics) if the back end has no room for it.
template <typename Value>
void upload(GLenum target, const gl::BufferName& buffer, const std::vector<Value>& values, GLenum usage) {
  glBindBuffer(target, buffer.id());
  glBufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(Value)), values.data(), usage);
  gl::expectStored("a buffer", values.size() * sizeof(Value));
}

}  // namespace poinsot::render
