// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh.h"

namespace poinsot::geometry {

/// Edge as a triangle runs along it, in one number that sorts: the lower vertex, the higher vertex and, in the
/// last bit, whether the triangle runs from the lower to the higher.
using Edge = std::uint64_t;

Edge edgeOf(std::uint32_t from, std::uint32_t to);
inline Edge withoutSense(Edge e) { return e >> 1; }
inline bool runsUp(Edge e) { return (e & 1U) != 0; }
inline std::uint32_t lowerEnd(Edge e) { return static_cast<std::uint32_t>(e >> 32); }
inline std::uint32_t higherEnd(Edge e) { return static_cast<std::uint32_t>((e & 0xffffffffU) >> 1); }

/// Returns whether a corner is repeated, so that the triangle is only a piece of an edge.
inline bool isCollapsed(const Mesh::Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

/// Returns the edges of all triangles that are not collapsed, sorted.
/// @pre fewer than 2^31 vertices.
std::vector<Edge> sortedEdges(const Mesh& mesh);

/// Returns each edge along which more triangles run one way than the other, once, sorted. If there is none, the
/// surface is closed: an opposite edge cancels every directed edge.
/// @param edges  as sortedEdges() returns them.
std::vector<Edge> unbalancedEdges(const std::vector<Edge>& edges);

}  // namespace poinsot::geometry
