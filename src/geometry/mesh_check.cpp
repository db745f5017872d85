// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/error.h"
#include "core/expect.h"
#include "geometry/mesh_integrals.h"

namespace poinsot::geometry {
namespace {

// A volume this small beside that of its bounding box is rounding: a surface folded onto itself.
constexpr double kNoVolume = 1e-14;

[[noreturn]] void refuse(const std::string& message) { throw core::Error(core::ErrorKind::kScene, message); }

// An edge as one number, so that edges sort: its ends, the lower first, and whether a triangle runs along it
// upwards.
using Edge = std::uint64_t;
Edge edge(std::uint32_t from, std::uint32_t to) {
  return Edge{std::min(from, to)} << 32 | Edge{std::max(from, to)} << 1 | (from < to ? 1U : 0U);
}
Edge withoutSense(Edge e) { return e >> 1; }

/// Of every triangle with three corners; one with a corner repeated is a piece of an edge.
std::vector<Edge> sortedEdges(const Mesh& mesh) {
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles)
    if (a != b && b != c && c != a) edges.insert(edges.end(), {edge(a, b), edge(b, c), edge(c, a)});
  std::ranges::sort(edges);
  return edges;
}

std::string places(const Mesh& mesh, Edge e) {
  const Eigen::Vector3d& a = mesh.vertices_M[e >> 32];
  const Eigen::Vector3d& b = mesh.vertices_M[(e & 0xffffffffU) >> 1];
  return fmt::format("({}, {}, {}) to ({}, {}, {})", a[0], a[1], a[2], b[0], b[1], b[2]);
}

/// What is wrong with an edge that triangles run along so often.
std::string faultOf(std::size_t down, std::size_t up, const std::string& between) {
  if (down + up == 1)
    return fmt::format("the mesh is open at the edge from {}; only a closed surface has a volume", between);
  if (down == 0 || up == 0)
    return fmt::format(
        "two neighbouring triangles of the mesh run the same way along the edge from {}; one of them faces inward",
        between);
  return fmt::format(
      "more than two triangles of the mesh meet at the edge from {}; a body's surface has two at every edge",
      between);
}

void checkEdges(const Mesh& mesh) {
  const std::vector<Edge> edges = sortedEdges(mesh);
  for (auto first = edges.begin(); first != edges.end();) {
    const auto end =
        std::find_if(first, edges.end(), [&](Edge e) { return withoutSense(e) != withoutSense(*first); });
    const auto up = static_cast<std::size_t>(std::count_if(first, end, [](Edge e) { return e & 1U; }));
    const auto down = static_cast<std::size_t>(end - first) - up;
    if (up != 1 || down != 1) refuse(faultOf(down, up, places(mesh, *first)));
    first = end;
  }
}

void checkVolume(const Mesh& mesh) {
  const Eigen::Vector3d size = boundsOf(mesh).size_m();
  const double volume = integrals(mesh).volume_m3, box = size[0] * size[1] * size[2];
  if (volume < -kNoVolume * box)
    refuse(fmt::format(
        "the mesh is inside out: its volume is {} m³; flip its triangles (swap two corners of each)", volume));
  if (!(volume > kNoVolume * box)) refuse("the mesh encloses no volume");
  if (!std::isfinite(volume)) refuse("the mesh is too large for its volume to be a number");
}

}  // namespace

void checkClosed(const Mesh& mesh) {
  if (mesh.triangles.empty()) refuse("the mesh has no triangles");
  POINSOT_EXPECT(mesh.vertices_M.size() < std::size_t{1} << 31);
  for (const Mesh::Triangle& triangle : mesh.triangles)
    for (const std::uint32_t i : triangle) POINSOT_EXPECT(i < mesh.vertices_M.size());
  checkEdges(mesh);
  checkVolume(mesh);
}

}  // namespace poinsot::geometry
