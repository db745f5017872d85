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

glm::vec2 positionOf(glm::vec2 vertex) { return vertex; }
glm::vec2 positionOf(const StripVertex& vertex) { return vertex.position_px; }

}  // namespace

SolidPainter::Programs SolidPainter::makePrograms(SolidPass pass) {
  Programs programs;  // in the order of Kind
  programs.push_back(solidProgram("tiles.vert", "ellipsoid.frag", pass, 12));
  programs.push_back(solidProgram("tiles.vert", "frustum.frag", pass, 11));
  programs.push_back(solidProgram("curve.vert", "curve.frag", pass, 2, "#define TUBE 0\n"));
  programs.push_back(solidProgram("curve.vert", "curve.frag", pass, 2, "#define TUBE 1\n"));
  return programs;
}

SolidPainter::SolidPainter()
    : programs_{makePrograms(SolidPass::kFull), makePrograms(SolidPass::kEdges), makePrograms(SolidPass::kSeams)} {
  glBindVertexArray(cellVertices_.id());
  glBindBuffer(GL_ARRAY_BUFFER, cellBuffer_.id());
  floatAttribute(0, 2, sizeof(glm::vec2), 0);
  glBindVertexArray(curveVertices_.id());
  glBindBuffer(GL_ARRAY_BUFFER, curveBuffer_.id());
  floatAttribute(0, 2, sizeof(StripVertex), offsetof(StripVertex, position_px));
  floatAttribute(1, 4, sizeof(StripVertex), offsetof(StripVertex, across));
  floatAttribute(2, 4, sizeof(StripVertex), offsetof(StripVertex, tangent_C));
}

void SolidPainter::prepare(const draw::DrawList& list, const std::vector<std::vector<draw::Curve>>& meshEdges,
                           float sharpness, SolidCells& solidCells) {
  list_ = &list;
  ofPicture_ = pictureConstants(list, sharpness);
  solidCells_ = &solidCells;
  items_.clear();
  cells_.clear();
  strips_.clear();
  for (const draw::Ellipsoid& e : list.ellipsoids) prepareEllipsoid(list.camera, e);
  for (const draw::Frustum& f : list.frustums) prepareFrustum(list.camera, f);
  for (const draw::Curve& c : list.curves) prepareCurves(list.camera, {&c, 1});
  for (const auto& lines : meshEdges) prepareCurves(list.camera, lines);
  for (Item& item : items_) {
    if (item.kind == kTube)
      copySeams(item, strips_, 3);
    else if (item.kind != kFlatCurve)
      copySeams(item, cells_, 6);
  }
  upload(GL_ARRAY_BUFFER, cellBuffer_, cells_, GL_STREAM_DRAW);
  upload(GL_ARRAY_BUFFER, curveBuffer_, strips_, GL_STREAM_DRAW);
}

template <typename Vertex>
void SolidPainter::copySeams(Item& item, std::vector<Vertex>& vertices, GLsizei group) {
  item.seamFirst = static_cast<GLint>(vertices.size());
  if (!solidCells_->anyShared()) return;
  for (GLint i = item.first; i < item.first + item.fullCount; i += group) {
    PixelBounds bounds;
    for (GLint k = i; k < i + group; ++k) bounds.include(positionOf(vertices[static_cast<std::size_t>(k)]));
    if (!solidCells_->shared(bounds)) continue;
    for (GLint k = i; k < i + group; ++k) vertices.push_back(vertices[static_cast<std::size_t>(k)]);
    item.seamCount += group;
  }
}

template <typename Outline>
Cells SolidPainter::cellsWithin(const Outline& outline) const {
  return cutIntoCells(outline.bounds.clipped(list_->camera.size_px),
                      [&](glm::vec2 p) { return outline.inside(p); });
}

void SolidPainter::addItem(Kind kind, const Cells& cells, Constants own) {
  const auto mark = [&](const std::vector<glm::vec2>& triangles, SolidReach reach) {
    for (std::size_t i = 0; i < triangles.size(); i += 6)
      solidCells_->mark({triangles[i].x, triangles[i].y, triangles[i + 4].x, triangles[i + 5].y}, reach);
  };
  mark(cells.edge, SolidReach::kEdges);
  mark(cells.full, SolidReach::kInside);
  items_.push_back({kind, std::move(own), static_cast<GLint>(cells_.size()),
                    static_cast<GLsizei>(cells.edge.size()),
                    static_cast<GLsizei>(cells.edge.size() + cells.full.size())});
  cells_.insert(cells_.end(), cells.edge.begin(), cells.edge.end());
  cells_.insert(cells_.end(), cells.full.begin(), cells.full.end());
}

void SolidPainter::prepareEllipsoid(const draw::Camera& camera, const draw::Ellipsoid& e) {
  const glm::vec3 centre_C = toCamera(camera, e.centre_W);
  const glm::mat3 semiAxes_C = glm::transpose(camera.R_WC) * e.semiAxes_W;
  if (!inFront(camera, centre_C, semiAxes_C)) return;
  const ScreenEllipse outline = ellipseOutline(camera, centre_C, semiAxes_C);
  const Cells cells = cellsWithin(outline);
  const float solid = solidCells_->nextSolid();
  Constants own;
  append(own, ellipsoidRays(camera, centre_C, semiAxes_C, outline.centre_px), outline);
  own.emplace_back(solid, e.material.gloss, 0, 0);
  own.emplace_back(e.material.color, 0);
  own.emplace_back(e.markingColor, e.marking_px);
  addItem(kEllipsoid, cells, std::move(own));
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
  addItem(kFrustum, cells, std::move(own));
}

void SolidPainter::prepareCurves(const draw::Camera& camera, std::span<const draw::Curve> alike) {
  if (alike.empty()) return;
  const std::size_t first = strips_.size();
  for (const draw::Curve& curve : alike) {
    const CurveStrip strip = makeCurveStrip(camera, curve);
    strips_.insert(strips_.end(), strip.triangles.begin(), strip.triangles.end());
  }
  const draw::Curve& style = alike.front();
  const bool tube = style.radius_W > 0;
  const float solid = tube ? solidCells_->nextSolid() : SolidCells::noSolid();
  for (std::size_t i = first; i + 2 < strips_.size(); i += 3) {
    const std::array triangle{strips_[i].position_px, strips_[i + 1].position_px, strips_[i + 2].position_px};
    if (tube)
      solidCells_->mark(triangle, SolidReach::kEdges);
    else
      solidCells_->markFlat(triangle);
  }
  const auto count = static_cast<GLsizei>(strips_.size() - first);
  items_.push_back({tube ? kTube : kFlatCurve,
                    {{style.material.color, style.material.gloss}, {solid, style.lift_W, 0, 0}},
                    static_cast<GLint>(first),
                    count,
                    count});
}

void SolidPainter::draw(SolidPass pass, const PassInputs& inputs) const {
  const Programs& programs = programs_[static_cast<std::size_t>(pass)];
  bindInputs(inputs);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDisable(GL_BLEND);
  for (const Item& item : items_) {
    const bool seams = pass == SolidPass::kSeams;
    const GLsizei count = seams ? item.seamCount : pass == SolidPass::kFull ? item.fullCount : item.edgeCount;
    if (count == 0) continue;
    const bool curve = item.kind == kFlatCurve || item.kind == kTube;
    glBindVertexArray(curve ? curveVertices_.id() : cellVertices_.id());
    useForSolid(programs[item.kind], ofPicture_, item.own);
    glDrawArrays(GL_TRIANGLES, seams ? item.seamFirst : item.first, count);
  }
  glDisable(GL_DEPTH_TEST);
}

}  // namespace poinsot::render
