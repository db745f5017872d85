// SPDX-License-Identifier: Apache-2.0
#include "render/solid_program.h"

#include <utility>

namespace poinsot::render {

SolidProgram::SolidProgram(std::string vertex, std::string fragment, SolidPass pass, std::size_t ownConstants,
                           std::string defines)
    : vertex_(std::move(vertex)),
      fragment_(std::move(fragment)),
      defines_("#define EDGES " + std::to_string(static_cast<int>(pass)) + "\n" + std::move(defines)),
      ownConstants_(ownConstants) {}

const gl::ShaderProgram& SolidProgram::use(const PictureConstants& ofPicture, const Constants& own) {
  if (!made_) made_.emplace(programWithConstants(vertex_, fragment_, ownConstants_, defines_));
  useWith(*made_, ofPicture, own);
  made_->set("edgeBefore", 1);
  made_->set("fullColor", 2);
  made_->set("fullDepth", 3);
  return *made_;
}

}  // namespace poinsot::render
