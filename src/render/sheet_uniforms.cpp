// SPDX-License-Identifier: Apache-2.0
#include "render/sheet_uniforms.h"

#include <glm/geometric.hpp>
#include <string>

namespace poinsot::render {

void setEllipsoids(const gl::ShaderProgram& program, const draw::DrawList& list,
                   const std::vector<EllipsoidSheet>& sheets, const std::vector<std::size_t>& chosen) {
  std::vector<glm::vec3> centres;
  std::vector<glm::mat3> forms;
  std::vector<glm::vec4> colors, lines, options;
  for (std::size_t n = 0; n < chosen.size(); ++n) {
    const auto& sheet = sheets[chosen[n]];
    const auto& e = list.glassEllipsoids[chosen[n]];
    const draw::Graticule graticule = e.graticule.value_or(draw::Graticule{{}, 0, 0, 0});
    centres.push_back(sheet.centre_C);
    forms.push_back(sheet.toUnitSphere);
    colors.emplace_back(e.color, e.farOpacity);
    lines.emplace_back(graticule.color, graticule.opacity);
    options.emplace_back(e.rimOpacity, graticule.width_px, graticule.farOpacity, e.nearOpacity);
    const std::string index = "[" + std::to_string(n) + "]";
    program.set(("outlineCentre_px" + index).c_str(), sheet.outline.centre_px);
    program.set(("outlineForm" + index).c_str(), sheet.outline.form);
  }
  program.set("centre_C", centres);
  program.set("toUnitSphere", forms);
  program.set("glassColor", colors);
  program.set("graticuleColor", lines);
  program.set("glassOptions", options);
}

void setPlanes(const gl::ShaderProgram& program, const draw::DrawList& list, const std::vector<PlaneSheet>& sheets,
               const std::vector<std::size_t>& chosen) {
  std::vector<glm::vec3> centres, normals, us, vs, edges;
  std::vector<glm::vec4> colors, grids, options, shadows;
  for (const std::size_t i : chosen) {
    const auto& sheet = sheets[i];
    const auto& p = list.planes[i];
    centres.push_back(sheet.centre_C);
    normals.push_back(sheet.normal_C);
    us.push_back(sheet.u_C);
    vs.push_back(sheet.v_C);
    edges.insert(edges.end(), sheet.edges.begin(), sheet.edges.end());
    colors.emplace_back(p.color, p.opacity);
    grids.emplace_back(p.lineColor, p.lineOpacity);
    options.emplace_back(glm::length(p.u_W), glm::length(p.v_W), p.spacing_W, p.lineWidth_px);
    const glm::vec3 toShadow = p.shadowCentre_W - p.centre_W;
    shadows.emplace_back(glm::dot(toShadow, glm::normalize(p.u_W)), glm::dot(toShadow, glm::normalize(p.v_W)),
                         p.shadowRadius_W, p.shadowRadius_W > 0 ? p.shadowOpacity : 0.0f);
  }
  program.set("planeCentre_C", centres);
  program.set("planeNormal_C", normals);
  program.set("planeU_C", us);
  program.set("planeV_C", vs);
  program.set("planeEdges", edges);
  program.set("planeColor", colors);
  program.set("gridColor", grids);
  program.set("planeOptions", options);
  program.set("shadow", shadows);
}

void setCones(const gl::ShaderProgram& program, const draw::DrawList& list, const std::vector<ConeSheet>& sheets,
              const std::vector<std::size_t>& chosen) {
  std::vector<glm::vec3> apexes, axes, sides, forms;
  std::vector<glm::vec4> shapes, colors, lines, options;
  for (const std::size_t i : chosen) {
    const auto& outline = sheets[i].outline;
    const auto& c = list.glassCones[i];
    apexes.push_back(outline.from_C);
    axes.push_back(outline.axis_C);
    sides.insert(sides.end(), outline.sides.begin(), outline.sides.begin() + 3);
    forms.push_back(outline.second.form);
    shapes.emplace_back(outline.second.centre_px, outline.height, sheets[i].slope);
    colors.emplace_back(c.color, c.farOpacity);
    lines.emplace_back(c.lineColor, c.lineOpacity);
    options.emplace_back(c.rimOpacity, c.nearOpacity, c.lineWidth_px, outline.visibleCap == 2 ? 1 : 0);
  }
  program.set("coneApex_C", apexes);
  program.set("coneAxis_C", axes);
  program.set("coneSides", sides);
  program.set("baseForm", forms);
  program.set("coneShape", shapes);
  program.set("coneColor", colors);
  program.set("coneLine", lines);
  program.set("coneOptions", options);
}

void setPolygons(const gl::ShaderProgram& program, const draw::DrawList& list,
                 const std::vector<PolygonSheet>& sheets, const std::vector<std::size_t>& chosen,
                 std::size_t sides) {
  const glm::vec3 nowhere(0, 0, 1e6f);  // an edge that all of the picture is inside of
  std::vector<glm::vec3> points, normals, edges;
  std::vector<glm::vec2> corners;
  std::vector<glm::vec4> colors, lines, options;
  for (const std::size_t i : chosen) {
    const auto& sheet = sheets[i];
    const auto& p = list.glassPolygons[i];
    points.push_back(sheet.point_C);
    normals.push_back(sheet.normal_C);
    edges.insert(edges.end(), sheet.edges.begin(), sheet.edges.end());
    edges.insert(edges.end(), sides - sheet.edges.size(), nowhere);
    corners.insert(corners.end(), sheet.corners.begin(), sheet.corners.end());
    corners.insert(corners.end(), sides - sheet.corners.size(), sheet.corners.back());
    colors.emplace_back(p.color, p.opacity);
    lines.emplace_back(p.lineColor, p.lineOpacity);
    options.emplace_back(p.lineWidth_px, sheet.depths.x, sheet.depths.y, 0);
  }
  program.set("polygonPoint_C", points);
  program.set("polygonNormal_C", normals);
  program.set("polygonEdges", edges);
  program.set("polygonCorners_px", corners);
  program.set("polygonColor", colors);
  program.set("polygonLine", lines);
  program.set("polygonOptions", options);
}

}  // namespace poinsot::render
