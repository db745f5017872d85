// SPDX-License-Identifier: Apache-2.0
#include "gl/shader_program.h"

#include <glm/gtc/type_ptr.hpp>

#include "core/error.h"

namespace poinsot::gl {
namespace {

template <typename GetParameter, typename GetLog>
void requireOk(GLuint id, GLenum status, const std::string& what, GetParameter get, GetLog log) {
  GLint ok = 0, length = 0;
  get(id, status, &ok);
  if (ok) return;
  get(id, GL_INFO_LOG_LENGTH, &length);
  std::string text(static_cast<std::size_t>(length), '\0');
  log(id, length, nullptr, text.data());
  throw core::graphicsError(what + ": " + text);
}

GLuint compile(GLenum stage, const std::string& label, const std::string& source) {
  const GLuint shader = glCreateShader(stage);
  const std::string whole = "#version 330 core\n" + source;
  const char* text = whole.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  const char* name = stage == GL_VERTEX_SHADER ? " (vertex shader)" : " (fragment shader)";
  requireOk(shader, GL_COMPILE_STATUS, label + name, glGetShaderiv, glGetShaderInfoLog);
  return shader;
}

}  // namespace

ShaderProgram::ShaderProgram(const std::string& label, const std::string& vertexSource,
                             const std::string& fragmentSource)
    : program_(ProgramName::make()) {
  for (const GLuint shader :
       {compile(GL_VERTEX_SHADER, label, vertexSource), compile(GL_FRAGMENT_SHADER, label, fragmentSource)}) {
    glAttachShader(program_.id(), shader);
    glDeleteShader(shader);  // only marks the shader for deletion; the program still uses it
  }
  glLinkProgram(program_.id());
  requireOk(program_.id(), GL_LINK_STATUS, label + " (linking)", glGetProgramiv, glGetProgramInfoLog);
}

void ShaderProgram::set(const char* name, int value) const { glUniform1i(location(name), value); }
void ShaderProgram::set(const char* name, glm::vec2 value) const { glUniform2f(location(name), value.x, value.y); }
void ShaderProgram::set(const char* name, const std::vector<glm::vec4>& values) const {
  if (!values.empty())
    glUniform4fv(location(name), static_cast<GLsizei>(values.size()), glm::value_ptr(values[0]));
}

}  // namespace poinsot::gl
