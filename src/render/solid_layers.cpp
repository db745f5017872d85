// SPDX-License-Identifier: Apache-2.0
#include "render/solid_layers.h"

#include <bit>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <utility>

#include "gl/shader_program.h"
#include "render/cells.h"

namespace poinsot::render {
namespace {

// Layers grow in steps of this size. With smaller steps, a rotating body would need new layers in many frames.
constexpr int kStep_px = 2 * kTile_px;

glm::ivec2 sizeFor(const PixelBounds& part, glm::ivec2 most) {
  const glm::vec2 size_px(part.right - part.left + 1, part.bottom - part.top + 1);
  return glm::min(kStep_px * glm::ivec2(glm::ceil(size_px / float{kStep_px})), most);
}

// Returns `side`, or side + 1 if `side` is a power of two. llvmpipe compiles different shaders for textures whose
// side is a power of two. Avoiding them saves a worker a second of recompilation.
int notAPowerOfTwo(int side) { return std::has_single_bit(static_cast<unsigned>(side)) ? side + 1 : side; }

}  // namespace

void SolidLayers::fit(const PixelBounds& part, glm::ivec2 picture_px, GLenum light) {
  origin_px_ = {part.left, part.top};
  // The composite pass reads the neighbours of each pixel. An extra, empty texel keeps the reads in the texture.
  const glm::ivec2 most = picture_px + 1;
  glm::ivec2 size = sizeFor(part, most);
  if (!layers_.empty() && light == light_) {
    const glm::ivec2 old = layers_.front().size();
    if (glm::all(glm::lessThanEqual(size, old))) return;
    size = glm::max(size, glm::min(old, most));
  }
  size = {notAPowerOfTwo(size.x), notAPowerOfTwo(size.y)};
  if (!layers_.empty()) letGo();  // frees memory before the new layers are allocated
  std::vector<gl::Framebuffer> made;
  for (int i = 0; i < 3; ++i) made.emplace_back(size, std::vector{light}, GL_DEPTH_COMPONENT32F);
  layers_ = std::move(made);
  light_ = light;
}

// Deletes the layers and makes Mesa free their memory. Mesa keeps a texture that a shader has read until another
// shader reads from the same texture unit. A small shader therefore reads from all six units here. It draws one
// pixel into its own framebuffer, as the bound one may be deleted.
void SolidLayers::letGo() {
  layers_.clear();
  const gl::Framebuffer pixel(glm::ivec2(1), {GL_RGBA8}, 0);
  const auto vertices = gl::VertexArrayName::make();
  const gl::ShaderProgram reader("reader of nothing",
                                 "void main() { gl_Position = vec4(0.0, 0.0, 0.0, 1.0); gl_PointSize = 1.0; }",
                                 R"(
uniform sampler2DRect a, b, c, d, e, f;
out vec4 pixel;
vec4 texel(sampler2DRect layer) { return texelFetch(layer, ivec2(0)); }
void main() { pixel = texel(a) + texel(b) + texel(c) + texel(d) + texel(e) + texel(f); })");
  reader.use();
  int unit = 0;
  for (const char* name : {"a", "b", "c", "d", "e", "f"}) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_RECTANGLE, 0);
    reader.set(name, unit++);
  }
  glBindVertexArray(vertices.id());
  glViewport(0, 0, 1, 1);
  glDrawArrays(GL_POINTS, 0, 1);
  glFinish();
}

void SolidLayers::begin(SolidLayer layer) const {
  (*this)[layer].bind();
  glClear(GL_DEPTH_BUFFER_BIT);  // colours need no clearing, because they are not read where the depth is 1
}

}  // namespace poinsot::render
