// SPDX-License-Identifier: Apache-2.0
#include "render/solid_pass.h"

namespace poinsot::render {

gl::ShaderProgram solidProgram(const std::string& vertex, const std::string& fragment, SolidPass pass,
                               std::size_t ownConstants, const std::string& defines) {
  const std::string passDefine = "#define EDGES " + std::to_string(static_cast<int>(pass)) + "\n";
  return programWithConstants(vertex, fragment, ownConstants, passDefine + defines);
}

void useForSolid(const gl::ShaderProgram& program, const PictureConstants& ofPicture, const Constants& own) {
  useWith(program, ofPicture, own);
  program.set("edgeBefore", 1);
  program.set("fullColor", 2);
  program.set("fullDepth", 3);
}

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
