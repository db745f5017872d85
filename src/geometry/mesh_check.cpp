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

/// A directed edge as one number, so that edges sort.
using Edge = std::uint64_t;
Edge edge(std::uint32_t from, std::uint32_t to) { return Edge{from} << 32 | to; }
Edge reversed(Edge e) { return e << 32 | e >> 32; }

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
  const Eigen::Vector3d& b = mesh.vertices_M[e & 0xffffffffU];
  return fmt::format("({}, {}, {}) to ({}, {}, {})", a[0], a[1], a[2], b[0], b[1], b[2]);
}

void checkEdges(const Mesh& mesh) {
  const std::vector<Edge> edges = sortedEdges(mesh);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool twice = i > 0 && edges[i] == edges[i - 1];
    const bool paired = std::ranges::binary_search(edges, reversed(edges[i]));
    if (twice && paired)
      refuse(
          fmt::format("more than two triangles of the mesh meet at the edge from {}; a body's surface has two at "
                      "every edge",
                      places(mesh, edges[i])));
    if (twice)
      refuse(
          fmt::format("two neighbouring triangles of the mesh run the same way along the edge from {}; one of "
                      "them faces inward",
                      places(mesh, edges[i])));
    if (!paired && (i + 1 == edges.size() || edges[i + 1] != edges[i]))
      refuse(fmt::format("the mesh is open at the edge from {}; only a closed surface has a volume",
                         places(mesh, edges[i])));
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
  for (const Mesh::Triangle& triangle : mesh.triangles)
    for (const std::uint32_t i : triangle) POINSOT_EXPECT(i < mesh.vertices_M.size());
  checkEdges(mesh);
  checkVolume(mesh);
}

}  // namespace poinsot::geometry
