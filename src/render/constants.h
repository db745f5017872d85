// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "draw/draw_list.h"
#include "gl/shader_program.h"

namespace poinsot::render {

/// What all pixels of a draw call share, in the order in which shaders count it (constants.glsl).
using Constants = std::vector<glm::vec4>;

/// Those of the picture.
struct PictureConstants {
  glm::vec2 size_px;    ///< which only vertex shaders ask for
  glm::vec2 layers_px;  ///< where in it the layers of the solids begin
  Constants shared;     ///< which come first
};

/// @param sharpness  of edges (RenderOptions)
PictureConstants pictureConstants(const draw::DrawList& list, float sharpness, glm::vec2 layers_px);

/// A program whose draw calls have `own` constants beside those of the picture.
/// @param defines  before the fragment shader
gl::ShaderProgram programWithConstants(const std::string& vertexFile, const std::string& fragmentFile,
                                       std::size_t own, const std::string& defines);

/// Takes the program into use for a draw call.
void useWith(const gl::ShaderProgram& program, const PictureConstants& ofPicture, const Constants& own);

}  // namespace poinsot::render
