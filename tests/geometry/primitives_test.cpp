// SPDX-License-Identifier: Apache-2.0
#include "geometry/primitives.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>
#include <string>

#include "geometry/mesh_integrals.h"
#include "geometry/mesh_samples.h"
#include "physics/residual.h"

namespace poinsot::geometry {
namespace {

using Eigen::Vector3d;
using physics::expectResidual;

constexpr double kPi = std::numbers::pi;

int eulerCharacteristic(const Mesh& mesh) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const Mesh::Triangle& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) edges.insert(std::minmax(t[i], t[(i + 1) % 3]));
  return static_cast<int>(mesh.vertices_M.size()) - static_cast<int>(edges.size()) +
         static_cast<int>(mesh.triangles.size());
}

Vector3d areaVector(const Mesh& mesh, const Mesh::Triangle& t) {
  const Vector3d &a = mesh.vertices_M[t[0]], &b = mesh.vertices_M[t[1]], &c = mesh.vertices_M[t[2]];
  return (b - a).cross(c - a) / 2;
}

TEST(Primitives, AreClosedAndFaceOutward) {
  for (const int segments : {3, 4, 17, 64})
    for (const Sample& sample : primitives(segments)) {
      EXPECT_NO_THROW(checkClosed(sample.mesh)) << sample.name;
      Vector3d sum = Vector3d::Zero();
      double area = 0;
      for (const Mesh::Triangle& t : sample.mesh.triangles) {
        sum += areaVector(sample.mesh, t);
        area += areaVector(sample.mesh, t).norm();
        EXPECT_GT(areaVector(sample.mesh, t).norm(), 1e-6) << sample.name << ": a triangle without area";
      }
      expectResidual(sample.name, sum.norm() / area, 1e-14);  // measured 2.4e-15, the sum of 2000 rounded areas
    }
}

TEST(Primitives, HaveTheEulerCharacteristicOfTheirShape) {
  for (const Sample& sample : primitives(24)) {
    const bool ring = std::string(sample.name) == "torus" || std::string(sample.name) == "tube";
    EXPECT_EQ(eulerCharacteristic(sample.mesh), ring ? 0 : 2) << sample.name;
    EXPECT_EQ(welded(sample.mesh).vertices_M.size(), sample.mesh.vertices_M.size()) << sample.name;
  }
}

TEST(Primitives, FaceOutwardIfConvex) {
  for (const Sample& sample : primitives(24)) {
    const std::string name = sample.name;
    if (name == "torus" || name == "tube" || name == "prism") continue;
    const Vector3d middle = integrals(sample.mesh).centre_M;
    for (const Mesh::Triangle& t : sample.mesh.triangles)
      EXPECT_GT(areaVector(sample.mesh, t).dot(sample.mesh.vertices_M[t[0]] - middle), 0) << name;
  }
}

// Volumes of the regular polyhedra of edge 1: Coxeter, Regular Polytopes, table I.
TEST(Primitives, RegularPolyhedraHaveTheTabulatedVolumes) {
  const double root5 = std::sqrt(5.0);
  const struct {
    Mesh mesh;
    double volume;
    std::size_t vertices;
  } rows[] = {{tetrahedronMesh(2), std::sqrt(2.0) / 12, 4},
              {cubeMesh(2), 1, 8},
              {octahedronMesh(2), std::sqrt(2.0) / 3, 6},
              {dodecahedronMesh(2), (15 + 7 * root5) / 4, 20},
              {icosahedronMesh(2), 5 * (3 + root5) / 12, 12}};
  for (const auto& row : rows) {
    EXPECT_EQ(row.mesh.vertices_M.size(), row.vertices);
    expectResidual("volume of a polyhedron", std::abs(integrals(row.mesh).volume_m3 / (8 * row.volume) - 1),
                   2e-15);  // measured 3.3e-16
    double least = 10;
    for (std::size_t i = 1; i < row.vertices; ++i)
      least = std::min(least, (row.mesh.vertices_M[i] - row.mesh.vertices_M[0]).norm());
    EXPECT_NEAR(least, 2, 1e-15);
  }
}

/// Expects that twice the segments leave a quarter of the error in volume.
void expectSecondOrder(const std::function<Mesh(int)>& make, double volume) {
  const auto error = [&](int segments) { return integrals(make(segments)).volume_m3 / volume - 1; };
  EXPECT_LT(error(64), 0) << "inscribed";
  EXPECT_GT(error(64), -0.01);
  expectResidual("ratio of errors less 1/4", std::abs(error(128) / error(64) - .25), .002);  // measured 3.1e-4
}

TEST(Primitives, VolumesConvergeInSecondOrder) {
  const double r = .45, h = 1.7, R = 1.1, a = .35;
  expectSecondOrder([&](int n) { return hemisphereMesh(r, n); }, 2 * kPi / 3 * r * r * r);
  expectSecondOrder([&](int n) { return frustumMesh(r, 0, 0, h, n); }, kPi / 3 * r * r * h);
  expectSecondOrder([&](int n) { return frustumMesh(r, .3, 0, h, n); }, kPi / 3 * h * (r * r + .3 * r + .09));
  expectSecondOrder([&](int n) { return tubeMesh(r, .3, h, n); }, kPi * h * (r * r - .09));
  expectSecondOrder([&](int n) { return capsuleMesh(r, h, n); }, kPi * r * r * (h + 4 * r / 3));
  expectSecondOrder([&](int n) { return torusMesh(R, a, n); }, 2 * kPi * kPi * R * a * a);
}

TEST(Primitives, VerticesLieOnTheExactSurface) {
  for (const Vector3d& v : ellipsoidMesh({1.3, .8, .5}, 4).vertices_M)
    EXPECT_NEAR(v.cwiseQuotient(Vector3d(1.3, .8, .5)).norm(), 1, 4e-16);
  for (const Vector3d& v : torusMesh(1.1, .35, 31).vertices_M)
    EXPECT_NEAR(std::hypot(std::hypot(v[0], v[1]) - 1.1, v[2]), .35, 4e-16);
}

TEST(Primitives, ThrowLogicErrorsForBrokenPreconditions) {
  EXPECT_THROW(torusMesh(1, 1, 8), std::logic_error);
  EXPECT_THROW(tubeMesh(1, 1, 1, 8), std::logic_error);
  EXPECT_THROW(frustumMesh(1, 0, 1, 1, 8), std::logic_error);
  EXPECT_THROW(hemisphereMesh(1, 2), std::logic_error);
  EXPECT_THROW(ellipsoidMesh({1, 1, 1}, 9), std::logic_error);
  EXPECT_THROW(lPrismMesh({1, 1}, 1, 1), std::logic_error);
}

}  // namespace
}  // namespace poinsot::geometry
