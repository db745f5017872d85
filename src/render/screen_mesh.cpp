// SPDX-License-Identifier: Apache-2.0
#include "render/screen_mesh.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/expect.h"

namespace poinsot::render {
namespace {

bool projectVertices(const draw::Camera& camera, ScreenMesh& screen) {
  const glm::dmat3 axes_C(screen.axes_C);
  const glm::dvec3 origin_C(screen.origin_C);
  const glm::dvec2 centre_px(camera.centre_px);
  const double focal_px = static_cast<double>(camera.focal_px());
  screen.vertices.reserve(screen.mesh->mesh->vertices_M.size());
  for (const glm::vec3& p_M : screen.mesh->mesh->vertices_M) {
    const glm::dvec3 p_C = origin_C + axes_C * glm::dvec3(p_M);
    if (-p_C.z <= static_cast<double>(camera.near)) return false;
    const double scale = camera.orthographic ? focal_px : focal_px / -p_C.z;
    screen.vertices.emplace_back(centre_px.x + scale * p_C.x, centre_px.y - scale * p_C.y, -p_C.z);
  }
  return true;
}

}  // namespace

double pixelSize(const draw::Camera& camera, double depth) {
  const auto focal_px = static_cast<double>(camera.focal_px());
  return camera.orthographic ? 1 / focal_px : depth / focal_px;
}

double signedArea(const std::array<glm::dvec3, 3>& t) {
  return 0.5 * ((t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[1].y - t[0].y) * (t[2].x - t[0].x));
}

std::array<glm::dvec3, 3> ScreenMesh::triangle(std::size_t face) const {
  const auto& t = mesh->mesh->triangles[face];
  return {vertices[t[0]], vertices[t[1]], vertices[t[2]]};
}

ScreenMesh screenMesh(const draw::Camera& camera, const draw::Mesh& mesh, const MeshTopology& topology) {
  POINSOT_EXPECT(glm::determinant(glm::dmat3(mesh.axes_V)) > 0);
  ScreenMesh screen{&mesh, &topology, {}, {}, {}, {}, {}, {}};
  screen.axes_C = glm::transpose(camera.R_VC) * mesh.axes_V;
  screen.origin_C = toCamera(camera, mesh.origin_V);
  const glm::dmat3 normals = glm::transpose(glm::inverse(glm::dmat3(screen.axes_C)));
  const double longest = std::max({glm::length(normals[0]), glm::length(normals[1]), glm::length(normals[2])});
  // The scale avoids tiny numbers if the mesh's unit of length is very large or small.
  screen.normals_C = normals / longest;
  if (!projectVertices(camera, screen)) return screen;
  for (const glm::dvec3& v : screen.vertices) screen.bounds.include(glm::vec2(v), 1.0f);
  screen.front.resize(mesh.mesh->triangles.size());
  for (std::size_t f = 0; f < screen.front.size(); ++f) screen.front[f] = signedArea(screen.triangle(f)) < 0;
  return screen;
}

}  // namespace poinsot::render
