// SPDX-License-Identifier: Apache-2.0
#include "render/solid_pass.h"

namespace poinsot::render {

void bindInputs(const PassInputs& inputs) {
  GLenum unit = GL_TEXTURE1;
  for (const GLuint texture : {inputs.edgeBefore, inputs.fullColor, inputs.fullDepth}) {
    glActiveTexture(unit++);
    glBindTexture(GL_TEXTURE_RECTANGLE, texture);
  }
}

void floatAttribute(GLuint index, GLint components, std::size_t stride, std::size_t offset) {
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(
      index, components, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
      reinterpret_cast<const void*>(offset));  // NOLINT(performance-no-int-to-ptr): so OpenGL has it
}

}  // namespace poinsot::render
