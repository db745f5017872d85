// SPDX-License-Identifier: Apache-2.0
#include "render/compositor.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "render/cells.h"
#include "render/shader_source.h"
#include "render/solid_pass.h"

namespace poinsot::render {
namespace {

struct GlassSheet {
  glm::vec3 centre_C;
  glm::mat3 toUnitSphere;
  ScreenEllipse outline;
};

struct PlaneSheet {
  glm::vec3 centre_C, u_C, v_C, normal_C;
  std::array<glm::vec3, 4> edges;
  PixelBounds bounds;
  bool visible = false;
};

GlassSheet glassSheet(const draw::Camera& camera, const draw::GlassEllipsoid& e) {
  const glm::mat3 semiAxes_C = glm::transpose(camera.R_WC) * e.semiAxes_W;
  GlassSheet sheet{toCamera(camera, e.centre_W), glm::mat3(glm::inverse(glm::dmat3(semiAxes_C))), {}};
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
    sheet.bounds.include(corners[i], 1.5f);
  }
  sheet.edges = quadEdges(corners);
  sheet.visible = true;
  return sheet;
}

bool touches(const PixelBounds& bounds, const PixelBounds& tile) {
  return bounds.left < tile.right && bounds.right > tile.left && bounds.top < tile.bottom &&
         bounds.bottom > tile.top;
}

// A tile wholly outside one edge of the plane's picture does not show the plane.
bool touches(const PlaneSheet& plane, const PixelBounds& tile) {
  if (!plane.visible || !touches(plane.bounds, tile)) return false;
  for (const glm::vec3& e : plane.edges) {
    const float x = e.x > 0 ? tile.right : tile.left, y = e.y > 0 ? tile.bottom : tile.top;
    if (e.x * x + e.y * y + e.z < -1.5f) return false;
  }
  return true;
}

void setGlass(const gl::ShaderProgram& program, const draw::DrawList& list, const std::vector<GlassSheet>& sheets,
              const std::vector<std::size_t>& chosen) {
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

void bindLayers(const gl::ShaderProgram& program, const SolidLayers& solids) {
  const std::array<std::pair<const char*, GLuint>, 6> textures{{{"solidColor", solids.full.color(0)},
                                                                {"solidDepth", solids.full.depth()},
                                                                {"edgeColor", solids.edge.color(0)},
                                                                {"edgeDepth", solids.edge.depth()},
                                                                {"nextEdgeColor", solids.nextEdge.color(0)},
                                                                {"nextEdgeDepth", solids.nextEdge.depth()}}};
  for (std::size_t i = 0; i < textures.size(); ++i) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
    glBindTexture(GL_TEXTURE_2D, textures[i].second);
    program.set(textures[i].first, static_cast<int>(i));
  }
}

}  // namespace

const gl::ShaderProgram& Compositor::program(const Variant& variant) {
  if (const auto known = programs_.find(variant); known != programs_.end()) return known->second;
  const auto [transparent, solids, ellipsoids, planes] = variant;
  const std::string defines =
      fmt::format("#define TRANSPARENT {:d}\n#define SOLIDS {:d}\n#define ELLIPSOIDS {}\n#define PLANES {}\n",
                  transparent, solids, ellipsoids, planes);
  gl::ShaderProgram made("composite.frag", shaderSource("tiles.vert"), shaderSource("composite.frag", defines));
  return programs_.emplace(variant, std::move(made)).first->second;
}

void Compositor::draw(const draw::DrawList& list, const SolidLayers& solids, const TileMask& solidTiles,
                      float sharpness, bool transparent) {
  std::vector<GlassSheet> glass;
  std::vector<PlaneSheet> planes;
  for (const auto& e : list.glassEllipsoids) glass.push_back(glassSheet(list.camera, e));
  for (const auto& p : list.planes) planes.push_back(planeSheet(list.camera, p));

  std::map<Content, std::vector<glm::vec2>> tiles;
  for (int row = 0; row < solidTiles.rows(); ++row) {
    for (int column = 0; column < solidTiles.columns(); ++column) {
      const PixelBounds tile = solidTiles.tile(column, row);
      Content content{solidTiles.marked(column, row), {}, {}};
      auto& [hasSolids, ellipsoidsHere, planesHere] = content;
      for (std::size_t i = 0; i < glass.size(); ++i)
        if (touches(glass[i].outline.bounds, tile)) ellipsoidsHere.push_back(i);
      for (std::size_t i = 0; i < planes.size(); ++i)
        // With an ellipsoid the planes come along: two shaders fewer to compile for the few tiles it concerns.
        if (touches(planes[i], tile) || (planes[i].visible && !ellipsoidsHere.empty())) planesHere.push_back(i);
      if (hasSolids || !ellipsoidsHere.empty() || !planesHere.empty()) addRectangle(tiles[content], tile);
    }
  }

  glBindVertexArray(vertices_.id());
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(glm::vec2), nullptr);
  for (const auto& [content, triangles] : tiles) {
    const auto& [hasSolids, ellipsoidsHere, planesHere] = content;
    const auto& shader = program({transparent, hasSolids, ellipsoidsHere.size(), planesHere.size()});
    setPicture(shader, list, sharpness);
    shader.set("background", list.background);
    bindLayers(shader, solids);
    setGlass(shader, list, glass, ellipsoidsHere);
    setPlanes(shader, list, planes, planesHere);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(triangles.size() * sizeof(glm::vec2)), triangles.data(),
                 GL_STREAM_DRAW);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(triangles.size()));
  }
}

}  // namespace poinsot::render
