// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "draw/draw_list.h"
#include "gl/shader_program.h"

namespace poinsot::render {

/// Constants of one draw call, in the order in which shaders index them (constants.glsl).
using Constants = std::vector<glm::vec4>;

/// Constants that all draw calls of a picture have in common. `size_px` is for vertex shaders only. `layers_px` is
/// the top left corner of the solid layers in the picture. `shared` holds the first constants of each draw call.
struct PictureConstants {
  glm::vec2 size_px;
  glm::vec2 layers_px;
  Constants shared;
};

/// @param sharpness  steepness of edges, as in RenderOptions
PictureConstants pictureConstants(const draw::DrawList& list, float sharpness, glm::vec2 layers_px);

/// Compiles a program whose draw calls have `own` constants in addition to the picture's constants.
/// @param defines  lines inserted before the fragment shader
gl::ShaderProgram programWithConstants(const std::string& vertexFile, const std::string& fragmentFile,
                                       std::size_t own, const std::string& defines);

void useWith(const gl::ShaderProgram& program, const PictureConstants& ofPicture, const Constants& own);

}  // namespace poinsot::render
