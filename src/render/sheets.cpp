// SPDX-License-Identifier: Apache-2.0
#include "render/sheets.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/expect.h"
#include "render/sheet_constants.h"

namespace poinsot::render {
namespace {

// Margin around a sheet for its soft edge, which extends half a pixel to either side, and for rounding.
constexpr float kSheetMargin_px = 1.5f;

bool touches(const PixelBounds& bounds, const PixelBounds& tile) {
  return bounds.left < tile.right && bounds.right > tile.left && bounds.top < tile.bottom &&
         bounds.bottom > tile.top;
}

enum class Relation { kApart, kCrossed, kFilled };

// Returns whether a part of the picture is outside an outline, crossed by it, or inside it. `least` and `most` are
// bounds, over the part, of a function that is positive inside the outline and negative outside.
Relation relation(float least, float most) {
  return most < 0 ? Relation::kApart : least > 0 ? Relation::kFilled : Relation::kCrossed;
}

glm::vec2 middleOf(const PixelBounds& b) { return {0.5f * (b.left + b.right), 0.5f * (b.top + b.bottom)}; }
float radiusOf(const PixelBounds& b) { return 0.5f * std::hypot(b.right - b.left, b.bottom - b.top); }

// rho of the outline (see ScreenEllipse) changes by at most 1 / (smaller semi-axis) per pixel.
Relation relation(const ScreenEllipse& outline, const PixelBounds& part) {
  if (!touches(outline.bounds, part)) return Relation::kApart;
  const glm::vec3 f = outline.form;
  const float steepest = std::sqrt(0.5f * (f.x + f.z) + std::hypot(0.5f * (f.x - f.z), f.y));
  const glm::vec2 q = middleOf(part) - outline.centre_px;
  const float rho = std::sqrt(f.x * q.x * q.x + 2 * f.y * q.x * q.y + f.z * q.y * q.y);
  const float reach = (radiusOf(part) + kSheetMargin_px) * steepest;
  return relation(1 - rho - reach, 1 - rho + reach);
}

// A plane's border line is treated as part of the plane's outline.
Relation relation(const PlaneSheet& plane, const PixelBounds& part) {
  if (!touches(plane.bounds, part)) return Relation::kApart;
  Relation whole = Relation::kFilled;
  for (const glm::vec3& e : plane.edges) {
    const float middle = glm::dot(glm::vec2(e), middleOf(part)) + e.z;
    const float reach =
        0.5f * (std::abs(e.x) * (part.right - part.left) + std::abs(e.y) * (part.bottom - part.top));
    const Relation one =
        relation(middle - reach - plane.border_px - kSheetMargin_px, middle + reach + kSheetMargin_px);
    if (one == Relation::kApart) return one;
    if (one == Relation::kCrossed) whole = one;
  }
  return whole;
}

/// Sets the numbers with which shaders compute where a ray meets the plane. The ray is x = from + t through. With
/// the plane's normal n and centre c:
///   t = n.(c - from) / n.through,  u = (t through - (c - from)).e_u
/// Numerators and divisor are linear functions of the pixel, so their values at three pixels determine them.
void setQuotients(const draw::Camera& camera, glm::vec3 centre_C, const std::array<glm::vec3, 2>& axes_C,
                  float spacing, PlaneSheet& sheet) {
  sheet.middle_px = projectCamera(camera, centre_C);
  const glm::dvec3 c(centre_C), e_u(axes_C[0]), e_v(axes_C[1]), n = glm::cross(e_u, e_v);
  const auto focal_px = static_cast<double>(camera.focal_px());
  const auto near = static_cast<double>(camera.near), far = static_cast<double>(camera.far);
  const auto at = [&](const glm::dvec2& p_px) {
    const glm::dvec2 q = (p_px - glm::dvec2(camera.centre_px)) / focal_px;
    const glm::dvec3 sideways(q.x, -q.y, 0), forward(0, 0, -1);
    const glm::dvec3 from = camera.orthographic ? sideways : glm::dvec3(0);
    const glm::dvec3 through = camera.orthographic ? forward : sideways + forward;
    const double divisor = glm::dot(n, through), t = glm::dot(n, c - from);
    const auto along = [&](const glm::dvec3& e) {
      return (t * glm::dot(through, e) - divisor * glm::dot(c - from, e)) / static_cast<double>(spacing);
    };
    return glm::dvec4(along(e_u), along(e_v), (t - near * divisor) / (far - near), divisor);
  };
  const glm::dvec2 middle(sheet.middle_px);
  const glm::dvec4 here = at(middle), right = at(middle + glm::dvec2(1, 0)) - here,
                   down = at(middle + glm::dvec2(0, 1)) - here;
  // Avoids a division by zero for a plane seen edge-on. No part of such a plane is drawn.
  const double scale = 1 / (std::abs(here.w) > 1e-9 ? here.w : 1e-9);
  const auto row = [&](int i) { return glm::vec3(scale * right[i], scale * down[i], scale * here[i]); };
  sheet.u = row(0);
  sheet.v = row(1);
  sheet.depth = row(2);
  sheet.divisor = row(3);
}

// Returns the bounds of the square around the shadow, or of the plane if the square is not completely in front of
// the camera.
PixelBounds shadowBounds(const draw::Camera& camera, const draw::GridPlane& p, const PixelBounds& plane) {
  if (p.shadowRadius_V <= 0 || p.shadowOpacity <= 0) return {};
  const float reach = draw::GridPlane::kShadowReach * p.shadowRadius_V;
  const glm::vec3 u = reach * glm::normalize(p.u_V), v = reach * glm::normalize(p.v_V);
  PixelBounds bounds;
  for (const glm::vec3& corner_V : {-u - v, u - v, u + v, v - u}) {
    const glm::vec3 corner_C = toCamera(camera, p.shadowCentre_V + corner_V);
    if (-corner_C.z <= camera.near) return plane;
    bounds.include(projectCamera(camera, corner_C), kSheetMargin_px);
  }
  return bounds;
}

}  // namespace

EllipsoidSheet ellipsoidSheet(const draw::Camera& camera, const draw::GlassEllipsoid& e) {
  const glm::mat3 semiAxes_C = glm::transpose(camera.R_VC) * e.semiAxes_V;
  const glm::vec3 centre_C = toCamera(camera, e.centre_V);
  EllipsoidSheet sheet;
  if (!inFront(camera, centre_C, semiAxes_C)) return sheet;
  sheet.outline = ellipseOutline(camera, centre_C, semiAxes_C);
  sheet.rays = ellipsoidRays(camera, centre_C, semiAxes_C, sheet.outline.centre_px);
  return sheet;
}

PlaneSheet planeSheet(const draw::Camera& camera, const draw::GridPlane& p) {
  PlaneSheet sheet;
  const glm::vec3 centre_C = toCamera(camera, p.centre_V), u = p.u_V * camera.R_VC, v = p.v_V * camera.R_VC;
  const std::array<glm::vec3, 4> corners_C{centre_C - u - v, centre_C + u - v, centre_C + u + v, centre_C - u + v};
  std::array<glm::vec2, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) {
    if (-corners_C[i].z <= camera.near) return sheet;
    corners[i] = projectCamera(camera, corners_C[i]);
  }
  sheet.edges = quadEdges(corners);
  for (const glm::vec2& c : corners) sheet.bounds.include(c, kSheetMargin_px);
  sheet.border_px = 1.5f * p.lineWidth_px;
  sheet.shadow = shadowBounds(camera, p, sheet.bounds);
  setQuotients(camera, centre_C, {glm::normalize(u), glm::normalize(v)}, p.spacing_V, sheet);
  return sheet;
}

