// SPDX-License-Identifier: Apache-2.0
#include "render/mesh_topology.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <span>

#include "core/expect.h"

namespace poinsot::render {
namespace {

using Index = std::uint32_t;
using glm::dvec3;

/// Side of a face, with a direction. The adjacent face has the same side in the opposite direction.
struct HalfEdge {
  Index from, to, face;
  Index low() const { return std::min(from, to); }
  Index high() const { return std::max(from, to); }
  bool sameEdge(const HalfEdge& other) const { return low() == other.low() && high() == other.high(); }
};

std::vector<HalfEdge> sortedHalfEdges(const draw::TriangleMesh& mesh) {
  std::vector<HalfEdge> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (Index f = 0; f < mesh.triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) sides.push_back({mesh.triangles[f][k], mesh.triangles[f][(k + 1) % 3], f});
  std::sort(sides.begin(), sides.end(), [](const HalfEdge& a, const HalfEdge& b) {
    return std::array{a.low(), a.high(), a.face} < std::array{b.low(), b.high(), b.face};
  });
  return sides;
}

/// Sorts the sides on one edge into consecutive pairs of opposite direction, if more than two faces meet there.
/// Pairs are formed in the order of faces, so that each part of a body keeps its own edges. Unpaired sides come
/// last.
/// If both sides of a pair had the same direction, both faces could face the eye at an outline, which would look
/// jagged.
void pairOpposites(std::span<HalfEdge> sides) {
  const auto middle =
      std::stable_partition(sides.begin(), sides.end(), [](const HalfEdge& s) { return s.from < s.to; });
  const std::vector<HalfEdge> up(sides.begin(), middle), down(middle, sides.end());
  const std::size_t pairs = std::min(up.size(), down.size());
  auto at = sides.begin();
  for (std::size_t i = 0; i < pairs; ++i) {
    const bool upFirst = up[i].face < down[i].face;
    *at++ = upFirst ? up[i] : down[i];
    *at++ = upFirst ? down[i] : up[i];
  }
  at = std::copy(up.begin() + static_cast<std::ptrdiff_t>(pairs), up.end(), at);
  std::copy(down.begin() + static_cast<std::ptrdiff_t>(pairs), down.end(), at);
}

/// Adds an edge for each pair of consecutive sides. The last of an odd number is a border.
void addPairs(std::span<const HalfEdge> sides, std::vector<MeshEdge>& edges) {
  for (std::size_t i = 0; i < sides.size(); i += 2)
    edges.push_back(
        {sides[i].from, sides[i].to, sides[i].face, i + 1 < sides.size() ? sides[i + 1].face : kNoFace, false});
}

std::vector<MeshEdge> pairedEdges(const draw::TriangleMesh& mesh) {
  std::vector<HalfEdge> sides = sortedHalfEdges(mesh);
  std::vector<MeshEdge> edges;
  edges.reserve(sides.size() / 2);
  for (auto first = sides.begin(); first != sides.end();) {
    const auto end = std::find_if(first, sides.end(), [&](const HalfEdge& s) { return !s.sameEdge(*first); });
    const std::span<HalfEdge> same(first, end);
    if (same.size() > 2) pairOpposites(same);
    addPairs(same, edges);
    first = end;
  }
  return edges;
}

dvec3 faceNormal(const draw::TriangleMesh& mesh, Index face) {
  const auto& [a, b, c] = mesh.triangles[face];
  const dvec3 origin(mesh.vertices_M[a]);
  const dvec3 n = glm::cross(dvec3(mesh.vertices_M[b]) - origin, dvec3(mesh.vertices_M[c]) - origin);
  const double length = glm::length(n);
  return length > 0 ? n / length : dvec3(0);
}

// Sets `sharp` for each edge. Borders of an open mesh are sharp. Edges of faces without area are not.
void findCreases(const draw::TriangleMesh& mesh, float crease_rad, std::vector<MeshEdge>& edges) {
  const double least = std::cos(static_cast<double>(crease_rad));
  std::vector<dvec3> normals(mesh.triangles.size());
  for (Index f = 0; f < normals.size(); ++f) normals[f] = faceNormal(mesh, f);
  for (MeshEdge& e : edges) {
    if (e.right == kNoFace) {
      e.sharp = true;
      continue;
    }
    const dvec3 &l = normals[e.left], &r = normals[e.right];
    e.sharp = l != dvec3(0) && r != dvec3(0) && glm::dot(l, r) < least;
  }
}

/// Union-find over corners of faces (index 3 face + k). Corners at a vertex that no sharp edge separates have one
/// root.
class Patches {
 public:
  Patches(const draw::TriangleMesh& mesh, const std::vector<MeshEdge>& edges)
      : mesh_(mesh), parents_(3 * mesh.triangles.size()) {
    std::iota(parents_.begin(), parents_.end(), Index{0});
    for (const MeshEdge& e : edges) {
      if (e.sharp) continue;
      join(cornerAt(e.left, e.from), cornerAt(e.right, e.from));
      join(cornerAt(e.left, e.to), cornerAt(e.right, e.to));
    }
  }

