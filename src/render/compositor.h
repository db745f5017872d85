// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <tuple>

#include "draw/draw_list.h"
#include "gl/shader_program.h"
#include "render/mosaic.h"
#include "render/solid_layers.h"

namespace poinsot::render {

/// Combines solids and translucent sheets, pixel by pixel in order of depth (composite.frag). Each rectangle of
/// the mosaic has a shader compiled for its content, so that empty background costs nothing.
class Compositor {
 public:
  /// Draws the parts of the mosaic into the bound framebuffer.
  /// @pre `sheets` was created from `list`.
  void draw(const draw::DrawList& list, const SolidLayers& layers, const Sheets& sheets, const Mosaic& mosaic,
            float sharpness, bool transparent);

 private:
  /// Content that a program is compiled for: transparent background, solids, outlines of sheets, sheets. No
  /// feature is selected at run time, because llvmpipe executes both sides of an `if`.
  using Variant = std::tuple<bool, SolidReach, bool, SheetCounts>;
  const gl::ShaderProgram& program(const Variant& variant);

  std::map<Variant, gl::ShaderProgram> programs_;
  gl::VertexArrayName vertices_ = gl::VertexArrayName::make();
  gl::BufferName buffer_ = gl::BufferName::make();
};

}  // namespace poinsot::render
