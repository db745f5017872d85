// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "gl/shader_program.h"
#include "render/constants.h"
#include "render/solid_pass.h"

namespace poinsot::render {

/// Shader program for one pass over one kind of solid. It is compiled at its first use, because a scene shows only
/// a few kinds and compiling all programs would take a fifth of the start-up time.
class SolidProgram {
 public:
  SolidProgram(std::string vertex, std::string fragment, SolidPass pass, std::size_t ownConstants,
               std::string defines = "");

  /// Uses the program for a draw call whose inputs are bound.
  /// @throws core::Error(kGraphics) with the compiler's log.
  const gl::ShaderProgram& use(const PictureConstants& ofPicture, const Constants& own);

 private:
  std::string vertex_, fragment_, defines_;
  std::size_t ownConstants_;
  std::optional<gl::ShaderProgram> made_;
};

}  // namespace poinsot::render
