// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh_parts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <vector>

namespace poinsot::geometry {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kMostComparisons = 100'000'000;  // so many comparisons take about a second

struct Part {
  std::size_t triangle = 0;  ///< index of the part's first triangle
  Bounds bounds;
  double volume_m3 = 0;

  double noVolume_m3() const { return kNoVolume * bounds.size_m().prod(); }
};

/// Union-find structure of the vertices: vertices that triangles connect have the same root.
class Joined {
 public:
  explicit Joined(const Mesh& mesh) : parents_(mesh.vertices_M.size()) {
    std::iota(parents_.begin(), parents_.end(), std::uint32_t{0});
    for (const auto& [a, b, c] : mesh.triangles) {
      join(a, b);
      join(b, c);
    }
  }

  std::uint32_t root(std::uint32_t i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }

 private:
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    parents_[std::max(a, b)] = std::min(a, b);
  }

  std::vector<std::uint32_t> parents_;
};

/// Adds a triangle to a part. The volume is measured from a corner of the part, so that a part far from the origin
/// loses no digits.
void add(Part& part, const Mesh& mesh, const Mesh::Triangle& t) {
  const Vector3d& origin = mesh.vertices_M[mesh.triangles[part.triangle][0]];
  const Vector3d a = mesh.vertices_M[t[0]] - origin, b = mesh.vertices_M[t[1]] - origin,
                 c = mesh.vertices_M[t[2]] - origin;
  part.volume_m3 += a.dot(b.cross(c)) / 6;
  for (const std::uint32_t i : t) {
    part.bounds.low_M = part.bounds.low_M.cwiseMin(mesh.vertices_M[i]);
    part.bounds.high_M = part.bounds.high_M.cwiseMax(mesh.vertices_M[i]);
  }
}

std::vector<Part> partsOf(const Mesh& mesh) {
  Joined joined(mesh);
  std::vector<Part> parts;
  // Number of the part that has this root vertex, counted from 1. A value of 0 means that the part does not exist
  // yet.
  std::vector<std::uint32_t> partAt(mesh.vertices_M.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Mesh::Triangle& t = mesh.triangles[i];
    std::uint32_t& at = partAt[joined.root(t[0])];
    if (at == 0) {
      parts.push_back({i, {mesh.vertices_M[t[0]], mesh.vertices_M[t[0]]}});
      at = static_cast<std::uint32_t>(parts.size());
    }
    add(parts[at - 1], mesh, t);
  }
  return parts;
}

bool liesIn(const Bounds& inner, const Bounds& outer) {
  return (inner.low_M.array() >= outer.low_M.array()).all() &&
         (inner.high_M.array() <= outer.high_M.array()).all();
}

}  // namespace

std::optional<std::size_t> strayCavity(const Mesh& mesh) {
  std::vector<Part> parts = partsOf(mesh);
  const auto outward =
      std::partition(parts.begin(), parts.end(), [](const Part& p) { return p.volume_m3 < -p.noVolume_m3(); });
  const auto cavities = static_cast<std::size_t>(outward - parts.begin());
  if (cavities * (parts.size() - cavities) > kMostComparisons) return std::nullopt;
  for (auto cavity = parts.begin(); cavity != outward; ++cavity)
    if (std::none_of(outward, parts.end(), [&](const Part& p) { return liesIn(cavity->bounds, p.bounds); }))
      return cavity->triangle;
  return std::nullopt;
}

}  // namespace poinsot::geometry
