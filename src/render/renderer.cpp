// SPDX-License-Identifier: Apache-2.0
#include "render/renderer.h"

#include <ctime>
#include <optional>

#include "core/expect.h"
#include "gl/framebuffer.h"
#include "render/compositor.h"
#include "render/mesh_painter.h"
#include "render/solid_painter.h"
#include "render/text_painter.h"

namespace poinsot::render {
namespace {

double cpuSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Adds the CPU time of a scope to a total.
class Stopwatch {
 public:
  explicit Stopwatch(double& total) : total_(total), start_(cpuSeconds()) {}
  ~Stopwatch() { total_ += cpuSeconds() - start_; }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& total_;
  double start_;
};

/// The buffers of one picture size. Colours are 16-bit linear light: 8 bits would band, float costs twice.
struct Buffers {
  gl::Framebuffer full, edge, nextEdge, picture;
  explicit Buffers(glm::ivec2 size)
      : full(size, {GL_RGBA16}, GL_DEPTH_COMPONENT32F),
        edge(size, {GL_RGBA16}, GL_DEPTH_COMPONENT32F),
        nextEdge(size, {GL_RGBA16}, GL_DEPTH_COMPONENT32F),
        picture(size, {GL_RGBA8}, 0) {}
};

std::vector<std::uint8_t> readBack(glm::ivec2 size) {
  std::vector<std::uint8_t> rgba(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * 4);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  return rgba;
}

image::Image withoutAlpha(const std::vector<std::uint8_t>& rgba, image::PixelSize size) {
  image::Image picture(size, 3);
  std::uint8_t* to = picture.pixels.data();
  for (std::size_t from = 0; from < rgba.size(); from += 4, to += 3) {
    to[0] = rgba[from];
    to[1] = rgba[from + 1];
    to[2] = rgba[from + 2];
  }
  return picture;
}

}  // namespace

struct Renderer::Passes {
  std::optional<Buffers> buffers;
  SolidPainter solids;
  MeshPainter meshes;
  Compositor compositor;
  TextPainter text;
  RenderTimes times;

  void prepareBuffers(glm::ivec2 size) {
    if (buffers && buffers->picture.size() == size) return;
    buffers.reset();
    buffers.emplace(size);
  }

  void drawSolids(const TileMask& tiles) {
    const auto pass = [&](const gl::Framebuffer& target, SolidPass which, GLuint depth) {
      target.bind();
      glClearColor(0, 0, 0, 0);
      glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      if (!tiles.any()) return;
      solids.draw(which, depth);
      meshes.draw(which, depth);
    };
    pass(buffers->full, SolidPass::kFull, 0);
    pass(buffers->edge, SolidPass::kEdges, 0);
    pass(buffers->nextEdge, SolidPass::kEdges, buffers->edge.depth());
  }

  void clearPicture(const draw::DrawList& list, bool transparent) {
    buffers->picture.bind();
    const auto channel = [&](int c) {
      return static_cast<float>(draw::srgb8FromLinear(list.background[c])) / 255.0f;
    };
    glClearColor(channel(0), channel(1), channel(2), transparent ? 0.0f : 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
  }

  void draw(const draw::DrawList& list, glm::ivec2 size, const RenderOptions& options) {
    prepareBuffers(size);
    glViewport(0, 0, size.x, size.y);
    TileMask tiles(list.camera.size_px);
    const auto meshEdges = meshes.prepare(list, options.sharpness, tiles);
    solids.prepare(list, meshEdges, options.sharpness, tiles);
    drawSolids(tiles);
    clearPicture(list, options.transparent);
    compositor.draw(list, {buffers->full, buffers->edge, buffers->nextEdge}, tiles, options.sharpness,
                    options.transparent);
    glFinish();
  }
};

Renderer::Renderer(gl::OffscreenContext&) : passes_(std::make_unique<Passes>()) {}
Renderer::~Renderer() = default;

image::Image Renderer::render(const draw::DrawList& list, image::PixelSize size, const RenderOptions& options) {
  POINSOT_EXPECT(list.camera.size_px == glm::vec2(size.width, size.height));
  image::Image picture;
  {
    const Stopwatch watch(passes_->times.draw_s);
    passes_->draw(list, {size.width, size.height}, options);
  }
  {
    const Stopwatch watch(passes_->times.read_s);
    auto rgba = readBack({size.width, size.height});
    if (options.transparent) {
      picture.size = size;
      picture.channels = 4;
      picture.pixels = std::move(rgba);
    } else {
      picture = withoutAlpha(rgba, size);
    }
  }
  const Stopwatch watch(passes_->times.text_s);
  passes_->text.paint(list.texts, picture);
  return picture;
}

const RenderTimes& Renderer::times() const { return passes_->times; }

}  // namespace poinsot::render
