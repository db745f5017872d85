// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "gl/framebuffer.h"
#include "render/screen_outline.h"

namespace poinsot::render {

/// What the passes over the solids leave, each in a layer: the nearest full fragment, and the two nearest edges.
enum class SolidLayer : std::uint8_t { kFull, kEdge, kNextEdge };

/// The layers of one picture after another. They are of the part of it that solids are in, as new memory costs
/// more time than what is drawn there, and only grow, so that few pictures need new ones. How large they are does
/// not tell: beyond the part nothing is in them, and a pixel beyond the picture is theirs, too.
class SolidLayers {
 public:
  /// Makes room for a part of a picture of that size. What was in the layers is lost.
  /// @param light  format of the linear light
  /// @throws core::Error(kGraphics) when the back end cannot hold them.
  void fit(const PixelBounds& part, glm::ivec2 picture_px, GLenum light);
  /// Binds a layer to be drawn into, with nothing in it.
  void begin(SolidLayer layer) const;

  /// Their place in the picture.
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
