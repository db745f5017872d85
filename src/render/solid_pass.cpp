// SPDX-License-Identifier: Apache-2.0
#include "render/solid_pass.h"

#include <glm/geometric.hpp>

#include "render/shader_source.h"

namespace poinsot::render {

gl::ShaderProgram solidProgram(const std::string& vertex, const std::string& fragment, SolidPass pass,
                               const std::string& defines) {
  const std::string passDefine = "#define EDGES " + std::to_string(static_cast<int>(pass)) + "\n";
  return {fragment, shaderSource(vertex), shaderSource(fragment, passDefine + defines)};
}

void setPicture(const gl::ShaderProgram& program, const draw::DrawList& list, float sharpness) {
  program.use();
  program.set("pictureSize_px", list.camera.size_px);
  program.set("opticalCentre_px", list.camera.centre_px);
  program.set("focal_px", list.camera.focal_px());
  program.set("orthographic", list.camera.orthographic ? 1.0f : 0.0f);
  program.set("depthRange", glm::vec2(list.camera.near, list.camera.far));
  program.set("sharpness", sharpness);
  program.set("edgeBefore", 1);
  program.set("fullColor", 2);
  program.set("fullDepth", 3);
  program.set("lightDirection_C", glm::normalize(list.lightDirection_C));
}

void bindInputs(const PassInputs& inputs) {
  GLenum unit = GL_TEXTURE1;
  for (const GLuint texture : {inputs.edgeBefore, inputs.fullColor, inputs.fullDepth}) {
    glActiveTexture(unit++);
    glBindTexture(GL_TEXTURE_2D, texture);
  }
}

void setMaterial(const gl::ShaderProgram& program, const draw::Material& material) {
  program.set("color", material.color);
  program.set("gloss", material.gloss);
}

void floatAttribute(GLuint index, GLint components, std::size_t stride, std::size_t offset) {
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, components, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                        reinterpret_cast<const void*>(offset));
}

}  // namespace poinsot::render
