// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "gl/framebuffer.h"
#include "render/screen_outline.h"

namespace poinsot::render {

/// Results of the passes over the solids. kFull has the nearest fragment that fills its pixel; kEdge and kNextEdge
/// have the two nearest fragments that fill only part of it.
enum class SolidLayer : std::uint8_t { kFull, kEdge, kNextEdge };

/// Framebuffers for the passes over the solids, reused from picture to picture. They cover only the part of the
/// picture that contains solids, because new memory costs more time than drawing. They never shrink, so new ones
/// are seldom needed. Their size does not affect any pixel.
class SolidLayers {
 public:
  /// Makes room for a part of a picture, and discards the contents of the layers.
  /// @param picture_px  size of the complete picture
  /// @param light  OpenGL format of the linear light
  /// @throws core::Error(kGraphics) if the back end cannot hold the layers.
  void fit(const PixelBounds& part, glm::ivec2 picture_px, GLenum light);
  /// Binds a layer for drawing and clears it.
  void begin(SolidLayer layer) const;

  /// Returns the position of the layers' top left corner in the picture.
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
