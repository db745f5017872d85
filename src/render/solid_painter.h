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

  /// Prepares the outlines and strips of a list for all passes, and marks the cells that they may touch. All
  /// solids that are not drawn here must be marked already.
  /// @param meshEdges  drawn with the list's own curves; lines of one mesh differ only in their points
  void prepare(const draw::DrawList& list, const std::vector<std::vector<draw::Curve>>& meshEdges,
               SolidCells& solidCells);

  /// Draws the prepared list into the bound framebuffer. kEdges draws the nearest edge behind the depths of
  /// inputs.edgeBefore, or the nearest of all if that is 0. kSeams draws the parts of solids that come forward
  /// beside a seam.
  void draw(SolidPass pass, const PassInputs& inputs, const PictureConstants& ofPicture);

 private:
  enum Kind : std::size_t { kEllipsoid, kFrustum, kFlatCurve, kTube, kKinds };
  using Programs = std::vector<SolidProgram>;  // indexed by Kind

  struct Range {
    GLint first = 0;
    GLsizei count = 0;
  };

  /// One draw call with its constants. `full` holds all its squares or triangles, and `edges` those of the edge
  /// pass. `nextEdges` and `seams` are copies of those for the second edge pass and of those that may touch
  /// another solid.
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

  /// Appends copies of the groups in a range whose bounds are `wanted`. Each group has `group` vertices.
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

  // Data of the list that was prepared last.
  const draw::DrawList* list_ = nullptr;
  SolidCells* solidCells_ = nullptr;
  std::vector<Item> items_;
  std::vector<Square> cells_;
  std::vector<StripVertex> strips_;
};

}  // namespace poinsot::render
