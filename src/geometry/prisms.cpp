// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "core/expect.h"
#include "geometry/primitives.h"

namespace poinsot::geometry {

namespace {

/// Returns whether the edge from `from` to `to` runs counter-clockwise around the first corner of the outline. An
/// edge on a line through the first corner is accepted, too.
bool firstSees(std::span<const Vector2> outline_xy, const Vector2& from, const Vector2& to) {
  const Vector2 a = from - outline_xy[0], b = to - outline_xy[0];
  return a[0] * b[1] - a[1] * b[0] >= 0;
}

}  // namespace

Mesh prismMesh(std::span<const Vector2> outline_xy, double thickness_m) {
  POINSOT_EXPECT(outline_xy.size() >= 3);
  for (std::size_t i = 2; i < outline_xy.size(); ++i)
    POINSOT_EXPECT(firstSees(outline_xy, outline_xy[i - 1], outline_xy[i]));
  const auto count = static_cast<std::uint32_t>(outline_xy.size());
  Mesh mesh;
  for (const double z : {-thickness_m / 2, thickness_m / 2})
    for (const Vector2& corner : outline_xy) mesh.vertices_M.emplace_back(corner[0], corner[1], z);
  for (std::uint32_t i = 2; i < count; ++i) {
    mesh.triangles.push_back({0, i, i - 1});
    mesh.triangles.push_back({count, count + i - 1, count + i});
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    mesh.triangles.push_back({i, next, count + next});
    mesh.triangles.push_back({i, count + next, count + i});
  }
  return mesh;
}

Mesh lPrismMesh(const Vector2& edges_m, double arm_m, double thickness_m) {
  POINSOT_EXPECT(0 < arm_m && arm_m < edges_m.minCoeff());
  const double x = edges_m[0], y = edges_m[1];
  return prismMesh(std::array<Vector2, 6>{Vector2(0, 0), Vector2(x, 0), Vector2(x, arm_m), Vector2(arm_m, arm_m),
                                          Vector2(arm_m, y), Vector2(0, y)},
                   thickness_m);
}

}  // namespace poinsot::geometry
