// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "core/expect.h"
#include "geometry/primitives.h"

namespace poinsot::geometry {
namespace {

using Eigen::Vector3d;

constexpr double kPhi = std::numbers::phi;

/// Adds the points (±x, ±y, ±z) with all combinations of signs, each point once.
void addSigns(std::vector<Vector3d>& points, const Vector3d& v) {
  for (int signs = 0; signs < 8; ++signs) {
    const Vector3d flip(signs & 1 ? -1 : 1, signs & 2 ? -1 : 1, signs & 4 ? -1 : 1);
    const Vector3d point = v.cwiseProduct(flip) + Vector3d::Zero();  // adding 0 turns -0 into 0
    if (std::ranges::find(points, point) == points.end()) points.push_back(point);
  }
}

std::vector<Vector3d> cyclic(const Vector3d& v) {
  std::vector<Vector3d> points;
  addSigns(points, v);
  addSigns(points, {v[2], v[0], v[1]});
  addSigns(points, {v[1], v[2], v[0]});
  return points;
}

std::vector<Vector3d> cubeCorners() { return cyclic({1, 1, 1}); }
std::vector<Vector3d> octahedronCorners() { return cyclic({1, 0, 0}); }
std::vector<Vector3d> icosahedronCorners() { return cyclic({0, kPhi, 1}); }
std::vector<Vector3d> dodecahedronCorners() {
  std::vector<Vector3d> points = cubeCorners();
  const std::vector<Vector3d> others = cyclic({0, 1 / kPhi, kPhi});
  points.insert(points.end(), others.begin(), others.end());
  return points;
}
std::vector<Vector3d> tetrahedronCorners() { return {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}; }

/// Returns the corners of the face with this normal, counter-clockwise. They are the corners farthest along the
/// normal.
std::vector<std::uint32_t> faceAlong(const std::vector<Vector3d>& corners, const Vector3d& normal) {
  constexpr double kSame = 1e-9;  // corners of a face differ only by rounding; other corners differ much more
  double farthest = 0;
  for (const Vector3d& corner : corners) farthest = std::max(farthest, corner.dot(normal));
  std::vector<std::uint32_t> face;
  for (std::uint32_t i = 0; i < corners.size(); ++i)
    if (corners[i].dot(normal) > farthest - kSame) face.push_back(i);
  // Angles are measured from the direction opposite to the first corner. The first corner itself would be at -pi
  // or +pi, depending on rounding. It gets the angle -4 instead, so that it always comes first.
  const std::uint32_t start = face[0];
  const Vector3d e1 = (corners[start] - normal * (farthest / normal.squaredNorm())).normalized();
  const Vector3d e2 = normal.normalized().cross(e1);
  std::ranges::sort(face, {}, [&](std::uint32_t i) {
    return i == start ? -4.0 : std::atan2(-corners[i].dot(e2), -corners[i].dot(e1));
  });
  return face;
}

/// Returns a polyhedron, scaled so that its edges have the length edge_m.
/// @param edge  distance between neighbouring points of `corners`
/// @param normals  one normal for each face, of any length
Mesh polyhedron(const std::vector<Vector3d>& corners, double edge, const std::vector<Vector3d>& normals,
                double edge_m) {
  Mesh mesh;
  for (const Vector3d& corner : corners) mesh.vertices_M.push_back(corner * (edge_m / edge));
  for (const Vector3d& normal : normals) {
    const std::vector<std::uint32_t> face = faceAlong(corners, normal);
    for (std::size_t i = 2; i < face.size(); ++i) mesh.triangles.push_back({face[0], face[i - 1], face[i]});
  }
  return mesh;
}

/// Splits each triangle into four. The middle of each edge becomes a new vertex, which is moved out to the unit
/// sphere.
Mesh subdivided(const Mesh& mesh) {
  Mesh result{mesh.vertices_M, {}};
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [entry, isNew] =
        middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(result.vertices_M.size()));
    if (isNew) result.vertices_M.push_back((mesh.vertices_M[a] + mesh.vertices_M[b]).normalized());
    return entry->second;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    result.triangles.insert(result.triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return result;
}

}  // namespace

Mesh tetrahedronMesh(double edge_m) {
  const std::vector<Vector3d> corners = tetrahedronCorners();
  std::vector<Vector3d> normals;
  for (const Vector3d& corner : corners) normals.push_back(-corner);
  return polyhedron(corners, 2 * std::numbers::sqrt2, normals, edge_m);
}

Mesh cubeMesh(double edge_m) { return polyhedron(cubeCorners(), 2, octahedronCorners(), edge_m); }

Mesh octahedronMesh(double edge_m) {
  return polyhedron(octahedronCorners(), std::numbers::sqrt2, cubeCorners(), edge_m);
}

Mesh dodecahedronMesh(double edge_m) {
  return polyhedron(dodecahedronCorners(), 2 / kPhi, icosahedronCorners(), edge_m);
}

Mesh icosahedronMesh(double edge_m) { return polyhedron(icosahedronCorners(), 2, dodecahedronCorners(), edge_m); }

Mesh boxMesh(const Vector3d& edges_m) { return transformed(cubeMesh(1), edges_m.asDiagonal().toDenseMatrix()); }

Mesh ellipsoidMesh(const Vector3d& semiAxes_m, int subdivisions) {
  POINSOT_EXPECT(0 <= subdivisions && subdivisions <= 8);  // 8 subdivisions give 1.3 million triangles
  Mesh mesh = icosahedronMesh(1);
  for (Vector3d& v : mesh.vertices_M) v.normalize();
  for (int i = 0; i < subdivisions; ++i) mesh = subdivided(mesh);
  return transformed(std::move(mesh), semiAxes_m.asDiagonal().toDenseMatrix());
}

}  // namespace poinsot::geometry
