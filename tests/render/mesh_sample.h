// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <utility>

#include "mesh_shapes.h"
#include "random.h"

namespace poinsot::render {

/// Returns three random axes at right angles, each `size` long, right-handed.
inline glm::mat3 randomAxes(Random& random, float size) {
  const glm::vec3 a = random.direction(), b = random.across(a);
  return size * glm::mat3(a, b, glm::cross(a, b));
}

inline draw::Mesh meshOf(MeshPointer mesh, const glm::mat3& axes_V, draw::Material material) {
  draw::Mesh m;
  m.mesh = std::move(mesh);
  m.axes_V = axes_V;
  m.material = material;
  return m;
}

}  // namespace poinsot::render
