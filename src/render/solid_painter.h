// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <span>

#include "draw/draw_list.h"
#include "gl/shader_program.h"
#include "render/cells.h"
#include "render/curve_strip.h"
#include "render/solid_cells.h"
#include "render/solid_pass.h"

namespace poinsot::render {

/// Draws the opaque things of a draw list that need no mesh: ellipsoids, frustums and curves.
class SolidPainter {
 public:
  SolidPainter();

  /// Works out outlines and strips of this list, once for all passes, and marks the cells that they may
  /// touch. The solids that are not drawn here are marked already.
  /// @param meshEdges  drawn with the list's own curves; those of one mesh are alike but for their points
  void prepare(const draw::DrawList& list, const std::vector<std::vector<draw::Curve>>& meshEdges, float sharpness,
               SolidCells& solidCells);

  /// Draws what prepare() was given into the bound framebuffer: for kEdges the nearest edge behind the depths of
  /// inputs.edgeBefore, or the nearest of all when that is 0; for kSeams what of solids comes forward beside a
  /// seam.
  void draw(SolidPass pass, const PassInputs& inputs) const;

 private:
  enum Kind : std::size_t { kEllipsoid, kFrustum, kFlatCurve, kTube, kKinds };
  using Programs = std::vector<gl::ShaderProgram>;  // by Kind

  /// One draw call: its constants and its triangles, those of the edge passes first; those of the seams are apart.
  struct Item {
    Kind kind;
    Constants own;
    GLint first = 0;
    GLsizei edgeCount = 0, fullCount = 0;
    GLint seamFirst = 0;
    GLsizei seamCount = 0;
  };

  static Programs makePrograms(SolidPass pass);
  void prepareEllipsoid(const draw::Camera& camera, const draw::Ellipsoid& ellipsoid);
  void prepareFrustum(const draw::Camera& camera, const draw::Frustum& frustum);
  void prepareCurves(const draw::Camera& camera, std::span<const draw::Curve> alike);
  void addItem(Kind kind, const Cells& cells, Constants own);
  template <typename Outline>
  Cells cellsWithin(const Outline& outline) const;

  /// Copies an item's triangles that may touch another solid; each `group` vertices go together.
  template <typename Vertex>
  void copySeams(Item& item, std::vector<Vertex>& vertices, GLsizei group);

  std::array<Programs, 3> programs_;
  gl::VertexArrayName cellVertices_ = gl::VertexArrayName::make();
  gl::VertexArrayName curveVertices_ = gl::VertexArrayName::make();
  gl::BufferName cellBuffer_ = gl::BufferName::make();
  gl::BufferName curveBuffer_ = gl::BufferName::make();

  // Of the list last prepared.
  const draw::DrawList* list_ = nullptr;
  Constants ofPicture_;
  SolidCells* solidCells_ = nullptr;
  std::vector<Item> items_;
  std::vector<glm::vec2> cells_;
  std::vector<StripVertex> strips_;
};

}  // namespace poinsot::render
