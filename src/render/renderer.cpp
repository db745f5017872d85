// SPDX-License-Identifier: Apache-2.0
#include "render/renderer.h"

#include <algorithm>
#include <deque>
#include <utility>
#include <vector>

#include "core/expect.h"
#include "core/step_times.h"
#include "gl/framebuffer.h"
#include "gl/unique_name.h"
#include "render/cached_panel.h"
#include "render/compositor.h"
#include "render/flat_painter.h"
#include "render/mesh_painter.h"
#include "render/solid_layers.h"
#include "render/solid_painter.h"
#include "render/text_painter.h"

namespace poinsot::render {
namespace {

/// OpenGL formats for 8-bit or 16-bit pictures: `light` for the light of solids, `picture` for the last pass.
struct Formats {
  GLenum light;
  GLenum picture;
};
// With only 8 bits of linear light, an 8-bit sRGB picture would show bands. Float would cost twice as much as 16
// bits. A 16-bit sRGB picture needs float: near black, 16-bit linear light has steps 13 times as wide.
constexpr Formats kFormats{GL_RGBA16, GL_RGBA8};
constexpr Formats kDeepFormats{GL_RGBA32F, GL_RGBA16};

template <typename Sample>
constexpr const Formats& formatsOf() {
  return sizeof(Sample) == 1 ? kFormats : kDeepFormats;
}

/// Cache of the most recently used framebuffers, one for each size and format. The panels of a picture have few
/// different sizes, which are the same in every frame.
class TargetShelf {
 public:
  const gl::Framebuffer& of(glm::ivec2 size, GLenum format) {
    const auto known = std::ranges::find_if(
        shelf_, [&](const Target& t) { return t.buffer.size() == size && t.format == format; });
    if (known != shelf_.end()) {
      std::rotate(shelf_.begin(), known, known + 1);
    } else {
      if (shelf_.size() == kSizes) shelf_.pop_back();  // frees memory before the new framebuffer is allocated
      shelf_.push_front({format, {size, {format}, 0}});
    }
    return shelf_.front().buffer;
  }

 private:
  struct Target {
    GLenum format;
    gl::Framebuffer buffer;
  };
  static constexpr std::size_t kSizes = 4;
  std::deque<Target> shelf_;  // framebuffers, most recently used first
};

template <typename Sample>
void place(const image::BasicImage<Sample>& panel, glm::ivec2 origin_px, image::BasicImage<Sample>& picture) {
  for (int y = 0; y < panel.size.height; ++y)
    std::copy_n(panel.at(0, y), panel.rowSamples(), picture.at(origin_px.x, origin_px.y + y));
}

}  // namespace

struct Renderer::Passes {
  TargetShelf targets;
  SolidLayers layers;
  SolidPainter solids;
  MeshPainter meshes;
  Compositor compositor;
  FlatPainter flat;
  TextPainter text;
  std::vector<CachedPanel> kept;  // panels of the picture in order
  CachedPanel joined;             // complete picture if it has several panels
  // Whether the last picture consisted of kept[0] alone. If so, `number` is the picture's number.
  bool alone = false;
  std::uint64_t number = 0;
  core::StepLedger* steps;

  explicit Passes(core::StepLedger* ledger) : steps(ledger) {
    glEnable(GL_PROGRAM_POINT_SIZE);  // for squares.vert
  }

  void beginPicture() {
    meshes.beginPicture();
    flat.beginPicture();
    text.beginPicture();
  }

  void drawSolids(const SolidCells& cells, const PictureConstants& ofPicture) {
    const auto drawPass = [&](SolidPass which, const PassInputs& inputs) {
      solids.draw(which, inputs, ofPicture);
      meshes.draw(which, inputs, ofPicture);
    };
    const gl::Framebuffer &full = layers[SolidLayer::kFull], &edge = layers[SolidLayer::kEdge];
    layers.begin(SolidLayer::kFull);
    drawPass(SolidPass::kFull, {});
    layers.begin(SolidLayer::kEdge);
    drawPass(SolidPass::kEdges, {});
    // Seams, where solids intersect, are stored like edges. Only the nearest edge can be a seam; a second seam
    // pass would cost more time than its small effect is worth.
    if (cells.anyShared()) drawPass(SolidPass::kSeams, {0, full.color(0), full.depth()});
    layers.begin(SolidLayer::kNextEdge);
    drawPass(SolidPass::kEdges, {edge.depth()});
  }

  /// Draws the solids into the layers. Returns the cells that contain solids.
  SolidCells draw(const draw::DrawList& list, const Formats& formats, const RenderOptions& options) {
    const core::StepScope timing(steps, core::Step::kDraw);
    SolidCells cells(list.camera.size_px);
    const auto meshEdges = meshes.prepare(list, options.sharpness, cells);
    solids.prepare(list, meshEdges, cells);
    if (!cells.any()) return cells;
    const glm::ivec2 size(list.camera.size_px);
    layers.fit(cells.part(), size, formats.light);
    const glm::ivec2 origin(layers.origin_px());
    glViewport(-origin.x, -origin.y, size.x, size.y);
    drawSolids(cells, pictureConstants(list, options.sharpness, layers.origin_px()));
    glFinish();  // counts the time of the passes in this step
    return cells;
  }

