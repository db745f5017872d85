// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "gl/unique_name.h"

namespace poinsot::gl {

/// Framebuffer that owns its textures: one colour texture for each of `colorFormats` (sized internal formats), and
/// a depth texture unless `depthFormat` is 0. Shaders must read the textures with texelFetch.
class Framebuffer {
 public:
  /// @throws core::Error(kGraphics) if the size or a format is not available.
  Framebuffer(glm::ivec2 size, const std::vector<GLenum>& colorFormats, GLenum depthFormat);

  void bind() const { glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id()); }
  GLuint color(std::size_t i) const { return colors_[i].id(); }
  GLuint depth() const { return depth_.id(); }
  glm::ivec2 size() const { return size_; }

 private:
  TextureName makeTexture(GLenum format, GLenum attachment) const;

  glm::ivec2 size_;
  FramebufferName framebuffer_;
  std::vector<TextureName> colors_;
  TextureName depth_;
};

}  // namespace poinsot::gl
