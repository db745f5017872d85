// SPDX-License-Identifier: Apache-2.0
#include "render/sheet_constants.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace poinsot::render {
namespace {

constexpr float kThinnest_px = 1e-3f;  // least width of a line, so that its reciprocal is finite

}  // namespace

void append(Constants& to, const draw::GlassEllipsoid& e, const EllipsoidSheet& sheet) {
  const draw::Graticule graticule = e.graticule.value_or(draw::Graticule{{}, 0, 0, 0});
  append(to, sheet.rays, sheet.outline, {e.rimOpacity, e.nearOpacity, e.farOpacity});
  to.emplace_back(e.color, 0);
  to.emplace_back(graticule.color, graticule.opacity);
  to.emplace_back(graticule.farOpacity, graticule.width_px, 1 / std::max(graticule.width_px, kThinnest_px), 0);
}

void append(Constants& to, const draw::GridPlane& p, const PlaneSheet& sheet, bool shadowed) {
  const glm::vec3 toShadow = p.shadowCentre_V - p.centre_V;
  glm::vec4 shadow(0);
  if (shadowed && p.shadowRadius_V > 0)
    shadow = {glm::dot(toShadow, glm::normalize(p.u_V)) / p.spacing_V,
              glm::dot(toShadow, glm::normalize(p.v_V)) / p.spacing_V, p.spacing_V / p.shadowRadius_V,
              p.shadowOpacity};
  to.emplace_back(sheet.u, sheet.middle_px.x);
  to.emplace_back(sheet.v, sheet.middle_px.y);
  to.emplace_back(sheet.depth, p.lineWidth_px);
  to.emplace_back(sheet.divisor, 1 / std::max(p.lineWidth_px, kThinnest_px));
  for (int i = 0; i < 4; ++i) to.emplace_back(sheet.edges[static_cast<std::size_t>(i)], shadow[i]);
  to.emplace_back(p.color, p.opacity);
  to.emplace_back(p.lineColor, p.lineOpacity);
}

void append(Constants& to, const draw::GlassCone& c, const ConeSheet& sheet) {
  const FrustumOutline& outline = sheet.outline;
  to.emplace_back(outline.from_C, outline.second.centre_px.x);
  to.emplace_back(outline.axis_C, outline.second.centre_px.y);
  to.emplace_back(outline.second.form, outline.height);
  to.emplace_back(outline.sides[0], sheet.slope);
  to.emplace_back(outline.sides[1], c.rimOpacity);
  to.emplace_back(outline.sides[2], c.nearOpacity);
  to.emplace_back(c.color, c.farOpacity);
  to.emplace_back(c.lineColor, c.lineOpacity);
  to.emplace_back(c.lineWidth_px, outline.visibleCap == 2 ? 1 : 0, 0, 0);
}

void append(Constants& to, const draw::GlassPolygon& p, const PolygonSheet& sheet, std::size_t sides) {
  to.emplace_back(sheet.point_C, p.lineWidth_px);
  to.emplace_back(sheet.normal_C, 0);
  to.emplace_back(p.color, p.opacity);
  to.emplace_back(p.lineColor, p.lineOpacity);
  to.emplace_back(sheet.depths, 0, 0);
  const glm::vec3 nowhere(0, 0, 1e6f);  // edge (nx, ny, c) that has the complete picture on its inside
  const std::size_t own = sheet.edges.size(), last = own - 1;
  const auto corner = [&](std::size_t i) { return sheet.corners[std::min(i, last)]; };
  for (std::size_t i = 0; i < sides; ++i) to.emplace_back(i < own ? sheet.edges[i] : nowhere, corner(i).x);
  for (std::size_t i = 0; i < sides; i += 4)
    to.emplace_back(corner(i).y, corner(i + 1).y, corner(i + 2).y, corner(i + 3).y);
}

}  // namespace poinsot::render
