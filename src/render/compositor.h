// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <tuple>

#include "draw/draw_list.h"
#include "gl/shader_program.h"
#include "render/mosaic.h"
#include "render/solid_layers.h"

namespace poinsot::render {

/// Puts solids and translucent sheets together, pixel by pixel in order of depth (composite.frag). The picture is
/// cut into rectangles (mosaic.h); each is drawn by a shader made for what is there, so that empty paper costs
/// nothing.
class Compositor {
 public:
  /// Draws what the mosaic covers into the bound framebuffer. The sheets are those of the list.
  void draw(const draw::DrawList& list, const SolidLayers& layers, const Sheets& sheets, const Mosaic& mosaic,
            float sharpness, bool transparent);

 private:
  /// A program for one kind of content: its features are known when it is compiled, as llvmpipe runs both sides of
  /// an if.
  using Variant = std::tuple<bool, SolidReach, bool, SheetCounts>;  // transparent, solids, outlines, sheets
  const gl::ShaderProgram& program(const Variant& variant);

  std::map<Variant, gl::ShaderProgram> programs_;
  gl::VertexArrayName vertices_ = gl::VertexArrayName::make();
  gl::BufferName buffer_ = gl::BufferName::make();
};

}  // namespace poinsot::render
