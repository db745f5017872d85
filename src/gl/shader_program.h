// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "gl/unique_name.h"

namespace poinsot::gl {

/// Linked program of a vertex shader and a fragment shader. Call set() only while the program is in use. Uniforms
/// that the compiler has removed are ignored.
class ShaderProgram {
 public:
  /// Compiles and links two sources. The #version line is added here.
  /// @param label  name of the program in error messages
  /// @throws core::Error(kGraphics) with the compiler's log.
  ShaderProgram(const std::string& label, const std::string& vertexSource, const std::string& fragmentSource);

  void use() const { glUseProgram(program_.id()); }
  void set(const char* name, int value) const;
  void set(const char* name, glm::vec2 value) const;
  void set(const char* name, const std::vector<glm::vec4>& values) const;

 private:
  GLint location(const char* name) const { return glGetUniformLocation(program_.id(), name); }
  ProgramName program_;
};

}  // namespace poinsot::gl
