// SPDX-License-Identifier: Apache-2.0
#include "render/solid_painter.h"

#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "render/ellipsoid_rays.h"
#include "render/frustum_outline.h"
#include "render/shader_source.h"

namespace poinsot::render {
namespace {

void include(const Square& square, PixelBounds& bounds) { bounds.include(square.bounds()); }
void include(const StripVertex& vertex, PixelBounds& bounds) { bounds.include(vertex.position_px); }

}  // namespace

SolidPainter::Programs SolidPainter::makePrograms(SolidPass pass) {
  Programs programs;
  programs.emplace_back("squares.vert", "ellipsoid.frag", pass, 12);
  programs.emplace_back("squares.vert", "frustum.frag", pass, 11);
  programs.emplace_back("curve.vert", "curve.frag", pass, 2, "#define TUBE 0\n");
  programs.emplace_back("curve.vert", "curve.frag", pass, 2, "#define TUBE 1\n");
  return programs;
}

SolidPainter::SolidPainter()
    : programs_{makePrograms(SolidPass::kFull), makePrograms(SolidPass::kEdges), makePrograms(SolidPass::kSeams)} {
  glBindVertexArray(cellVertices_.id());
  glBindBuffer(GL_ARRAY_BUFFER, cellBuffer_.id());
  floatAttribute(0, 3, sizeof(Square), 0);
  glBindVertexArray(curveVertices_.id());
  glBindBuffer(GL_ARRAY_BUFFER, curveBuffer_.id());
  floatAttribute(0, 2, sizeof(StripVertex), offsetof(StripVertex, position_px));
  floatAttribute(1, 4, sizeof(StripVertex), offsetof(StripVertex, across));
  floatAttribute(2, 4, sizeof(StripVertex), offsetof(StripVertex, tangent_C));
}

void SolidPainter::prepare(const draw::DrawList& list, const std::vector<std::vector<draw::Curve>>& meshEdges,
                           SolidCells& solidCells) {
  list_ = &list;
  solidCells_ = &solidCells;
  items_.clear();
  cells_.clear();
  strips_.clear();
  for (const draw::Ellipsoid& e : list.ellipsoids) prepareEllipsoid(list.camera, e);
  for (const draw::Frustum& f : list.frustums) prepareFrustum(list.camera, f);
  for (const draw::Curve& c : list.curves) prepareCurves(list.camera, {&c, 1});
  for (const auto& lines : meshEdges) prepareCurves(list.camera, lines);
  for (Item& item : items_) {
    if (isCurve(item.kind))
      copyParts(item, strips_, 3);
    else
      copyParts(item, cells_, 1);
  }
  upload(GL_ARRAY_BUFFER, cellBuffer_, cells_, GL_STREAM_DRAW);
  upload(GL_ARRAY_BUFFER, curveBuffer_, strips_, GL_STREAM_DRAW);
}

template <typename Vertex, typename Wanted>
SolidPainter::Range SolidPainter::copied(const Range& range, std::vector<Vertex>& vertices, GLsizei group,
                                         Wanted wanted) {
  Range copy{static_cast<GLint>(vertices.size()), 0};
  for (GLint i = range.first; i < range.first + range.count; i += group) {
    PixelBounds bounds;
    for (GLint k = i; k < i + group; ++k) include(vertices[static_cast<std::size_t>(k)], bounds);
    if (!wanted(bounds)) continue;
    for (GLint k = i; k < i + group; ++k) vertices.push_back(vertices[static_cast<std::size_t>(k)]);
    copy.count += group;
  }
  return copy;
}

template <typename Vertex>
void SolidPainter::copyParts(Item& item, std::vector<Vertex>& vertices, GLsizei group) {
  const auto twoEdges = [&](const PixelBounds& b) { return solidCells_->twoEdges(b); };
  const auto shared = [&](const PixelBounds& b) { return solidCells_->shared(b); };
  item.nextEdges = copied(item.edges, vertices, group, twoEdges);
  if (item.kind != kFlatCurve && solidCells_->anyShared()) item.seams = copied(item.full, vertices, group, shared);
}

template <typename Outline>
Cells SolidPainter::cellsWithin(const Outline& outline) const {
  return cutIntoCells(outline.bounds.clipped(list_->camera.size_px),
                      [&](glm::vec2 p) { return outline.inside(p); });
}

void SolidPainter::addItem(Kind kind, const Cells& cells, const DepthRange& depths, Constants own) {
  for (const Square& square : cells.edge) solidCells_->markSolid(square.bounds(), depths);
  for (const Square& square : cells.full) solidCells_->markSolid(square.bounds(), depths);
  for (const Square& square : cells.edge) solidCells_->markEdge(square.bounds());
  const auto first = static_cast<GLint>(cells_.size());
  const auto edges = static_cast<GLsizei>(cells.edge.size()),
             all = edges + static_cast<GLsizei>(cells.full.size());
  items_.push_back({kind, std::move(own), {first, all}, {first, edges}, {}, {}});
  cells_.insert(cells_.end(), cells.edge.begin(), cells.edge.end());
  cells_.insert(cells_.end(), cells.full.begin(), cells.full.end());
}

void SolidPainter::prepareEllipsoid(const draw::Camera& camera, const draw::Ellipsoid& e) {
  const glm::vec3 centre_C = toCamera(camera, e.centre_V);
  const glm::mat3 semiAxes_C = glm::transpose(camera.R_VC) * e.semiAxes_V;
  if (!inFront(camera, centre_C, semiAxes_C)) return;
  const ScreenEllipse outline = ellipseOutline(camera, centre_C, semiAxes_C);
  const Cells cells = cellsWithin(outline);
  const float solid = solidCells_->nextSolid();
  Constants own;
  append(own, ellipsoidRays(camera, centre_C, semiAxes_C, outline.centre_px), outline);
  own.emplace_back(solid, e.material.gloss, 0, 0);
  own.emplace_back(e.material.color, 0);
  own.emplace_back(e.markingColor, e.marking_px);
  DepthRange depths;
  depths.include(-centre_C.z, glm::length(glm::vec3(semiAxes_C[0].z, semiAxes_C[1].z, semiAxes_C[2].z)));
  addItem(kEllipsoid, cells, depths, std::move(own));
}

void SolidPainter::prepareFrustum(const draw::Camera& camera, const draw::Frustum& f) {
  const FrustumOutline outline = frustumOutline(camera, f);
  if (outline.bounds.empty()) return;
  const Cells cells = cellsWithin(outline);
  const float solid = solidCells_->nextSolid();
  Constants own{{outline.from_C, solid},
                {outline.axis_C, outline.visibleCap},
                {f.fromRadius, f.toRadius, outline.height, (f.toRadius - f.fromRadius) / outline.height},
                {outline.first.centre_px, outline.second.centre_px},
                {outline.first.form, f.material.gloss},
                {outline.second.form, 0},
                {f.material.color, 0}};
  for (const glm::vec3& side : outline.sides) own.emplace_back(side, 0);
  DepthRange depths;
  depths.include(-outline.from_C.z, f.fromRadius);
  depths.include(-(outline.from_C + outline.height * outline.axis_C).z, f.toRadius);
  addItem(kFrustum, cells, depths, std::move(own));
}

void SolidPainter::prepareCurves(const draw::Camera& camera, std::span<const draw::Curve> alike) {
  if (alike.empty()) return;
  const draw::Curve& style = alike.front();
  const bool tube = style.radius_V > 0;
  const float solid = tube ? solidCells_->nextSolid() : SolidCells::noSolid();
  const std::size_t first = strips_.size();
  for (const draw::Curve& curve : alike) {
    const CurveStrip strip = makeCurveStrip(camera, curve);
    markStrip(strip.triangles, tube);
    strips_.insert(strips_.end(), strip.triangles.begin(), strip.triangles.end());
  }
  const Range all{static_cast<GLint>(first), static_cast<GLsizei>(strips_.size() - first)};
  items_.push_back({tube ? kTube : kFlatCurve,
                    {{style.material.color, style.material.gloss}, {solid, style.lift_V, 0, 0}},
                    all,
                    all,
                    {},
                    {}});
}

void SolidPainter::markStrip(const std::vector<StripVertex>& triangles, bool tube) {
  glm::vec2 begin(0), before(0);
  for (std::size_t i = 0; i + 5 < triangles.size(); i += 6) {
    const auto at = [&](std::size_t k) { return triangles[i + k].position_px; };
    // A strip that keeps roughly the same direction cannot return to a pixel. Its edges form one strand.
    const glm::vec2 along = (at(2) + at(5)) - (at(0) + at(1));
    if (i == 0 || glm::dot(along, begin) < 0 || glm::dot(along, before) < 0) {
      solidCells_->nextStrand();
      begin = along;
    }
    before = along;
    for (const std::size_t k : {std::size_t{0}, std::size_t{3}}) {
      const SolidCells::Triangle triangle{at(k), at(k + 1), at(k + 2)};
      solidCells_->markEdge(triangle);
      if (!tube) continue;
      DepthRange depths;
      for (std::size_t m = k; m < k + 3; ++m)
        depths.include(triangles[i + m].across.w, triangles[i + m].tangent_C.w);
      solidCells_->markSolid(triangle, depths);
    }
  }
}

void SolidPainter::draw(SolidPass pass, const PassInputs& inputs, const PictureConstants& ofPicture) {
  Programs& programs = programs_[static_cast<std::size_t>(pass)];
  bindInputs(inputs);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDisable(GL_BLEND);
  for (const Item& item : items_) {
    const Range range = rangeOf(item, pass, inputs);
    if (range.count == 0) continue;
    glBindVertexArray(isCurve(item.kind) ? curveVertices_.id() : cellVertices_.id());
    programs[item.kind].use(ofPicture, item.own);
    glDrawArrays(isCurve(item.kind) ? GL_TRIANGLES : GL_POINTS, range.first, range.count);
  }
  glDisable(GL_DEPTH_TEST);
}

SolidPainter::Range SolidPainter::rangeOf(const Item& item, SolidPass pass, const PassInputs& inputs) {
  switch (pass) {
    case SolidPass::kFull:
      return item.full;
    case SolidPass::kEdges:
      return inputs.edgeBefore == 0 ? item.edges : item.nextEdges;
    case SolidPass::kSeams:
      return item.seams;
  }
  return {};
}

}  // namespace poinsot::render
