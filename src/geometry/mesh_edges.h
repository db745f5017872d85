// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh.h"

namespace poinsot::geometry {

/// Directed edge of a triangle, packed into one number for sorting: the lower vertex, the higher vertex and, in
/// the last bit, whether the edge runs from the lower to the higher vertex.
using Edge = std::uint64_t;

Edge edgeOf(std::uint32_t from, std::uint32_t to);
inline Edge withoutSense(Edge e) { return e >> 1; }
inline bool runsUp(Edge e) { return (e & 1U) != 0; }
inline std::uint32_t lowerEnd(Edge e) { return static_cast<std::uint32_t>(e >> 32); }
inline std::uint32_t higherEnd(Edge e) { return static_cast<std::uint32_t>((e & 0xffffffffU) >> 1); }

/// Returns whether two corners of a triangle are the same vertex, so that the triangle has no area.
inline bool isCollapsed(const Mesh::Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

/// Returns the sorted edges of all triangles, except collapsed triangles.
/// @pre fewer than 2^31 vertices.
std::vector<Edge> sortedEdges(const Mesh& mesh);

/// Returns the edges along which more triangles run one way than the other. Each edge occurs once, in sorted
/// order. If the result is empty, the surface is closed.
/// @param edges  result of sortedEdges()
std::vector<Edge> unbalancedEdges(const std::vector<Edge>& edges);

}  // namespace poinsot::geometry
