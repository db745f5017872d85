// SPDX-License-Identifier: Apache-2.0
#include "figure/visibility_solids.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "figure/visibility.h"
#include "figure/visibility_tree.h"

namespace poinsot::figure {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

// Occluder that tests lines in the mesh's own axes M. Its tree is built in M. Distances t along a line are the
// same there.
class MeshOccluder : public Occluder {
 public:
  MeshOccluder(std::shared_ptr<const draw::TriangleMesh> mesh, glm::dvec3 origin_C, const glm::dmat3& axes_C)
      : mesh_(std::move(mesh)), toMesh_(glm::inverse(axes_C)), origin_C_(origin_C), tree_(boundsOf(*mesh_)) {}

  bool hides(const SightLine& sight, double t) const override {
    const Line line{toMesh_ * (sight.origin_C - origin_C_), toMesh_ * sight.direction_C};
    return tree_.any(line, t, [&](std::size_t k) { return meets(mesh_->triangles[k], line, t); });
  }

 private:
  static std::vector<Bounds> boundsOf(const draw::TriangleMesh& mesh) {
    std::vector<Bounds> all;
    all.reserve(mesh.triangles.size());
    for (const Triangle& triangle : mesh.triangles) {
      Bounds bounds;
      for (const std::uint32_t v : triangle) bounds.include(mesh.vertices_M[v]);
      all.push_back(bounds);
    }
    return all;
  }

  // Returns whether the line passes through the triangle. A line inside turns about all three edges in the same
  // direction. For two triangles with a common edge, the numbers of that edge differ only in sign, so no line can
  // pass between neighbours.
  bool meets(const Triangle& triangle, const Line& line, double t) const {
    const auto corner = [&](std::size_t i) { return glm::dvec3(mesh_->vertices_M[triangle[i]]) - line.origin; };
    const glm::dvec3 a = corner(0), b = corner(1), c = corner(2);
    const double u = turn(line, triangle[1], triangle[2], b, c), v = turn(line, triangle[2], triangle[0], c, a),
                 w = turn(line, triangle[0], triangle[1], a, b);
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return false;
    const double sum = u + v + w;
    if (sum == 0) return false;  // the triangle is seen edge-on; its neighbours hide what is behind
    const glm::dvec3 hit = (u * a + v * b + w * c) / sum;
    const double at = glm::dot(hit, line.direction) / glm::dot(line.direction, line.direction);
    return at > 0 && at < t;
  }

  static double turn(const Line& line, std::uint32_t i, std::uint32_t j, glm::dvec3 from, glm::dvec3 to) {
    return i < j ? glm::dot(line.direction, glm::cross(from, to))
                 : -glm::dot(line.direction, glm::cross(to, from));
  }

  std::shared_ptr<const draw::TriangleMesh> mesh_;
  glm::dmat3 toMesh_;
  glm::dvec3 origin_C_;
  BoundsTree tree_;
};

}  // namespace

std::unique_ptr<const Occluder> makeMeshOccluder(const draw::Camera& camera, const draw::Mesh& mesh) {
  if (mesh.mesh == nullptr) return nullptr;
  const glm::dvec3 origin_C = toCameraExactly(camera, mesh.origin_V);
  const glm::dmat3 axes_C = turnToCamera(camera, mesh.axes_V);
  const auto beyondNear = [&](glm::vec3 p_M) {
    return -(origin_C + axes_C * glm::dvec3(p_M)).z > static_cast<double>(camera.near);
  };
  if (!std::ranges::all_of(mesh.mesh->vertices_M, beyondNear)) return nullptr;
  return std::make_unique<MeshOccluder>(mesh.mesh, origin_C, axes_C);
}

}  // namespace poinsot::figure