  Index root(Index corner) {
    while (parents_[corner] != corner) corner = parents_[corner] = parents_[parents_[corner]];
    return corner;
  }

 private:
  Index cornerAt(Index face, Index vertex) const {
    const auto& t = mesh_.triangles[face];
    return 3 * face + (t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2);
  }
  void join(Index a, Index b) { parents_[std::max(root(a), root(b))] = std::min(root(a), root(b)); }

  const draw::TriangleMesh& mesh_;
  std::vector<Index> parents_;
};

dvec3 weightedNormal(const draw::TriangleMesh& mesh, Index face, std::size_t k) {
  const auto& t = mesh.triangles[face];
  const dvec3 at(mesh.vertices_M[t[k]]);
  const dvec3 u = dvec3(mesh.vertices_M[t[(k + 1) % 3]]) - at, v = dvec3(mesh.vertices_M[t[(k + 2) % 3]]) - at;
  const double scale = glm::dot(u, u) * glm::dot(v, v);
  return scale > 0 ? glm::cross(u, v) / scale : dvec3(0);
}

void addCorners(const draw::TriangleMesh& mesh, MeshTopology& topology) {
  Patches patches(mesh, topology.edges);
  std::vector<Index> cornerOf(3 * mesh.triangles.size(), kNoFace);
  std::vector<dvec3> sums;
  for (Index f = 0; f < mesh.triangles.size(); ++f) {
    std::array<Index, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      Index& corner = cornerOf[patches.root(3 * f + static_cast<Index>(k))];
      if (corner == kNoFace) {
        corner = static_cast<Index>(sums.size());
        sums.emplace_back(0);
        topology.corners.push_back({mesh.vertices_M[mesh.triangles[f][k]], {}});
      }
      sums[corner] += weightedNormal(mesh, f, k);
      corners[k] = corner;
    }
    topology.triangles.push_back(corners);
  }
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (const double length = glm::length(sums[i]); length > 0) topology.corners[i].normal_M = sums[i] / length;
}

// Cosine of 0.1 rad. A difference of 0.1 rad in the normal changes shading by a few of 255 steps.
constexpr double kRoughCosine = 0.995;

bool isRough(const draw::TriangleMesh& mesh, const MeshTopology& topology, Index face) {
  const auto& corners = topology.triangles[face];
  return std::any_of(corners.begin(), corners.end(), [&](Index corner) {
    return glm::dot(dvec3(topology.corners[corner].normal_M), faceNormal(mesh, face)) < kRoughCosine;
  });
}

/// Joins sharp edges into chains. A chain continues through vertices at which exactly two sharp edges meet.
class ChainFinder {
 public:
  ChainFinder(std::size_t vertices, const std::vector<MeshEdge>& edges) : edges_(edges), used_(edges.size()) {
    edgesAt_.resize(vertices);
    for (Index e = 0; e < edges.size(); ++e) {
      if (!edges[e].sharp) continue;
      edgesAt_[edges[e].from].push_back(e);
      edgesAt_[edges[e].to].push_back(e);
    }
  }

  std::vector<EdgeChain> find() {
    for (Index v = 0; v < edgesAt_.size(); ++v)
      if (edgesAt_[v].size() != 2) follow(v);
    for (Index v = 0; v < edgesAt_.size(); ++v) follow(v);  // the remaining edges form loops
    return std::move(chains_);
  }

 private:
  void follow(Index start) {
    for (const Index first : edgesAt_[start]) {
      if (used_[first]) continue;
      EdgeChain chain{{start}, {}};
      for (Index edge = first; edge != kNoFace; edge = next(chain.vertices.back())) {
        used_[edge] = true;
        chain.edges.push_back(edge);
        const Index at = chain.vertices.back();
        chain.vertices.push_back(edges_[edge].from == at ? edges_[edge].to : edges_[edge].from);
      }
      chains_.push_back(std::move(chain));
    }
  }

  Index next(Index vertex) const {
    if (edgesAt_[vertex].size() != 2) return kNoFace;
    for (const Index e : edgesAt_[vertex])
      if (!used_[e]) return e;
    return kNoFace;
  }

  const std::vector<MeshEdge>& edges_;
  std::vector<bool> used_;
  std::vector<std::vector<Index>> edgesAt_;
  std::vector<EdgeChain> chains_;
};

}  // namespace

MeshTopology meshTopology(const draw::TriangleMesh& mesh, float crease_rad) {
  for (const auto& t : mesh.triangles)
    for (const Index i : t) POINSOT_EXPECT(i < mesh.vertices_M.size());
  MeshTopology topology;
  topology.edges = pairedEdges(mesh);
  findCreases(mesh, crease_rad, topology.edges);
  topology.chains = ChainFinder(mesh.vertices_M.size(), topology.edges).find();
  addCorners(mesh, topology);
  for (Index f = 0; f < mesh.triangles.size(); ++f) topology.rough.push_back(isRough(mesh, topology, f));
  return topology;
}

}  // namespace poinsot::render
