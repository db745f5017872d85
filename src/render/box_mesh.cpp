// SPDX-License-Identifier: Apache-2.0
#include "render/box_mesh.h"

#include <glm/matrix.hpp>

namespace poinsot::render {
namespace {

using Index = std::uint32_t;

// Corners at (±1, ±1, ±1); bit k of a corner's number is the side along axis k.
std::shared_ptr<const draw::TriangleMesh> makeCube() {
  auto cube = std::make_shared<draw::TriangleMesh>();
  for (int i = 0; i < 8; ++i) cube->vertices_M.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  for (Index axis = 0; axis < 3; ++axis) {
    const Index u = 1u << (axis + 1) % 3, v = 1u << (axis + 2) % 3, far = 1u << axis;
    cube->triangles.insert(
        cube->triangles.end(),
        {{far, far + u, far + u + v}, {far, far + u + v, far + v}, {0, u + v, u}, {0, v, u + v}});
  }
  return cube;
}

}  // namespace

draw::Mesh boxMesh(const draw::Box& box) {
  static const auto cube = makeCube();
  draw::Mesh mesh;
  const float determinant = glm::determinant(box.halfAxes_W);
  if (determinant != 0) mesh.mesh = cube;
  mesh.origin_W = box.centre_W;
  mesh.axes_W = box.halfAxes_W;
  if (determinant < 0) mesh.axes_W[0] *= -1.0f;  // a box is its own mirror image
  mesh.material = box.material;
  return mesh;
}

}  // namespace poinsot::render
