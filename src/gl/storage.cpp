// SPDX-License-Identifier: Apache-2.0
#include "gl/storage.h"

#include <fmt/format.h>

#include "core/error.h"
#include "gl/gl_includes.h"

namespace poinsot::gl {

void expectStored(const char* what, std::size_t bytes) {
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return;
  const char* why = error == GL_OUT_OF_MEMORY ? "out of memory" : "allocation failed";
  throw core::graphicsError(
      fmt::format("the back end cannot hold {} of {} bytes: {} (error 0x{:x})", what, bytes, why, error));
}

}  // namespace poinsot::gl
