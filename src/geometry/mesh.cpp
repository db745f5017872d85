// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <compare>
#include <limits>
#include <utility>

#include "core/expect.h"
#include "geometry/mesh_expectations.h"

namespace poinsot::geometry {
namespace {

struct Place {
  double x, y, z;
  std::uint32_t vertex;

  bool sameAs(const Place& other) const { return x == other.x && y == other.y && z == other.z; }
  auto operator<=>(const Place&) const = default;  // NOLINT(modernize-use-nullptr): of what is made here
};

/// Returns, for each vertex, the index of the first vertex at the same position. The positions are copied and
/// sorted. Sorting indices instead would be slower, and hashing has slow cases that a hostile file could provoke.
std::vector<std::uint32_t> firstAtEachPlace(const std::vector<Eigen::Vector3d>& vertices_M) {
  std::vector<Place> places;
  places.reserve(vertices_M.size());
  for (const Eigen::Vector3d& v : vertices_M)
    places.push_back({v[0], v[1], v[2], static_cast<std::uint32_t>(places.size())});
  std::ranges::sort(places, [](const Place& a, const Place& b) { return a < b; });
  std::vector<std::uint32_t> first(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool again = i > 0 && places[i].sameAs(places[i - 1]);
    first[places[i].vertex] = again ? first[places[i - 1].vertex] : places[i].vertex;
  }
  return first;
}

}  // namespace

std::string toString(const FilePlace& place) {
  const std::uint64_t number = place.number;  // copied, because a reference cannot bind to a bit field
  return fmt::format("{} {}", place.isLine ? "line" : "byte", number);
}

Eigen::Vector3d Bounds::centre_M() const { return low_M + size_m() / 2; }

Bounds boundsOf(const Mesh& mesh) {
  POINSOT_EXPECT(!mesh.vertices_M.empty());
  Bounds bounds{mesh.vertices_M[0], mesh.vertices_M[0]};
  for (const Eigen::Vector3d& v : mesh.vertices_M) {
    bounds.low_M = bounds.low_M.cwiseMin(v);
    bounds.high_M = bounds.high_M.cwiseMax(v);
  }
  return bounds;
}

Mesh flipped(Mesh mesh) {
  for (Mesh::Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

Mesh joined(Mesh a, const Mesh& b) {
  const auto shift = static_cast<std::uint32_t>(a.vertices_M.size());
  a.vertices_M.insert(a.vertices_M.end(), b.vertices_M.begin(), b.vertices_M.end());
  a.places.clear();
  for (const Mesh::Triangle& t : b.triangles) a.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  return a;
}

Mesh transformed(Mesh mesh, const Eigen::Matrix3d& A, const Eigen::Vector3d& offset_M) {
  const Eigen::Matrix3d scaled = A / A.cwiseAbs().maxCoeff();  // prevents underflow of the determinant
  POINSOT_EXPECT(scaled.determinant() > 0);
  for (Eigen::Vector3d& v : mesh.vertices_M) v = A.col(0) * v[0] + A.col(1) * v[1] + A.col(2) * v[2] + offset_M;
  return mesh;
}

Mesh merged(const Mesh& mesh, const std::vector<std::uint32_t>& target) {
  POINSOT_EXPECT(target.size() == mesh.vertices_M.size());
  for (const std::uint32_t i : target) POINSOT_EXPECT(i < target.size() && target[i] == i);
  expectIndicesInRange(mesh);
  constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<bool> used(target.size());
  for (const Mesh::Triangle& triangle : mesh.triangles)
    for (const std::uint32_t i : triangle) used[target[i]] = true;
  Mesh result;
  std::vector<std::uint32_t> number(target.size(), kUnused);
  for (std::size_t i = 0; i < target.size(); ++i) {
    if (!used[i]) continue;
    number[i] = static_cast<std::uint32_t>(result.vertices_M.size());
    result.vertices_M.push_back(mesh.vertices_M[i]);
  }
  result.triangles.reserve(mesh.triangles.size());
  for (const Mesh::Triangle& t : mesh.triangles)
    result.triangles.push_back({number[target[t[0]]], number[target[t[1]]], number[target[t[2]]]});
  result.places = mesh.places;
  return result;
}

Mesh welded(const Mesh& mesh) {
  expectFinite(mesh);
  return merged(mesh, firstAtEachPlace(mesh.vertices_M));
}

}  // namespace poinsot::geometry
