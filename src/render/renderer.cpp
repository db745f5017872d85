// SPDX-License-Identifier: Apache-2.0
#include "render/renderer.h"

#include <algorithm>
#include <deque>

#include "core/expect.h"
#include "core/step_times.h"
#include "gl/framebuffer.h"
#include "render/compositor.h"
#include "render/eraser.h"
#include "render/flat_painter.h"
#include "render/mesh_painter.h"
#include "render/solid_painter.h"
#include "render/text_painter.h"

namespace poinsot::render {
namespace {

/// What OpenGL is told of pictures of a kind of sample.
struct Formats {
  GLenum light;    ///< of the linear light of solids
  GLenum picture;  ///< of the last pass
  GLenum sample;   ///< of what is read back
};
// For 8 bits of sRGB, 8 bits of linear light would band, and float costs twice what 16 do. For 16 bits of sRGB, 16
// of linear light would band: near black its steps are 13 times as wide.
constexpr Formats kFormats{GL_RGBA16, GL_RGBA8, GL_UNSIGNED_BYTE};
constexpr Formats kDeepFormats{GL_RGBA32F, GL_RGBA16, GL_UNSIGNED_SHORT};

template <typename Sample>
constexpr const Formats& formatsOf() {
  return sizeof(Sample) == 1 ? kFormats : kDeepFormats;
}

/// The buffers of one picture size.
struct Buffers {
  const Formats* formats;
  gl::Framebuffer full, edge, nextEdge, picture;
  Buffers(glm::ivec2 size, const Formats& f)
      : formats(&f),
        full(size, {f.light}, GL_DEPTH_COMPONENT32F),
        edge(size, {f.light}, GL_DEPTH_COMPONENT32F),
        nextEdge(size, {f.light}, GL_DEPTH_COMPONENT32F),
        picture(size, {f.picture}, 0) {}
};

/// The buffers of the sizes used of late: a picture's panels have few sizes, and the same ones in every frame.
class BufferShelf {
 public:
  const Buffers& of(glm::ivec2 size, const Formats& formats) {
    const auto known = std::ranges::find_if(
        shelf_, [&](const Buffers& b) { return b.picture.size() == size && b.formats == &formats; });
    if (known != shelf_.end()) {
      std::rotate(shelf_.begin(), known, known + 1);
    } else {
      if (shelf_.size() == kSizes) shelf_.pop_back();  // before a new one needs its memory
      shelf_.emplace_front(size, formats);
    }
    return shelf_.front();
  }

