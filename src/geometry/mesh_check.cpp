// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.h"
#include "core/expect.h"
#include "geometry/mesh_edges.h"
#include "geometry/mesh_expectations.h"
#include "geometry/mesh_integrals.h"
#include "geometry/mesh_parts.h"

namespace poinsot::geometry {
namespace {

std::string text(const Eigen::Vector3d& v) { return fmt::format("({}, {}, {})", v[0], v[1], v[2]); }

std::string ends(const Mesh& mesh, Edge e) {
  return text(mesh.vertices_M[lowerEnd(e)]) + " to " + text(mesh.vertices_M[higherEnd(e)]);
}

/// Returns the file positions of triangles for a message, such as " (of the triangle at line 12)". Returns an
/// empty text for a mesh that was not read from a file.
/// @param words  text before the positions, such as "of the triangle at"
std::string inFile(const Mesh& mesh, const char* words, const std::vector<std::size_t>& triangles) {
  if (mesh.places.empty()) return "";
  std::string places;
  for (const std::size_t i : triangles) places += (places.empty() ? "" : " and ") + toString(mesh.places[i]);
  return fmt::format(" ({} {})", words, places);
}

std::vector<std::size_t> trianglesAlong(const Mesh& mesh, Edge edge) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    if (isCollapsed({a, b, c})) continue;
    for (const Edge e : {edgeOf(a, b), edgeOf(b, c), edgeOf(c, a)})
      if (withoutSense(e) == withoutSense(edge)) found.push_back(i);
  }
  return found;
}

/// Returns the orientation of a triangle as 1 or -1. Two triangles with the same corners face the same way if
/// their values are equal.
int facing(Mesh::Triangle t) {
  std::rotate(t.begin(), std::ranges::min_element(t), t.end());
  return t[1] < t[2] ? 1 : -1;
}

[[noreturn]] void refuseTwice(const Mesh& mesh, std::vector<std::size_t> same, int way) {
  std::erase_if(same, [&](std::size_t i) { return facing(mesh.triangles[i]) != way; });
  const Mesh::Triangle& t = mesh.triangles[same[0]];
  throw core::sceneError(fmt::format("the mesh has the triangle {}, {}, {} more than once{}; remove all but one",
                                     text(mesh.vertices_M[t[0]]), text(mesh.vertices_M[t[1]]),
                                     text(mesh.vertices_M[t[2]]), inFile(mesh, "at", {same[0], same[1]})));
}

Mesh::Triangle sortedCorners(Mesh::Triangle t) {
  std::ranges::sort(t);
  return t;
}

/// Rejects a triangle that occurs twice among `triangles` and faces the same way, because its volume would count
/// twice. A copy that faces the other way cancels one occurrence.
void expectDistinct(const Mesh& mesh, std::vector<std::size_t> triangles) {
  const auto corners = [&](std::size_t i) { return sortedCorners(mesh.triangles[i]); };
  std::ranges::sort(triangles, {}, [&](std::size_t i) { return std::pair(corners(i), i); });
  for (auto first = triangles.begin(); first != triangles.end();) {
    const auto end =
        std::find_if(first, triangles.end(), [&](std::size_t i) { return corners(i) != corners(*first); });
    const int sum =
        std::accumulate(first, end, 0, [&](int s, std::size_t i) { return s + facing(mesh.triangles[i]); });
    if (std::abs(sum) > 1) refuseTwice(mesh, {first, end}, sum > 0 ? 1 : -1);
    first = end;
  }
}

[[noreturn]] void refuseEdge(const Mesh& mesh, Edge edge, const std::vector<Edge>& edges) {
  const std::vector<std::size_t> along = trianglesAlong(mesh, edge);
  const std::string between = ends(mesh, edge);
  if (along.size() == 1)
    throw core::sceneError(fmt::format(
        "the mesh is open at the edge from {}{}; only a closed surface has a volume: close the hole in "
        "a mesh program",
        between, inFile(mesh, "of the triangle at", along)));
  expectDistinct(mesh, along);
  if (along.size() == 2)
    throw core::sceneError(fmt::format(
        "two neighbouring triangles of the mesh run the same way along the edge from {}{}; one of them "
        "faces inward: swap two of its corners",
        between, inFile(mesh, "at", along)));
  const auto up = static_cast<std::size_t>(
      std::ranges::count_if(edges, [&](Edge e) { return withoutSense(e) == withoutSense(edge) && runsUp(e); }));
  throw core::sceneError(
      fmt::format("{} triangles of the mesh run one way along the edge from {} and {} the other way{}; a closed "
                  "surface has as many of each: remove a triangle, or add what is missing, in a mesh program",
                  std::max(up, along.size() - up), between, std::min(up, along.size() - up),
                  inFile(mesh, "the first is at", {along[0]})));
}

void checkVolume(const Mesh& mesh) {
  const Eigen::Vector3d size = boundsOf(mesh).size_m();
  const double volume = integrals(mesh).volume_m3, box = size[0] * size[1] * size[2];
  if (std::isinf(volume))
    throw core::sceneError(
        "the volume of the mesh is beyond the range of a double; give its lengths in a larger unit");
  if (volume < -kNoVolume * box)
    throw core::sceneError(fmt::format(
        "the mesh is inside out: its volume is {} m³; flip its triangles (swap two corners of each)", volume));
  if (!(volume > kNoVolume * box))  // also true for NaN, the result of integrals() for a volume of exactly 0
    throw core::sceneError(
        "the volume of the mesh is 0: its triangles lie in one plane, or each faces another at the same place; "
        "remove the triangles that face inward, or give the surface a thickness");
}

void checkParts(const Mesh& mesh) {
  const std::optional<std::size_t> triangle = strayCavity(mesh);
  if (!triangle) return;
  const Eigen::Vector3d& corner = mesh.vertices_M[mesh.triangles[*triangle][0]];
  throw core::sceneError(
      fmt::format("the part of the mesh that has a corner at {}{} is inside out and is not inside another part; "
                  "flip its triangles (swap two corners of each)",
                  text(corner), inFile(mesh, "of the triangle at", {*triangle})));
}

/// Rejects a mesh that contains a triangle twice. Only a mesh with a repeated directed edge can contain one.
void checkDistinct(const Mesh& mesh, const std::vector<Edge>& edges) {
  if (std::ranges::adjacent_find(edges) == edges.end()) return;
  std::vector<std::size_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::erase_if(all, [&](std::size_t i) { return isCollapsed(mesh.triangles[i]); });
  expectDistinct(mesh, std::move(all));
}

}  // namespace

void checkClosed(const Mesh& mesh) {
  if (mesh.triangles.empty()) throw core::sceneError("the mesh has no triangles; a body is bounded by triangles");
  POINSOT_EXPECT(mesh.vertices_M.size() < std::size_t{1} << 31);
  expectIndicesInRange(mesh);
  expectFinite(mesh);
  const std::vector<Edge> edges = sortedEdges(mesh), unbalanced = unbalancedEdges(edges);
  if (!unbalanced.empty()) refuseEdge(mesh, unbalanced.front(), edges);
  checkVolume(mesh);
  checkDistinct(mesh, edges);
  checkParts(mesh);
}

}  // namespace poinsot::geometry
