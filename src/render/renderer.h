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

struct RenderOptions {
  bool transparent = false;  ///< RGBA with the background's alpha 0, else RGB
  float sharpness = 1;       ///< of edges: 1 for pictures; the reference renderer takes hard edges (reference.h)
};

/// Draws draw lists. Owns every GL object; the context it is given must outlive it and stay current.
class Renderer {
 public:
  /// @throws core::Error(kGraphics) when a shader does not compile.
  explicit Renderer(gl::OffscreenContext& context);
  ~Renderer();

  /// @pre the list was composed for this size.
  /// @throws core::Error(kGraphics) when the back end cannot hold the picture.
  image::Image render(const draw::DrawList& list, image::PixelSize size, const RenderOptions& options = {});

  const RenderTimes& times() const;

 private:
  struct Passes;
  std::unique_ptr<Passes> passes_;
};

}  // namespace poinsot::render
