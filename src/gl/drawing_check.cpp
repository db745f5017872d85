// SPDX-License-Identifier: Apache-2.0
#include "gl/drawing_check.h"

#include <array>
#include <cstdint>

#include "core/error.h"
#include "gl/framebuffer.h"
#include "gl/shader_program.h"
#include "gl/unique_name.h"

namespace poinsot::gl {
namespace {

using Rgba = std::array<std::uint8_t, 4>;

constexpr int kSide = 8;
constexpr Rgba kGround{255, 0, 51, 255}, kTriangle{0, 255, 102, 255}, kUnread{85, 85, 85, 85};

/// The vertices of a triangle over half the picture. All pixels with x + y < kSide - 1 are completely inside;
/// pixels with x + y >= kSide are outside.
constexpr const char* kVertexShader =
    "void main() {\n"
    "  gl_Position = vec4(gl_VertexID == 1 ? 1.0 : -1.0, gl_VertexID == 2 ? 1.0 : -1.0, 0.0, 1.0);\n"
    "}\n";
constexpr const char* kFragmentShader =
    "out vec4 color;\n"
    "void main() { color = vec4(0.0, 1.0, 0.4, 1.0); }\n";

void drawTriangle() {
  const ShaderProgram program("drawing_check", kVertexShader, kFragmentShader);
  const VertexArrayName none = VertexArrayName::make();
  glViewport(0, 0, kSide, kSide);
  glClearColor(1.0f, 0.0f, 0.2f, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  program.use();
  glBindVertexArray(none.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

Rgba pixelAt(int x, int y) {
  Rgba pixel = kUnread;
  glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
  return pixel;
}

}  // namespace

void expectDraws() {
  const Framebuffer target({kSide, kSide}, {GL_RGBA8}, 0);
  target.bind();
  drawTriangle();
  // One pixel lies inside and one outside, away from all edges, so a driver that draws only outlines fails.
  if (pixelAt(2, 2) == kTriangle && pixelAt(kSide - 2, kSide - 2) == kGround) return;
  throw core::graphicsError(
      "the back end reports success but does not draw: a test triangle has the wrong pixels; choose another "
      "--backend or reinstall Mesa; `poinsot doctor` tests the back ends");
}

}  // namespace poinsot::gl
