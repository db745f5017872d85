// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/step_times.h"
#include "draw/picture.h"
#include "gl/offscreen_context.h"
#include "image/frame.h"

namespace poinsot::render {

struct RenderOptions {
  bool transparent = false;  ///< true for RGBA with a transparent background, false for RGB
  float sharpness = 1;  ///< steepness of edges: 1 for pictures; larger for the hard edges of renderReference()
};

/// Draws pictures with OpenGL. Parts that are the same as in the previous picture are not drawn again. This saves
/// time but changes nothing: the bytes of a picture do not depend on earlier pictures.
/// The renderer owns its OpenGL objects. The context must outlive it and must be current when it draws.
class Renderer {
 public:
  /// @param steps  records the time of each step; must outlive the renderer
  /// @pre the context is current on this thread, here and for every picture.
  /// @throws core::Error(kGraphics) if a shader does not compile.
  explicit Renderer(gl::OffscreenContext& context, core::StepLedger* steps = nullptr);
  ~Renderer();

  /// Draws one view, which fills the picture.
  /// @pre the list was composed for this size.
  /// @throws core::Error(kGraphics) if the back end cannot hold the picture.
  image::Image render(const draw::DrawList& list, image::PixelSize size, const RenderOptions& options = {});

  /// Draws the panels of a picture, then areas, strokes and text over the panels. Framebuffers are cached for up
  /// to four panel sizes.
  /// @pre panels lie within the picture, points of areas and strokes are finite.
  /// @throws core::Error(kGraphics) if the back end cannot hold a panel, (kUsage) if TeX cannot be set.
  image::Image render(const draw::Picture& picture, const RenderOptions& options = {});
  /// Draws a picture with 16 bits per sample, from light stored as floats. Uses 1.6 times the memory of render().
  image::DeepImage renderDeep(const draw::Picture& picture, const RenderOptions& options = {});

  /// Draws a picture like render() or renderDeep(), but without copying it. Also returns the rectangles that have
  /// changed since the previous picture. The frame is valid until the next picture is drawn.
  /// @param bits  bits per sample: 8 or 16
  image::Frame frame(const draw::Picture& picture, int bits, const RenderOptions& options = {});

 private:
  struct Passes;

  Passes& passes();

  gl::OffscreenContext& context_;
  std::unique_ptr<Passes> passes_;
};

}  // namespace poinsot::render
