// SPDX-License-Identifier: Apache-2.0
#include "render/screen_mesh.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/expect.h"

namespace poinsot::render {
namespace {

// In widths of the line, towards the eye: the faces beside a hollow edge stand before it.
constexpr float kLift = 1.5f;

// False when a vertex is not in front of the camera.
bool projectVertices(const draw::Camera& camera, ScreenMesh& screen) {
  const glm::dmat3 axes_C(screen.axes_C);
  const glm::dvec3 origin_C(screen.origin_C);
  const glm::dvec2 centre_px(camera.centre_px);
  const double focal_px = static_cast<double>(camera.focal_px());
  screen.vertices.reserve(screen.mesh->mesh->vertices_M.size());
  for (const glm::vec3& p_M : screen.mesh->mesh->vertices_M) {
    const glm::dvec3 p_C = origin_C + axes_C * glm::dvec3(p_M);
    if (-p_C.z <= static_cast<double>(camera.near)) return false;
    const double scale = focal_px / -p_C.z;
    screen.vertices.emplace_back(centre_px.x + scale * p_C.x, centre_px.y - scale * p_C.y, -p_C.z);
  }
  return true;
}

// With y down, what is counter-clockwise to the eye has a negative area.
bool looksAtEye(const std::array<glm::dvec3, 3>& t) {
  return (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[1].y - t[0].y) * (t[2].x - t[0].x) < 0;
}

}  // namespace

std::array<glm::dvec3, 3> ScreenMesh::triangle(std::size_t face) const {
  const auto& t = mesh->mesh->triangles[face];
  return {vertices[t[0]], vertices[t[1]], vertices[t[2]]};
}

ScreenMesh screenMesh(const draw::Camera& camera, const draw::Mesh& mesh, const MeshTopology& topology) {
  POINSOT_EXPECT(glm::determinant(glm::dmat3(mesh.axes_W)) > 0);
  ScreenMesh screen{&mesh, &topology, {}, {}, {}, {}, {}, {}};
  screen.axes_C = glm::transpose(camera.R_WC) * mesh.axes_W;
  screen.origin_C = toCamera(camera, mesh.origin_W);
  // Times the determinant, which is positive: no tiny numbers for a mesh in other units.
  const glm::dmat3 axes_C(screen.axes_C);
  screen.normals_C = glm::transpose(glm::inverse(axes_C)) * std::cbrt(glm::determinant(axes_C));
  if (!projectVertices(camera, screen)) return screen;
  for (const glm::dvec3& v : screen.vertices) screen.bounds.include(glm::vec2(v), 1.0f);
  screen.front.resize(mesh.mesh->triangles.size());
  for (std::size_t f = 0; f < screen.front.size(); ++f) screen.front[f] = looksAtEye(screen.triangle(f));
  return screen;
}

std::vector<draw::Curve> edgeLines(const draw::Camera& camera, const ScreenMesh& screen) {
  std::vector<draw::Curve> lines;
  const draw::Mesh& mesh = *screen.mesh;
  if (mesh.edge_px <= 0 || screen.bounds.empty()) return lines;
  const float pixel_W = -screen.origin_C.z / camera.focal_px();
  draw::Curve line;
  line.width_px = mesh.edge_px;
  line.material = {mesh.edgeColor, 0};
  line.lift_W = kLift * std::max(mesh.edge_px, 1.0f) * pixel_W;
  const auto point = [&](std::uint32_t v) { return mesh.origin_W + mesh.axes_W * mesh.mesh->vertices_M[v]; };
  const auto finish = [&] {
    if (line.points_W.size() > 1) lines.push_back(line);
    line.points_W.clear();
  };
  for (const EdgeChain& chain : screen.topology->chains) {
    for (std::size_t i = 0; i < chain.edges.size(); ++i) {
      if (!screen.isFront(screen.topology->edges[chain.edges[i]])) {
        finish();
        continue;
      }
      if (line.points_W.empty()) line.points_W.push_back(point(chain.vertices[i]));
      line.points_W.push_back(point(chain.vertices[i + 1]));
    }
    finish();
  }
  return lines;
}

}  // namespace poinsot::render