 private:
  static constexpr std::size_t kSizes = 4;
  std::deque<Buffers> shelf_;  // the last used first
};

template <typename Sample>
void dropAlpha(const Sample* rgba, std::size_t pixels, Sample* rgb) {
  for (std::size_t i = 0; i < pixels; ++i, rgba += 4, rgb += 3) {
    rgb[0] = rgba[0];
    rgb[1] = rgba[1];
    rgb[2] = rgba[2];
  }
}

/// One row of a picture with nothing on it.
template <typename Sample>
std::vector<Sample> paperRow(int width, const draw::Color& background, bool transparent) {
  const std::size_t channels = transparent ? 4 : 3;
  std::vector<Sample> row(channels * static_cast<std::size_t>(width));
  for (std::size_t c = 0; c < 3; ++c) {
    const auto value = draw::srgbFromLinear<Sample>(background[static_cast<int>(c)]);
    for (std::size_t i = c; i < row.size(); i += channels) row[i] = value;  // alpha stays 0
  }
  return row;
}

/// What the mosaic covers, and paper beside it. The back end gives RGBA, and 4K of it are 32 MiB: a row of tiles
/// at a time.
template <typename Sample>
image::BasicImage<Sample> readBack(image::PixelSize size, const Mosaic& mosaic, const draw::Color& background,
                                   bool transparent) {
  image::BasicImage<Sample> picture(size, transparent ? 4 : 3);
  const auto channels = static_cast<std::size_t>(picture.channels);
  const auto paper = paperRow<Sample>(size.width, background, transparent);
  std::vector<Sample> band(static_cast<std::size_t>(4 * size.width * Mosaic::kTile_px));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  for (int first = 0; first < size.height; first += Mosaic::kTile_px) {
    const auto [from, to] = mosaic.columns[static_cast<std::size_t>(first / Mosaic::kTile_px)];
    const int rows = std::min(size.height - first, Mosaic::kTile_px);
    if (to > from) glReadPixels(from, first, to - from, rows, GL_RGBA, formatsOf<Sample>().sample, band.data());
    const auto width = static_cast<std::size_t>(to - from);
    for (int y = 0; y < rows; ++y) {
      std::ranges::copy(paper, picture.at(0, first + y));
      const Sample* rgba = band.data() + 4 * width * static_cast<std::size_t>(y);
      if (channels == 4)
        std::copy_n(rgba, 4 * width, picture.at(from, first + y));
      else
        dropAlpha(rgba, width, picture.at(from, first + y));
    }
  }
  return picture;
}

template <typename Sample>
image::BasicImage<Sample> blankPicture(image::PixelSize size, const draw::Color& background, bool transparent) {
  image::BasicImage<Sample> picture(size, transparent ? 4 : 3);
  const auto paper = paperRow<Sample>(size.width, background, transparent);
  for (int y = 0; y < size.height; ++y) std::ranges::copy(paper, picture.at(0, y));
  return picture;
}

template <typename Sample>
void place(const image::BasicImage<Sample>& panel, glm::ivec2 origin_px, image::BasicImage<Sample>& picture) {
  for (int y = 0; y < panel.size.height; ++y)
    std::copy_n(panel.at(0, y), panel.rowSamples(), picture.at(origin_px.x, origin_px.y + y));
}

}  // namespace

struct Renderer::Passes {
  BufferShelf shelf;
  const Buffers* buffers = nullptr;  // of the panel in progress
  SolidPainter solids;
  MeshPainter meshes;
  Eraser eraser;
  Compositor compositor;
  FlatPainter flat;
  TextPainter text;
  core::StepLedger* steps;

  explicit Passes(core::StepLedger* ledger) : steps(ledger) {}

  void beginPicture() {
    meshes.beginPicture();
    flat.beginPicture();
    text.beginPicture();
  }

  void drawSolids(const SolidCells& cells) {
    if (!cells.any()) return;
    const auto begin = [&](const gl::Framebuffer& target, std::size_t layer) {
      target.bind();
      eraser.erase(layer);
    };
    begin(buffers->full, 0);
    drawPass(SolidPass::kFull, {});
    begin(buffers->edge, 1);
    drawPass(SolidPass::kEdges, {});
    // A seam is like an edge. One behind an edge is left out: a second pass would cost more than it shows.
    if (cells.anyShared()) drawPass(SolidPass::kSeams, {0, buffers->full.color(0), buffers->full.depth()});
    begin(buffers->nextEdge, 2);
    drawPass(SolidPass::kEdges, {buffers->edge.depth()});
  }

  void drawPass(SolidPass which, const PassInputs& inputs) {
    solids.draw(which, inputs);
    meshes.draw(which, inputs);
  }

  /// Outlines, and what fills each pixel. Returns the cells that solids lie in.
  SolidCells draw(const draw::DrawList& list, const RenderOptions& options) {
    const core::StepScope timing(steps, core::Step::kDraw);
    SolidCells cells(list.camera.size_px);
    const auto meshEdges = meshes.prepare(list, options.sharpness, cells);
    solids.prepare(list, meshEdges, options.sharpness, cells);
    eraser.prepare(cells, pictureConstants(list, options.sharpness));
    drawSolids(cells);
    glFinish();  // so that the passes count here
    return cells;
  }

