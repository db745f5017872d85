// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include "draw/draw_list.h"
#include "render/cells.h"
#include "render/curve_strip.h"
#include "render/solid_cells.h"
#include "render/solid_pass.h"
#include "render/solid_program.h"

namespace poinsot::render {

/// Draws the opaque things of a draw list that need no mesh: ellipsoids, frustums and curves.
class SolidPainter {
 public:
  SolidPainter();

  /// Works out outlines and strips of this list, once for all passes, and marks the cells that they may
  /// touch. The solids that are not drawn here are marked already.
  /// @param meshEdges  drawn with the list's own curves; those of one mesh are alike but for their points
  void prepare(const draw::DrawList& list, const std::vector<std::vector<draw::Curve>>& meshEdges,
               SolidCells& solidCells);

  /// Draws what prepare() was given into the bound framebuffer: for kEdges the nearest edge behind the depths of
  /// inputs.edgeBefore, or the nearest of all when that is 0; for kSeams what of solids comes forward beside a
  /// seam.
  void draw(SolidPass pass, const PassInputs& inputs, const PictureConstants& ofPicture);

 private:
  enum Kind : std::size_t { kEllipsoid, kFrustum, kFlatCurve, kTube, kKinds };
  using Programs = std::vector<SolidProgram>;  // by Kind

  /// Of vertices.
  struct Range {
    GLint first = 0;
    GLsizei count = 0;
  };

  /// One draw call: its constants and its squares or triangles: all, and of them those of the edge pass; then
  /// copies of those that the next edge pass looks at, and of those that may touch another solid.
  struct Item {
    Kind kind;
    Constants own;
    Range full, edges, nextEdges, seams;
  };

  static Programs makePrograms(SolidPass pass);
  void prepareEllipsoid(const draw::Camera& camera, const draw::Ellipsoid& ellipsoid);
  void prepareFrustum(const draw::Camera& camera, const draw::Frustum& frustum);
  void prepareCurves(const draw::Camera& camera, std::span<const draw::Curve> alike);
  void addItem(Kind kind, const Cells& cells, const DepthRange& depths, Constants own);
  void markStrip(const std::vector<StripVertex>& triangles, bool tube);
  template <typename Outline>
  Cells cellsWithin(const Outline& outline) const;

  /// Copies those of a range that are wanted, as their bounds tell; each `group` vertices go together.
  template <typename Vertex, typename Wanted>
  static Range copied(const Range& range, std::vector<Vertex>& vertices, GLsizei group, Wanted wanted);
  template <typename Vertex>
  void copyParts(Item& item, std::vector<Vertex>& vertices, GLsizei group);
  static bool isCurve(Kind kind) { return kind == kFlatCurve || kind == kTube; }
  static Range rangeOf(const Item& item, SolidPass pass, const PassInputs& inputs);

  std::array<Programs, 3> programs_;
  gl::VertexArrayName cellVertices_ = gl::VertexArrayName::make();
  gl::VertexArrayName curveVertices_ = gl::VertexArrayName::make();
  gl::BufferName cellBuffer_ = gl::BufferName::make();
  gl::BufferName curveBuffer_ = gl::BufferName::make();

  // Of the list last prepared.
  const draw::DrawList* list_ = nullptr;
  SolidCells* solidCells_ = nullptr;
  std::vector<Item> items_;
  std::vector<Square> cells_;
  std::vector<StripVertex> strips_;
};

}  // namespace poinsot::render
