// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/expect.h"
#include "geometry/primitives.h"

namespace poinsot::geometry {
namespace {

constexpr double kPi = std::numbers::pi;

/// Vertices of one corner of the outline: a ring around the axis, or a single vertex on the axis.
struct Ring {
  std::uint32_t first = 0;
  std::uint32_t count = 1;

  std::uint32_t at(std::uint32_t step) const { return first + step % count; }
};

Ring addRing(Mesh& mesh, const Vector2& corner_rz, int segments) {
  const Ring ring{static_cast<std::uint32_t>(mesh.vertices_M.size()),
                  corner_rz[0] == 0 ? 1 : static_cast<std::uint32_t>(segments)};
  for (std::uint32_t i = 0; i < ring.count; ++i) {
    const double angle = 2 * kPi * i / ring.count;
    mesh.vertices_M.emplace_back(corner_rz[0] * std::cos(angle), corner_rz[0] * std::sin(angle), corner_rz[1]);
  }
  return ring;
}

/// Adds the triangles between two neighbouring rings. If one ring is a single vertex, each step adds one triangle
/// instead of two.
void addBand(Mesh& mesh, const Ring& low, const Ring& high, int segments) {
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(segments); ++i) {
    if (low.count > 1) mesh.triangles.push_back({low.at(i), low.at(i + 1), high.at(i + 1)});
    if (high.count > 1) mesh.triangles.push_back({low.at(i), high.at(i + 1), high.at(i)});
  }
}

void addArc(std::vector<Vector2>& outline, const Vector2& centre, double radius, double from, double to,
            int steps) {
  for (int i = 0; i <= steps; ++i) {
    const double angle = from + (to - from) * i / steps;
    outline.emplace_back(centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle));
  }
}

/// Returns the number of segments of a quarter circle, if a full circle has `segments`. Rounds up.
int quarter(int segments) { return (segments + 3) / 4; }

}  // namespace

Mesh turnedMesh(std::span<const Vector2> outline_rz, int segments) {
  POINSOT_EXPECT(segments >= 3 && outline_rz.size() >= 3);
  Mesh mesh;
  std::vector<Ring> rings;
  for (const Vector2& corner : outline_rz) {
    POINSOT_EXPECT(corner[0] >= 0);
    rings.push_back(addRing(mesh, corner, segments));
  }
  for (std::size_t i = 0; i < rings.size(); ++i) addBand(mesh, rings[i], rings[(i + 1) % rings.size()], segments);
  return mesh;
}

Mesh torusMesh(double radius_m, double tubeRadius_m, int segments) {
  POINSOT_EXPECT(0 < tubeRadius_m && tubeRadius_m < radius_m);
  std::vector<Vector2> outline;
  addArc(outline, {radius_m, 0}, tubeRadius_m, 0, 2 * kPi, segments);
  outline.pop_back();  // the last point repeats the first
  return turnedMesh(outline, segments);
}

Mesh hemisphereMesh(double radius_m, int segments) {
  std::vector<Vector2> outline{{0, 0}};
  addArc(outline, {0, 0}, radius_m, 0, kPi / 2, quarter(segments));
  outline.back() = {0, radius_m};  // puts the end of the arc exactly on the axis
  return turnedMesh(outline, segments);
}

Mesh frustumMesh(double lowRadius_m, double highRadius_m, double low_m, double high_m, int segments) {
  POINSOT_EXPECT(low_m < high_m && (lowRadius_m > 0 || highRadius_m > 0));
  std::vector<Vector2> outline{{0, low_m}};
  if (lowRadius_m > 0) outline.emplace_back(lowRadius_m, low_m);
  if (highRadius_m > 0) outline.emplace_back(highRadius_m, high_m);
  outline.emplace_back(0, high_m);
  return turnedMesh(outline, segments);
}

Mesh tubeMesh(double radius_m, double innerRadius_m, double height_m, int segments) {
  POINSOT_EXPECT(0 < innerRadius_m && innerRadius_m < radius_m);
  const double half = height_m / 2;
  return turnedMesh(std::array<Vector2, 4>{Vector2(innerRadius_m, -half), Vector2(radius_m, -half),
                                           Vector2(radius_m, half), Vector2(innerRadius_m, half)},
                    segments);
}

Mesh capsuleMesh(double radius_m, double height_m, int segments) {
  const double half = height_m / 2;
  std::vector<Vector2> outline;
  addArc(outline, {0, -half}, radius_m, -kPi / 2, 0, quarter(segments));
  addArc(outline, {0, half}, radius_m, 0, kPi / 2, quarter(segments));
  outline.front() = {0, -half - radius_m};
  outline.back() = {0, half + radius_m};
  return turnedMesh(outline, segments);
}

}  // namespace poinsot::geometry
