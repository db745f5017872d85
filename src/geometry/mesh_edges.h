// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh.h"

// Edges of a mesh, for mesh_check.cpp and mesh_joining.cpp. Internal to this layer.
namespace poinsot::geometry {

/// An edge as a triangle runs along it, in one number so that edges sort: the lower vertex, the higher vertex, and
/// in the last bit whether the triangle runs from the lower to the higher.
using Edge = std::uint64_t;

Edge edgeOf(std::uint32_t from, std::uint32_t to);
inline Edge withoutSense(Edge e) { return e >> 1; }
inline bool runsUp(Edge e) { return (e & 1U) != 0; }
inline std::uint32_t lowerEnd(Edge e) { return static_cast<std::uint32_t>(e >> 32); }
inline std::uint32_t higherEnd(Edge e) { return static_cast<std::uint32_t>((e & 0xffffffffU) >> 1); }

/// Whether a corner is repeated, so that the triangle is a piece of an edge.
inline bool isCollapsed(const Mesh::Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

/// Returns the edges of all triangles that are not collapsed, sorted.
/// @pre fewer than 2^31 vertices.
std::vector<Edge> sortedEdges(const Mesh& mesh);

/// Returns each edge along which more triangles run one way than the other, once, sorted. A surface is closed
/// where there is none: every directed edge is then cancelled by an opposite one.
/// @param edges  as sortedEdges() returns them.
std::vector<Edge> unbalancedEdges(const std::vector<Edge>& edges);

}  // namespace poinsot::geometry
