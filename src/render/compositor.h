// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <tuple>
#include <utility>

#include "draw/draw_list.h"
#include "gl/framebuffer.h"
#include "gl/shader_program.h"
#include "render/sheets.h"
#include "render/tile_mask.h"

namespace poinsot::render {

/// What the solid passes left: the nearest full fragment, and the two nearest edges.
struct SolidLayers {
  const gl::Framebuffer& full;
  const gl::Framebuffer& edge;
  const gl::Framebuffer& nextEdge;
};

/// Puts solids and translucent sheets together, pixel by pixel in order of depth (composite.frag). The picture is
/// cut into tiles; each is drawn by a shader made for the sheets that reach it, so that empty paper costs nothing.
class Compositor {
 public:
  /// Draws into the bound framebuffer, which holds the background already.
  void draw(const draw::DrawList& list, const SolidLayers& solids, const TileMask& solidTiles, float sharpness,
            bool transparent);

 private:
  using Content = std::pair<bool, SheetChoice>;  // of a tile: whether solids reach it, and which sheets

  /// A program for one kind of tile: its features are known when it is compiled, as llvmpipe runs both sides of an
  /// if.
  using Variant = std::tuple<bool, bool, SheetCounts>;  // transparent, solids, sheets
  const gl::ShaderProgram& program(const Variant& variant);

  std::map<Variant, gl::ShaderProgram> programs_;
  gl::VertexArrayName vertices_ = gl::VertexArrayName::make();
  gl::BufferName buffer_ = gl::BufferName::make();
};

}  // namespace poinsot::render