  /// Leaves the picture in its buffer where the mosaic that it returns covers it.
  Mosaic resolve(const draw::DrawList& list, const SolidCells& cells, const RenderOptions& options) {
    const core::StepScope timing(steps, core::Step::kResolve);
    const Sheets sheets(list);
    Mosaic mosaic = cutIntoMosaic(list.camera.size_px, sheets, cells);
    buffers->picture.bind();
    compositor.draw(list, {buffers->full, buffers->edge, buffers->nextEdge}, sheets, mosaic, options.sharpness,
                    options.transparent);
    glFinish();
    return mosaic;
  }

  /// One view with its type, as large as its camera says.
  template <typename Sample>
  image::BasicImage<Sample> panel(const draw::DrawList& list, const RenderOptions& options) {
    const glm::ivec2 size(list.camera.size_px);
    buffers = &shelf.of(size, formatsOf<Sample>());
    glViewport(0, 0, size.x, size.y);
    const SolidCells cells = draw(list, options);
    const Mosaic mosaic = resolve(list, cells, options);
    auto picture = read<Sample>({size.x, size.y}, mosaic, list.background, options);
    const core::StepScope timing(steps, core::Step::kText);
    text.paint(list.texts, picture);
    return picture;
  }

  template <typename Sample>
  image::BasicImage<Sample> read(image::PixelSize size, const Mosaic& mosaic, const draw::Color& background,
                                 const RenderOptions& options) {
    const core::StepScope timing(steps, core::Step::kRead);
    return readBack<Sample>(size, mosaic, background, options.transparent);
  }

  template <typename Sample>
  image::BasicImage<Sample> panels(const draw::Picture& picture, const RenderOptions& options) {
    const image::PixelSize size{picture.size_px.x, picture.size_px.y};
    if (picture.panels.size() == 1 && sizeOf(picture.panels[0]) == picture.size_px)
      return panel<Sample>(picture.panels[0].list, options);
    auto whole = blankPicture<Sample>(size, picture.background, options.transparent);
    for (const draw::Panel& p : picture.panels) place(panel<Sample>(p.list, options), p.origin_px, whole);
    return whole;
  }

  /// The panels, and what lies over them.
  template <typename Sample>
  image::BasicImage<Sample> whole(const draw::Picture& picture, const RenderOptions& options) {
    expectWithin(picture);
    beginPicture();
    auto made = panels<Sample>(picture, options);
    const core::StepScope timing(steps, core::Step::kText);
    flat.paint(picture, made);
    text.paint(picture.texts, made);
    return made;
  }

  static glm::ivec2 sizeOf(const draw::Panel& p) { return glm::ivec2(p.list.camera.size_px); }

  /// Panels lie within the picture.
  static void expectWithin(const draw::Picture& picture) {
    for (const draw::Panel& p : picture.panels) {
      const glm::ivec2 end = p.origin_px + sizeOf(p);
      POINSOT_EXPECT(p.origin_px.x >= 0 && p.origin_px.y >= 0);
      POINSOT_EXPECT(end.x <= picture.size_px.x && end.y <= picture.size_px.y);
    }
  }
};

Renderer::Renderer(gl::OffscreenContext&, core::StepLedger* steps) : passes_(std::make_unique<Passes>(steps)) {}
Renderer::~Renderer() = default;

image::Image Renderer::render(const draw::DrawList& list, image::PixelSize size, const RenderOptions& options) {
  POINSOT_EXPECT(list.camera.size_px == glm::vec2(size.width, size.height));
  passes_->beginPicture();
  return passes_->panel<std::uint8_t>(list, options);
}

image::Image Renderer::render(const draw::Picture& picture, const RenderOptions& options) {
  return passes_->whole<std::uint8_t>(picture, options);
}

image::DeepImage Renderer::renderDeep(const draw::Picture& picture, const RenderOptions& options) {
  return passes_->whole<std::uint16_t>(picture, options);
}

}  // namespace poinsot::render
