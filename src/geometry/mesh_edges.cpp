// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh_edges.h"

#include <algorithm>

namespace poinsot::geometry {

Edge edgeOf(std::uint32_t from, std::uint32_t to) {
  return Edge{std::min(from, to)} << 32 | Edge{std::max(from, to)} << 1 | (from < to ? 1U : 0U);
}

std::vector<Edge> sortedEdges(const Mesh& mesh) {
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const Mesh::Triangle& t : mesh.triangles)
    if (!isCollapsed(t)) edges.insert(edges.end(), {edgeOf(t[0], t[1]), edgeOf(t[1], t[2]), edgeOf(t[2], t[0])});
  std::ranges::sort(edges);
  return edges;
}

std::vector<Edge> unbalancedEdges(const std::vector<Edge>& edges) {
  std::vector<Edge> unbalanced;
  for (auto first = edges.begin(); first != edges.end();) {
    const auto end =
        std::find_if(first, edges.end(), [&](Edge e) { return withoutSense(e) != withoutSense(*first); });
    if (2 * std::count_if(first, end, runsUp) != end - first) unbalanced.push_back(*first);
    first = end;
  }
  return unbalanced;
}

}  // namespace poinsot::geometry
