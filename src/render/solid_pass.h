// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "gl/storage.h"
#include "gl/unique_name.h"

/// What the painters of solids share.
namespace poinsot::render {

/// Which fragments of the solids are kept; the numbers are EDGES in emit.glsl.
enum class SolidPass { kFull = 0, kEdges = 1, kSeams = 2 };

/// What a pass looks at of the passes before it: textures of emit.glsl, 0 for none.
struct PassInputs {
  GLuint edgeBefore = 0;                ///< depths: edges are those behind them
  GLuint fullColor = 0, fullDepth = 0;  ///< of the full pass, for the seams
};

/// Binds them to units 1 to 3; unit 0 is the painter's own.
void bindInputs(const PassInputs& inputs);

/// Describes `components` floats of each vertex in the bound buffer.
void floatAttribute(GLuint index, GLint components, std::size_t stride, std::size_t offset);

/// Fills a buffer, which stays bound. @throws core::Error(kGraphics) if the back end has no room for it.
template <typename Value>
void upload(GLenum target, const gl::BufferName& buffer, const std::vector<Value>& values, GLenum usage) {
  glBindBuffer(target, buffer.id());
  glBufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(Value)), values.data(), usage);
  gl::expectStored("a buffer", values.size() * sizeof(Value));
}

}  // namespace poinsot::render