  /// Composes the picture in the target. Returns the mosaic. Only its drawn tiles are valid in the target.
  Mosaic resolve(const draw::DrawList& list, const SolidCells& cells, const gl::Framebuffer& target,
                 const RenderOptions& options, TileCache& tiles) {
    const core::StepScope timing(steps, core::Step::kResolve);
    const Sheets sheets(list);
    Mosaic mosaic = cutIntoMosaic(list.camera.size_px, sheets, cells, tiles);
    target.bind();
    glViewport(0, 0, target.size().x, target.size().y);
    compositor.draw(list, layers, sheets, mosaic, options.sharpness, options.transparent);
    glFinish();
    return mosaic;
  }

  /// Returns all numbers that determine the pixels without solids, except the constants of the sheets.
  static Constants commonTo(const draw::DrawList& list, const RenderOptions& options) {
    Constants common = pictureConstants(list, options.sharpness, glm::vec2(0)).shared;
    common.emplace_back(list.background, 0);
    return common;
  }

  template <typename Sample>
  void drawPanel(CachedPanel& panel, const draw::DrawList& list, const RenderOptions& options) {
    const glm::ivec2 size(list.camera.size_px);
    const Formats& formats = formatsOf<Sample>();
    const gl::Framebuffer& target = targets.of(size, formats.picture);
    TileCache& tiles = panel.begin<Sample>({size.x, size.y}, options.transparent, commonTo(list, options));
    const SolidCells cells = draw(list, formats, options);
    const Mosaic mosaic = resolve(list, cells, target, options, tiles);
    {
      const core::StepScope timing(steps, core::Step::kRead);
      panel.read<Sample>(mosaic, list.background);
    }
    const core::StepScope timing(steps, core::Step::kText);
    panel.forget(text.paint(list.texts, panel.picture<Sample>()));
  }

  template <typename Sample>
  CachedPanel& drawPanels(const draw::Picture& picture, const RenderOptions& options) {
    kept.resize(picture.panels.size());
    if (picture.panels.size() == 1 && sizeOf(picture.panels[0]) == picture.size_px) {
      drawPanel<Sample>(kept[0], picture.panels[0].list, options);
      return kept[0];
    }
    joined.begin<Sample>({picture.size_px.x, picture.size_px.y}, options.transparent, {});
    const glm::vec2 size_px(picture.size_px);
    joined.layPaper<Sample>({{0, 0, size_px.x, size_px.y}}, picture.background);
    for (std::size_t i = 0; i < kept.size(); ++i) {
      drawPanel<Sample>(kept[i], picture.panels[i].list, options);
      kept[i].end();
      place(kept[i].picture<Sample>(), picture.panels[i].origin_px, joined.picture<Sample>());
    }
    return joined;
  }

  const image::AnyImage& drawList(const draw::DrawList& list, const RenderOptions& options) {
    beginPicture();
    alone = false;
    kept.resize(1);
    drawPanel<std::uint8_t>(kept[0], list, options);
    kept[0].end();
    return kept[0].any();
  }

  template <typename Sample>
  image::Frame drawPicture(const draw::Picture& picture, const RenderOptions& options) {
    expectWithin(picture);
    beginPicture();
    const bool inRow = std::exchange(alone, false);  // if this picture fails, `alone` stays false
    number += inRow ? 1 : 2;
    CachedPanel& made = drawPanels<Sample>(picture, options);
    const core::StepScope timing(steps, core::Step::kText);
    made.forget(flat.paint(picture, made.picture<Sample>()));
    made.forget(text.paint(picture.texts, made.picture<Sample>()));
    made.end();
    alone = &made != &joined;
    return {made.any(), alone ? number : 0, made.changed()};
  }

  static glm::ivec2 sizeOf(const draw::Panel& p) { return glm::ivec2(p.list.camera.size_px); }

  static void expectWithin(const draw::Picture& picture) {
    for (const draw::Panel& p : picture.panels) {
      const glm::ivec2 end = p.origin_px + sizeOf(p);
      POINSOT_EXPECT(p.origin_px.x >= 0 && p.origin_px.y >= 0);
      POINSOT_EXPECT(end.x <= picture.size_px.x && end.y <= picture.size_px.y);
    }
  }
};

Renderer::Renderer(gl::OffscreenContext& context, core::StepLedger* steps) : context_(context) {
  POINSOT_EXPECT(context_.isCurrent());
  passes_ = std::make_unique<Passes>(steps);
}

Renderer::~Renderer() {
  const gl::AbandonedNames names(!context_.isCurrent());
  passes_.reset();
}

Renderer::Passes& Renderer::passes() {
  POINSOT_EXPECT(context_.isCurrent());
  return *passes_;
}

image::Image Renderer::render(const draw::DrawList& list, image::PixelSize size, const RenderOptions& options) {
  POINSOT_EXPECT(list.camera.size_px == glm::vec2(size.width, size.height));
  return std::get<image::Image>(passes().drawList(list, options));
}

image::Image Renderer::render(const draw::Picture& picture, const RenderOptions& options) {
  return std::get<image::Image>(passes().drawPicture<std::uint8_t>(picture, options).picture);
}

image::DeepImage Renderer::renderDeep(const draw::Picture& picture, const RenderOptions& options) {
  return std::get<image::DeepImage>(passes().drawPicture<std::uint16_t>(picture, options).picture);
}

image::Frame Renderer::frame(const draw::Picture& picture, int bits, const RenderOptions& options) {
  POINSOT_EXPECT(bits == 8 || bits == 16);
  return bits == 16 ? passes().drawPicture<std::uint16_t>(picture, options)
                    : passes().drawPicture<std::uint8_t>(picture, options);
}

}  // namespace poinsot::render
