// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh_joining.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include "geometry/mesh_edges.h"

namespace poinsot::geometry {
namespace {

constexpr double kRoundingOfDoubles = 1e-9, kRoundingOfFloats = 1e-6;  // distances relative to the mesh's size

struct Corner {
  Eigen::Vector3d place;
  std::uint32_t vertex;
};

/// Joins corners that are close together. A set of corners is split at every gap along x, then each part along y,
/// then along z, and so on in turn, until no axis splits a part. The corners of a part are joined, unless the part
/// is wider than the reach, as a long chain of neighbours is. Cells of a grid would be unsuitable, because their
/// borders could separate two neighbours. Sorting, unlike hashing, has no slow cases that a hostile file could
/// provoke.
class Joiner {
 public:
  Joiner(const Mesh& mesh, double reach) : reach_(reach), target_(mesh.vertices_M.size()) {
    std::iota(target_.begin(), target_.end(), std::uint32_t{0});
  }

  void join(std::span<Corner> corners) { divide(corners, 0, 0, kMostRounds); }

  std::size_t count() const { return count_; }
  double farthest() const { return farthest_; }
  const std::vector<std::uint32_t>& target() const { return target_; }

 private:
  static constexpr int kMostRounds = 12;  // four rounds for each axis; two are enough for usual files

  /// Splits corners at gaps along `axis`, then each part along the next axes. Joins the parts that no axis splits.
  /// @param undivided  number of axes tried in succession that did not split these corners
  void divide(std::span<Corner> corners, int axis, int undivided, int rounds) {
    if (corners.size() < 2) return;
    if (undivided == 3 || rounds == 0) return joinAll(corners);
    std::ranges::sort(corners, {}, [axis](const Corner& c) { return std::pair(c.place[axis], c.vertex); });
    for (std::size_t begin = 0, end = 1; end <= corners.size(); ++end) {
      if (end < corners.size() && corners[end].place[axis] - corners[end - 1].place[axis] <= reach_) continue;
      const std::span<Corner> part = corners.subspan(begin, end - begin);
      divide(part, (axis + 1) % 3, part.size() < corners.size() ? 1 : undivided + 1, rounds - 1);
      begin = end;
    }
  }

  void joinAll(std::span<Corner> corners) {
    Eigen::Vector3d low = corners[0].place, high = low;
    for (const Corner& c : corners) {
      low = low.cwiseMin(c.place);
      high = high.cwiseMax(c.place);
    }
    if ((high - low).maxCoeff() > reach_) return;
    const Corner first = *std::ranges::min_element(corners, {}, &Corner::vertex);
    for (const Corner& c : corners) {
      if (c.vertex == first.vertex) continue;
      target_[c.vertex] = first.vertex;
      farthest_ = std::max(farthest_, (c.place - first.place).stableNorm());
      ++count_;
    }
  }

  double reach_;
  std::vector<std::uint32_t> target_;
  std::size_t count_ = 0;
  double farthest_ = 0;
};

std::vector<Corner> cornersOf(const Mesh& mesh, const std::vector<Edge>& edges) {
  std::vector<std::uint32_t> ends;
  ends.reserve(2 * edges.size());
  for (const Edge e : edges) ends.insert(ends.end(), {lowerEnd(e), higherEnd(e)});
  std::ranges::sort(ends);
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  std::vector<Corner> corners;
  corners.reserve(ends.size());
  for (const std::uint32_t i : ends) corners.push_back({mesh.vertices_M[i], i});
  return corners;
}

Mesh joinedAt(const Mesh& mesh, const std::vector<std::uint32_t>& target) {
  Mesh kept{mesh.vertices_M, {}};
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    if (isCollapsed({target[a], target[b], target[c]})) continue;
    kept.triangles.push_back({a, b, c});
    if (!mesh.places.empty()) kept.places.push_back(mesh.places[i]);
  }
  return merged(kept, target);
}

}  // namespace

std::optional<JoinedMesh> closedByJoining(const Mesh& mesh) {
  const std::vector<Edge> open = unbalancedEdges(sortedEdges(mesh));
  if (open.empty()) return std::nullopt;
  std::vector<Corner> corners = cornersOf(mesh, open);
  const double size = boundsOf(mesh).size_m().maxCoeff();
  for (const double part : {kRoundingOfDoubles, kRoundingOfFloats}) {
    Joiner joiner(mesh, part * size);
    joiner.join(corners);
    if (joiner.count() == 0) continue;
    Mesh joined = joinedAt(mesh, joiner.target());
    if (!joined.triangles.empty() && unbalancedEdges(sortedEdges(joined)).empty())
      return JoinedMesh{std::move(joined), joiner.count(), joiner.farthest(), size};
  }
  return std::nullopt;
}

}  // namespace poinsot::geometry