ConeSheet coneSheet(const draw::Camera& camera, const draw::GlassCone& cone) {
  POINSOT_EXPECT(cone.halfAngle_rad < 1.5707f);
  ConeSheet sheet;
  if (!(cone.halfAngle_rad > 0 && cone.height_V > 0)) return sheet;
  sheet.slope = static_cast<float>(std::tan(static_cast<double>(cone.halfAngle_rad)));
  const glm::vec3 base_V = cone.apex_V + cone.height_V * glm::normalize(cone.axis_V);
  sheet.outline = frustumOutline(camera, {cone.apex_V, base_V, 0, sheet.slope * cone.height_V, {}});
  if (sheet.outline.bounds.empty()) return sheet;
  const PixelBounds base = sheet.outline.second.bounds;
  sheet.outline.bounds.include({base.left, base.top}, 0.5f * cone.lineWidth_px);
  sheet.outline.bounds.include({base.right, base.bottom}, 0.5f * cone.lineWidth_px);
  return sheet;
}

PolygonSheet polygonSheet(const draw::Camera& camera, const draw::GlassPolygon& polygon) {
  const std::size_t n = polygon.corners_V.size();
  POINSOT_EXPECT(n >= 3 && n <= Sheets::kMostCorners);
  PolygonSheet sheet;
  std::vector<glm::vec3> corners_C;
  for (const glm::vec3& p_V : polygon.corners_V) {
    corners_C.push_back(toCamera(camera, p_V));
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
    sheet.bounds.include(sheet.corners[i], kSheetMargin_px);
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
  const auto take = [&](Relation relation, std::vector<std::size_t>& numbers, std::size_t i) {
    if (relation != Relation::kApart) numbers.push_back(i);
    if (relation == Relation::kCrossed) chosen.outlines = true;
  };
  for (std::size_t i = 0; i < ellipsoids_.size(); ++i)
    take(relation(ellipsoids_[i].outline, part), chosen.ellipsoids, i);
  // Cones with the same apex are drawn together, and so are polygons with a common edge.
  const auto together = [&](const auto& sheets, const auto& boundsOf, std::vector<std::size_t>& numbers) {
    const auto here = [&](const auto& s) { return touches(boundsOf(s), part); };
    if (std::ranges::none_of(sheets, here)) return;
    chosen.outlines = true;
    for (std::size_t i = 0; i < sheets.size(); ++i)
      if (!boundsOf(sheets[i]).empty()) numbers.push_back(i);
  };
  together(
      cones_, [](const ConeSheet& s) { return s.outline.bounds; }, chosen.cones);
  together(
      polygons_, [](const PolygonSheet& s) { return s.bounds; }, chosen.polygons);
  for (std::size_t i = 0; i < planes_.size(); ++i) take(relation(planes_[i], part), chosen.planes, i);
  chosen.shadows =
      std::ranges::any_of(chosen.planes, [&](std::size_t i) { return touches(planes_[i].shadow, part); });
  return chosen;
}

void Sheets::addPlanesTo(SheetChoice& chosen) const {
  chosen.planes.clear();
  for (std::size_t i = 0; i < planes_.size(); ++i)
    if (!planes_[i].bounds.empty()) chosen.planes.push_back(i);
}

SheetCounts Sheets::counts(const SheetChoice& chosen) const {
  std::size_t sides = 0;
  for (const std::size_t i : chosen.polygons) sides = std::max(sides, polygons_[i].edges.size());
  return {chosen.ellipsoids.size(), chosen.planes.size(), chosen.cones.size(), chosen.polygons.size(), sides};
}

std::size_t SheetCounts::constants() const {
  return kEllipsoidConstants * ellipsoids + kPlaneConstants * planes + kConeConstants * cones +
         polygonConstants(polygonSides) * polygons;
}

Constants Sheets::constants(const SheetChoice& chosen) const {
  Constants all;
  for (const std::size_t i : chosen.ellipsoids) append(all, list_.glassEllipsoids[i], ellipsoids_[i]);
  for (const std::size_t i : chosen.planes) append(all, list_.planes[i], planes_[i], chosen.shadows);
  for (const std::size_t i : chosen.cones) append(all, list_.glassCones[i], cones_[i]);
  const std::size_t sides = counts(chosen).polygonSides;
  for (const std::size_t i : chosen.polygons) append(all, list_.glassPolygons[i], polygons_[i], sides);
  return all;
}

}  // namespace poinsot::render
