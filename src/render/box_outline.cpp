// SPDX-License-Identifier: Apache-2.0
#include "render/box_outline.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace poinsot::render {

bool BoxOutline::inside(glm::vec2 p_px) const {
  return std::any_of(edges.begin(), edges.end(), [&](const auto& face) {
    return std::all_of(face.begin(), face.end(),
                       [&](glm::vec3 e) { return glm::dot(glm::vec2(e), p_px) + e.z >= 0; });
  });
}

BoxOutline boxOutline(const draw::Camera& camera, const draw::Box& box) {
  BoxOutline outline;
  for (auto& face : outline.edges) face.fill(glm::vec3(0, 0, -1e6f));
  outline.normals_C.fill(glm::vec3(0, 0, 1));
  outline.points_C.fill(glm::vec3(0, 0, -camera.far));
  const glm::vec3 centre_C = toCamera(camera, box.centre_W);
  const glm::mat3 half_C = glm::transpose(camera.R_WC) * box.halfAxes_W;
  const float reach = std::abs(half_C[0].z) + std::abs(half_C[1].z) + std::abs(half_C[2].z);
  if (-centre_C.z - reach <= camera.near) return outline;
  std::size_t face = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      const glm::vec3 u = half_C[(axis + 1) % 3], v = half_C[(axis + 2) % 3];
      const glm::vec3 middle = centre_C + side * half_C[axis], normal = side * glm::normalize(half_C[axis]);
      if (glm::dot(normal, middle) >= 0) continue;  // looks away from the eye
      const std::array<glm::vec3, 4> corners_C{middle - u - v, middle + u - v, middle + u + v, middle - u + v};
      std::array<glm::vec2, 4> corners;
      for (std::size_t i = 0; i < 4; ++i) {
        corners[i] = projectCamera(camera, corners_C[i]);
        outline.bounds.include(corners[i], 1.5f);
      }
      outline.edges[face] = quadEdges(corners);
      outline.normals_C[face] = normal;
      outline.points_C[face++] = middle;
    }
  }
  return outline;
}

}  // namespace poinsot::render
