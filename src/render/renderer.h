// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/step_times.h"
#include "draw/picture.h"
#include "gl/offscreen_context.h"
#include "image/frame.h"

namespace poinsot::render {

struct RenderOptions {
  bool transparent = false;  ///< RGBA with the background's alpha 0, else RGB
  float sharpness = 1;       ///< of edges: 1 for pictures; the reference renderer takes hard edges (reference.h)
};

/// Draws pictures. What stands still from one to the next is not drawn again, which shows in the time only: a
/// picture's bytes do not depend on those before. Owns every GL object; the context it is given must outlive it,
/// and be current whenever it draws.
class Renderer {
 public:
  /// @param steps  where the time is entered; must outlive it.
  /// @pre the context is current on this thread, here and for every picture.
  /// @throws core::Error(kGraphics) when a shader does not compile.
  explicit Renderer(gl::OffscreenContext& context, core::StepLedger* steps = nullptr);
  ~Renderer();

  /// One view that fills the picture.
  /// @pre the list was composed for this size.
  /// @throws core::Error(kGraphics) when the back end cannot hold the picture.
  image::Image render(const draw::DrawList& list, image::PixelSize size, const RenderOptions& options = {});

  /// Panels, and over them areas, strokes and type. What panels are drawn in is kept for four sizes.
  /// @pre panels lie within the picture, points of areas and strokes are finite.
  /// @throws core::Error(kGraphics) when the back end cannot hold a panel, (kUsage) for TeX that cannot be set.
  image::Image render(const draw::Picture& picture, const RenderOptions& options = {});
  /// The same with 16 bits a sample, of light that was kept as floats: 1.6 times the memory.
  image::DeepImage renderDeep(const draw::Picture& picture, const RenderOptions& options = {});

  /// The same as render() or renderDeep(), without a copy and with what became different: good until the next
  /// picture.
  /// @param bits  of a sample: 8 or 16
  image::Frame frame(const draw::Picture& picture, int bits, const RenderOptions& options = {});

 private:
  struct Passes;

  Passes& passes();

  gl::OffscreenContext& context_;
  std::unique_ptr<Passes> passes_;
};

}  // namespace poinsot::render
