// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "draw/draw_list.h"
#include "gl/offscreen_context.h"
#include "image/image.h"

namespace poinsot::render {

/// Seconds of CPU spent by the last render() calls, for --stats.
struct RenderTimes {
  double draw_s = 0;
  double read_s = 0;
  double text_s = 0;
};

/// Draws draw lists. Owns every GL object; the context it is given must outlive it and stay current.
class Renderer {
 public:
  /// @throws core::Error(kGraphics) when a shader does not compile.
  explicit Renderer(gl::OffscreenContext& context);
  ~Renderer();

  /// The picture, RGB; with `transparent` RGBA, the background's alpha 0.
  /// @throws core::Error(kGraphics) when the back end cannot hold the picture.
  image::Image render(const draw::DrawList& list, image::PixelSize size, bool transparent = false);

  const RenderTimes& times() const;

 private:
  struct Passes;
  std::unique_ptr<Passes> passes_;
};

}  // namespace poinsot::render
