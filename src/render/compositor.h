// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <tuple>

#include "draw/draw_list.h"
#include "gl/shader_program.h"
#include "render/mosaic.h"
#include "render/solid_layers.h"

namespace poinsot::render {

/// Composes solids and translucent sheets, pixel by pixel in order of depth (composite.frag). A shader made for
/// the content of each rectangle (mosaic.h) draws it, so that empty paper costs nothing.
class Compositor {
 public:
  /// Draws the parts of the mosaic into the bound framebuffer. `sheets` must be made from `list`.
  void draw(const draw::DrawList& list, const SolidLayers& layers, const Sheets& sheets, const Mosaic& mosaic,
            float sharpness, bool transparent);

 private:
  /// Content that a program is compiled for: transparent, solids, outlines, sheets. All features are fixed when
  /// the program is compiled, because llvmpipe runs both sides of an `if`.
  using Variant = std::tuple<bool, SolidReach, bool, SheetCounts>;
  const gl::ShaderProgram& program(const Variant& variant);

  std::map<Variant, gl::ShaderProgram> programs_;
  gl::VertexArrayName vertices_ = gl::VertexArrayName::make();
  gl::BufferName buffer_ = gl::BufferName::make();
};

}  // namespace poinsot::render
