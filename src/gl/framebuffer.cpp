// SPDX-License-Identifier: Apache-2.0
#include "gl/framebuffer.h"

#include <fmt/format.h>

#include "core/error.h"

namespace poinsot::gl {
namespace {

struct ClientFormat {
  GLenum format, type;
};

// Returns the format and type arguments of glTexImage2D for an internal format. No data is passed, so these
// arguments only need to be compatible with the internal format.
ClientFormat clientFormat(GLenum internal) {
  switch (internal) {
    case GL_DEPTH_COMPONENT32F:
      return {GL_DEPTH_COMPONENT, GL_FLOAT};
    case GL_R32F:
      return {GL_RED, GL_FLOAT};
    default:
      return {GL_RGBA, GL_UNSIGNED_BYTE};
  }
}

void requireComplete(glm::ivec2 size) {
  // llvmpipe reports an oversized texture here, as GL_OUT_OF_MEMORY.
  const GLenum error = glGetError();
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (error == GL_NO_ERROR && status == GL_FRAMEBUFFER_COMPLETE) return;
  throw core::graphicsError(
      fmt::format("the back end cannot hold a picture of {} x {} pixels (error 0x{:x}, status 0x{:x})", size.x,
                  size.y, error, status));
}

}  // namespace

Framebuffer::Framebuffer(glm::ivec2 size, const std::vector<GLenum>& colorFormats, GLenum depthFormat)
    : size_(size), framebuffer_(FramebufferName::make()) {
  bind();
  std::vector<GLenum> drawn;
  for (const GLenum format : colorFormats) {
    drawn.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(drawn.size()));
    colors_.push_back(makeTexture(format, drawn.back()));
  }
  if (depthFormat) depth_ = makeTexture(depthFormat, GL_DEPTH_ATTACHMENT);
  glDrawBuffers(static_cast<GLsizei>(drawn.size()), drawn.data());
  requireComplete(size);
}

TextureName Framebuffer::makeTexture(GLenum format, GLenum attachment) const {
  auto texture = TextureName::make();
  const auto client = clientFormat(format);
  glBindTexture(GL_TEXTURE_RECTANGLE, texture.id());
  glTexImage2D(GL_TEXTURE_RECTANGLE, 0, static_cast<GLint>(format), size_.x, size_.y, 0, client.format,
               client.type, nullptr);
  glTexParameteri(GL_TEXTURE_RECTANGLE, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_RECTANGLE, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_RECTANGLE, texture.id(), 0);
  return texture;
}

}  // namespace poinsot::gl
