// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "gl/framebuffer.h"
#include "render/screen_outline.h"

namespace poinsot::render {

/// Layers that the passes over the solids draw: the nearest full fragment, and the two nearest edges.
enum class SolidLayer : std::uint8_t { kFull, kEdge, kNextEdge };

/// Layers for one picture after another. They cover only the part of the picture that solids are in, because new
/// memory costs more time than drawing there. They only grow, so that few pictures need new ones. Their size
/// changes no pixel: nothing is in them beyond the part, and they include one pixel beyond the picture.
class SolidLayers {
 public:
  /// Makes room for a part of a picture of that size. Discards the contents of the layers.
  /// @param light  format of the linear light
  /// @throws core::Error(kGraphics) if the back end cannot hold the layers.
  void fit(const PixelBounds& part, glm::ivec2 picture_px, GLenum light);
  /// Binds a layer for drawing and empties it.
  void begin(SolidLayer layer) const;

  /// Returns the top left corner of the layers in the picture.
  glm::vec2 origin_px() const { return origin_px_; }
  /// @pre fit() was called.
  const gl::Framebuffer& operator[](SolidLayer layer) const { return layers_[static_cast<std::size_t>(layer)]; }

 private:
  void letGo();

  glm::vec2 origin_px_{0};
  GLenum light_ = 0;
  std::vector<gl::Framebuffer> layers_;
};

}  // namespace poinsot::render
