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

/// Draws the opaque objects of a draw list that are not meshes: ellipsoids, frustums and curves.
class SolidPainter {
 public:
  SolidPainter();

  /// Prepares the objects of a list for all passes, and marks the cells that they may touch. Solids that other
  /// painters draw must be marked before this call.
  /// @param meshEdges  lines along the edges of each mesh, drawn like the list's own curves. Lines of one mesh may
  /// differ only in their points.
  void prepare(const draw::DrawList& list, const std::vector<std::vector<draw::Curve>>& meshEdges,
               SolidCells& solidCells);

  /// Draws the prepared objects into the bound framebuffer. The pass kEdges draws the nearest edge behind the
  /// depths in inputs.edgeBefore, or the nearest edge if edgeBefore is 0. The pass kSeams draws surfaces that come
  /// to the front within a pixel where two solids intersect.
  void draw(SolidPass pass, const PassInputs& inputs, const PictureConstants& ofPicture);

 private:
  enum Kind : std::size_t { kEllipsoid, kFrustum, kFlatCurve, kTube, kKinds };
  using Programs = std::vector<SolidProgram>;

  struct Range {
    GLint first = 0;
    GLsizei count = 0;
  };

  /// One draw call with its constants. The ranges select vertices: `full` selects all squares or triangles,
  /// `edges` those that may contain an edge. `nextEdges` and `seams` select copies of the vertices for the second
  /// edge pass and for the seam pass.
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

  /// Appends copies of those groups of vertices in a range whose bounds satisfy `wanted`.
  /// @param group  number of vertices per group
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

  // Data of the list that was last passed to prepare().
  const draw::DrawList* list_ = nullptr;
  SolidCells* solidCells_ = nullptr;
  std::vector<Item> items_;
  std::vector<Square> cells_;
  std::vector<StripVertex> strips_;
};

}  // namespace poinsot::render
