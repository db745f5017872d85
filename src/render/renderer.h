// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/step_times.h"
#include "draw/picture.h"
#include "gl/offscreen_context.h"
#include "image/frame.h"

namespace poinsot::render {

struct RenderOptions {
  bool transparent = false;  ///< RGBA with a background of alpha 0; otherwise RGB
  float sharpness = 1;       ///< steepness of edges: 1 for pictures, more for hard edges (reference.h)
};

/// Draws pictures. Parts that do not change from one picture to the next are not drawn again. This only saves
/// time: the bytes of a picture do not depend on earlier pictures. The renderer owns all its GL objects. Its
/// context must outlive it and must be current whenever it draws.
class Renderer {
 public:
  /// @param steps  ledger in which times are entered; must outlive the renderer
  /// @pre the context is current on this thread, here and for every picture.
  /// @throws core::Error(kGraphics) if a shader does not compile.
  explicit Renderer(gl::OffscreenContext& context, core::StepLedger* steps = nullptr);
  ~Renderer();

  /// Draws one view that fills the picture.
  /// @pre the list was composed for this size.
  /// @throws core::Error(kGraphics) if the back end cannot hold the picture.
  image::Image render(const draw::DrawList& list, image::PixelSize size, const RenderOptions& options = {});

  /// Draws panels, then areas, strokes and type over them. Framebuffers of four panel sizes are cached.
  /// @pre panels lie within the picture, points of areas and strokes are finite.
  /// @throws core::Error(kGraphics) if the back end cannot hold a panel, (kUsage) if TeX cannot be set.
  image::Image render(const draw::Picture& picture, const RenderOptions& options = {});
  /// Draws a picture with 16 bits a sample, from light kept as floats. Takes 1.6 times the memory of render().
  image::DeepImage renderDeep(const draw::Picture& picture, const RenderOptions& options = {});

  /// Draws a picture like render() or renderDeep(), without a copy, and with the rectangles that changed. The
  /// frame is valid until the next picture.
  /// @param bits  bits of a sample: 8 or 16
  image::Frame frame(const draw::Picture& picture, int bits, const RenderOptions& options = {});

 private:
  struct Passes;

  Passes& passes();

  gl::OffscreenContext& context_;
  std::unique_ptr<Passes> passes_;
};

}  // namespace poinsot::render
