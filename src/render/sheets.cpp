// SPDX-License-Identifier: Apache-2.0
#include "render/sheets.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/expect.h"
#include "render/sheet_uniforms.h"

namespace poinsot::render {
namespace {

// Half a pixel of ramp on either side of an edge, and rounding.
constexpr float kMargin_px = 1.5f;

bool touches(const PixelBounds& bounds, const PixelBounds& tile) {
  return bounds.left < tile.right && bounds.right > tile.left && bounds.top < tile.bottom &&
         bounds.bottom > tile.top;
}

// A tile wholly outside one edge of the plane's picture does not show the plane.
bool touches(const PlaneSheet& plane, const PixelBounds& tile) {
  if (!touches(plane.bounds, tile)) return false;
  for (const glm::vec3& e : plane.edges) {
    const float x = e.x > 0 ? tile.right : tile.left, y = e.y > 0 ? tile.bottom : tile.top;
    if (e.x * x + e.y * y + e.z < -kMargin_px) return false;
  }
  return true;
}

}  // namespace

EllipsoidSheet ellipsoidSheet(const draw::Camera& camera, const draw::GlassEllipsoid& e) {
  const glm::mat3 semiAxes_C = glm::transpose(camera.R_WC) * e.semiAxes_W;
  EllipsoidSheet sheet{toCamera(camera, e.centre_W), glm::mat3(glm::inverse(glm::dmat3(semiAxes_C))), {}};
  if (inFront(camera, sheet.centre_C, semiAxes_C))
    sheet.outline = ellipseOutline(camera, sheet.centre_C, semiAxes_C);
  return sheet;
}

PlaneSheet planeSheet(const draw::Camera& camera, const draw::GridPlane& p) {
  PlaneSheet sheet;
  sheet.centre_C = toCamera(camera, p.centre_W);
  const glm::vec3 u = p.u_W * camera.R_WC, v = p.v_W * camera.R_WC;
  sheet.u_C = glm::normalize(u);
  sheet.v_C = glm::normalize(v);
  sheet.normal_C = glm::normalize(glm::cross(u, v));
  const std::array<glm::vec3, 4> corners_C{sheet.centre_C - u - v, sheet.centre_C + u - v, sheet.centre_C + u + v,
                                           sheet.centre_C - u + v};
  std::array<glm::vec2, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) {
    if (-corners_C[i].z <= camera.near) return sheet;
    corners[i] = projectCamera(camera, corners_C[i]);
  }
  sheet.edges = quadEdges(corners);
  for (const glm::vec2& c : corners) sheet.bounds.include(c, kMargin_px);
  return sheet;
}

ConeSheet coneSheet(const draw::Camera& camera, const draw::GlassCone& cone) {
  POINSOT_EXPECT(cone.halfAngle_rad < 1.5707f);
  ConeSheet sheet;
  if (!(cone.halfAngle_rad > 0 && cone.height_W > 0)) return sheet;
  sheet.slope = std::tan(cone.halfAngle_rad);
  const glm::vec3 base_W = cone.apex_W + cone.height_W * glm::normalize(cone.axis_W);
  sheet.outline = frustumOutline(camera, {cone.apex_W, base_W, 0, sheet.slope * cone.height_W, {}});
  if (sheet.outline.bounds.empty()) return sheet;
  const PixelBounds base = sheet.outline.second.bounds;  // with half its line outside
  sheet.outline.bounds.include({base.left, base.top}, 0.5f * cone.lineWidth_px);
  sheet.outline.bounds.include({base.right, base.bottom}, 0.5f * cone.lineWidth_px);
  return sheet;
}

