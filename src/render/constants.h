// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "draw/draw_list.h"
#include "gl/shader_program.h"

namespace poinsot::render {

/// Values that all pixels of a draw call share, in the order in which shaders index them (constants.glsl).
using Constants = std::vector<glm::vec4>;

/// Constants that all draw calls of a picture share: its size, which only vertex shaders read, the top left corner
/// of the solid layers in it, and `shared`, the first constants of every draw call.
struct PictureConstants {
  glm::vec2 size_px;
  glm::vec2 layers_px;
  Constants shared;
};

PictureConstants pictureConstants(const draw::DrawList& list, float sharpness, glm::vec2 layers_px);

/// Makes a program whose draw calls have `own` constants besides those of the picture.
/// @param defines  lines put before the fragment shader
gl::ShaderProgram programWithConstants(const std::string& vertexFile, const std::string& fragmentFile,
                                       std::size_t own, const std::string& defines);

void useWith(const gl::ShaderProgram& program, const PictureConstants& ofPicture, const Constants& own);

}  // namespace poinsot::render