PolygonSheet polygonSheet(const draw::Camera& camera, const draw::GlassPolygon& polygon) {
  const std::size_t n = polygon.corners_W.size();
  POINSOT_EXPECT(n >= 3 && n <= Sheets::kMostCorners);
  PolygonSheet sheet;
  std::vector<glm::vec3> corners_C;
  for (const glm::vec3& p_W : polygon.corners_W) {
    corners_C.push_back(toCamera(camera, p_W));
    if (-corners_C.back().z <= camera.near) return sheet;
    sheet.corners.push_back(projectCamera(camera, corners_C.back()));
  }
  sheet.point_C = corners_C[0];
  sheet.depths = glm::vec2(-corners_C[0].z);
  glm::vec3 twiceArea(0);
  glm::vec2 middle(0);
  for (std::size_t i = 0; i < n; ++i) {
    twiceArea += glm::cross(corners_C[i] - corners_C[0], corners_C[(i + 1) % n] - corners_C[0]);
    middle += sheet.corners[i] / static_cast<float>(n);
    sheet.depths = {std::min(sheet.depths.x, -corners_C[i].z), std::max(sheet.depths.y, -corners_C[i].z)};
  }
  if (glm::length(twiceArea) <= 0) return sheet;
  sheet.normal_C = glm::normalize(twiceArea);
  for (std::size_t i = 0; i < n; ++i) {
    sheet.edges.push_back(lineThrough(sheet.corners[i], sheet.corners[(i + 1) % n], middle));
    sheet.bounds.include(sheet.corners[i], kMargin_px);
  }
  return sheet;
}

Sheets::Sheets(const draw::DrawList& list) : list_(list) {
  for (const auto& e : list.glassEllipsoids) ellipsoids_.push_back(ellipsoidSheet(list.camera, e));
  for (const auto& p : list.planes) planes_.push_back(planeSheet(list.camera, p));
  for (const auto& c : list.glassCones) cones_.push_back(coneSheet(list.camera, c));
  for (const auto& p : list.glassPolygons) polygons_.push_back(polygonSheet(list.camera, p));
}

SheetChoice Sheets::reaching(const PixelBounds& part) const {
  SheetChoice chosen;
  for (std::size_t i = 0; i < ellipsoids_.size(); ++i)
    if (touches(ellipsoids_[i].outline.bounds, part)) chosen.ellipsoids.push_back(i);
  // Cones that share an apex come together, and so do polygons that share an edge.
  const auto together = [&](const auto& sheets, const auto& boundsOf, std::vector<std::size_t>& numbers) {
    const auto here = [&](const auto& s) { return touches(boundsOf(s), part); };
    if (std::ranges::none_of(sheets, here)) return;
    for (std::size_t i = 0; i < sheets.size(); ++i)
      if (!boundsOf(sheets[i]).empty()) numbers.push_back(i);
  };
  together(
      cones_, [](const ConeSheet& s) { return s.outline.bounds; }, chosen.cones);
  together(
      polygons_, [](const PolygonSheet& s) { return s.bounds; }, chosen.polygons);
  // With an ellipsoid or a cone the planes come along: fewer shaders to compile for the few tiles it concerns.
  const bool glass = !chosen.ellipsoids.empty() || !chosen.cones.empty();
  for (std::size_t i = 0; i < planes_.size(); ++i)
    if (touches(planes_[i], part) || (glass && !planes_[i].bounds.empty())) chosen.planes.push_back(i);
  return chosen;
}

SheetCounts Sheets::counts(const SheetChoice& chosen) const {
  std::size_t sides = 0;
  for (const std::size_t i : chosen.polygons) sides = std::max(sides, polygons_[i].edges.size());
  return {chosen.ellipsoids.size(), chosen.planes.size(), chosen.cones.size(), chosen.polygons.size(), sides};
}

void Sheets::setUniforms(const gl::ShaderProgram& program, const SheetChoice& chosen) const {
  setEllipsoids(program, list_, ellipsoids_, chosen.ellipsoids);
  setPlanes(program, list_, planes_, chosen.planes);
  setCones(program, list_, cones_, chosen.cones);
  setPolygons(program, list_, polygons_, chosen.polygons, counts(chosen).polygonSides);
}

}  // namespace poinsot::render
