// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "geometry/mesh_integrals.h"
#include "geometry/primitives.h"
#include "physics/mass_properties.h"
#include "physics/mass_testing.h"
#include "physics/residual.h"

// Formulas of solids are compared with the same shapes cut into triangles and points.

namespace poinsot::physics {
namespace {

using Eigen::Vector3d;
using geometry::Mesh;

/// Returns the relative difference in moments and volume between a solid and its mesh.
double meshError(const Solid& solid, const Mesh& mesh) {
  const geometry::MeshIntegrals cutUp = geometry::integrals(mesh);
  const MassProperties whole = massProperties(solid, 1);
  EXPECT_LE((whole.centre_B() - cutUp.centre_M).norm(), .005);
  return std::max(
      (whole.inertia_B() - cutUp.inertiaPerMass_M).cwiseAbs().maxCoeff() / whole.inertia_B().maxCoeff(),
      std::abs(cutUp.volume_m3 / volume(solid) - 1));
}

TEST(SolidApproximation, FlatSolidsEqualTheirMeshes) {
  using namespace geometry;
  const Mesh hollow = joined(boxMesh({1.2, .9, .5}), flipped(boxMesh({1.1, .8, .4})));
  const struct {
    const char* name;
    Solid solid;
    Mesh mesh;
  } rows[] = {{"box", Box{{1.2, .9, .5}}, boxMesh({1.2, .9, .5})},
              {"hollow box", HollowBox{{1.2, .9, .5}, .05}, hollow},
              {"tetrahedron", Polyhedron{PolyhedronKind::kTetrahedron, 1.7}, tetrahedronMesh(1.7)},
              {"cube", Polyhedron{PolyhedronKind::kCube, 1.7}, cubeMesh(1.7)},
              {"octahedron", Polyhedron{PolyhedronKind::kOctahedron, 1.7}, octahedronMesh(1.7)},
              {"dodecahedron", Polyhedron{PolyhedronKind::kDodecahedron, 1.7}, dodecahedronMesh(1.7)},
              {"icosahedron", Polyhedron{PolyhedronKind::kIcosahedron, 1.7}, icosahedronMesh(1.7)}};
  for (const auto& row : rows)
    expectResidual(row.name, meshError(row.solid, row.mesh), 3e-15);  // measured 6.7e-16
}

TEST(SolidApproximation, MeshesConvergeToRoundSolids) {
  using namespace geometry;
  const struct {
    const char* name;
    Solid solid;
    std::function<Mesh(int)> make;
  } rows[] = {{"cylinder", Cylinder{.45, 1.7}, [](int n) { return frustumMesh(.45, .45, -.85, .85, n); }},
              {"tube", Cylinder{.45, 1.7, .3}, [](int n) { return tubeMesh(.45, .3, 1.7, n); }},
              {"cone", Cone{.45, 1.7}, [](int n) { return frustumMesh(.45, 0, -1.7 / 4, 1.7 * 3 / 4, n); }},
              {"torus", Torus{1.1, .35}, [](int n) { return torusMesh(1.1, .35, n); }},
              {"hemisphere", Hemisphere{.45}, [](int n) { return hemisphereMesh(.45, n); }},
              {"capsule", Capsule{.45, 1}, [](int n) { return capsuleMesh(.45, 1, n); }},
              {"thick shell", Sphere{.45, .3}, [](int n) {
                 const int level = n == 64 ? 3 : 4;  // twice as fine
                 return joined(ellipsoidMesh({.45, .45, .45}, level), flipped(ellipsoidMesh({.3, .3, .3}, level)));
               }}};
  for (const auto& row : rows) {
    const double coarse = meshError(row.solid, row.make(64)), fine = meshError(row.solid, row.make(128));
    expectResidual(row.name, fine, 3e-3);  // measured 2.2e-3
    EXPECT_NEAR(fine / coarse, .25, .01) << row.name;
  }
}

/// Returns the moments per mass of a surface. Each triangle's area A is spread over its corners (A/12 each) and
/// its middle (9 A/12), which is exact for squares.
Vector3d surfaceMoments(const Mesh& mesh, const std::function<bool(const Vector3d&)>& isPart) {
  Vector3d second = Vector3d::Zero(), first = Vector3d::Zero();
  double area = 0;
  for (const Mesh::Triangle& t : mesh.triangles) {
    const std::array corners{mesh.vertices_M[t[0]], mesh.vertices_M[t[1]], mesh.vertices_M[t[2]]};
    const Vector3d middle = (corners[0] + corners[1] + corners[2]) / 3;
    if (!isPart(middle)) continue;
    const double a = (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm() / 2;
    area += a;
    first += a * middle;
    second += 9 * a / 12 * middle.cwiseAbs2();
    for (const Vector3d& corner : corners) second += a / 12 * corner.cwiseAbs2();
  }
  const Vector3d squares = second / area - (first / area).cwiseAbs2();
  return {squares[1] + squares[2], squares[2] + squares[0], squares[0] + squares[1]};
}

TEST(SolidApproximation, TrianglesConvergeToShells) {
  using namespace geometry;
  const auto all = [](const Vector3d&) { return true; };
  const auto side = [](const Vector3d& r) { return std::abs(r[2]) < .85 - 1e-9; };
  const auto slope = [](const Vector3d& r) { return r[2] > 1e-9; };
  const struct {
    const char* name;
    Solid solid;
    std::function<Mesh(int)> make;
    std::function<bool(const Vector3d&)> isPart;
  } rows[] = {
      {"cylinder shell", CylinderShell{.45, 1.7}, [](int n) { return frustumMesh(.45, .45, -.85, .85, n); }, side},
      {"cone shell", ConeShell{.45, 1.7}, [](int n) { return frustumMesh(.45, 0, 0, 1.7, n); }, slope},
      {"torus shell", TorusShell{1.1, .35}, [](int n) { return torusMesh(1.1, .35, n); }, all},
      {"sphere shell", SphereShell{.45},
       [](int n) {
         return ellipsoidMesh({.45, .45, .45}, n == 64 ? 3 : 4);
       },
       all},
      {"disc", Disc{.5}, [](int n) { return frustumMesh(.5, .5, 0, 1, n); },
       [](const Vector3d& r) { return r[2] == 0; }}};
  for (const auto& row : rows) {
    const Vector3d exact = massProperties(row.solid, 1).inertia_B().diagonal();
    const double coarse = relative(surfaceMoments(row.make(64), row.isPart), exact),
                 fine = relative(surfaceMoments(row.make(128), row.isPart), exact);
    expectResidual(row.name, fine, 3e-3);  // measured 1.4e-3
    EXPECT_NEAR(fine / coarse, .25, .01) << row.name;
  }
  const Mesh plate =
      prismMesh(std::array<geometry::Vector2, 4>{geometry::Vector2(-1.5, -1), geometry::Vector2(1.5, -1),
                                                 geometry::Vector2(1.5, 1), geometry::Vector2(-1.5, 1)},
                2);
  const auto bottom = [](const Vector3d& r) { return r[2] == -1; };
  EXPECT_LE(relative(surfaceMoments(plate, bottom), massProperties(Plate{{3, 2}}, 1).inertia_B().diagonal()),
            1e-15);
}

// The shell between two similar ellipsoids is the limit of their difference.
TEST(SolidApproximation, ThinShellsConvergeToTheEllipsoidShell) {
  const Vector3d axes(1.3, .8, .5);
  const auto thick = [&](double growth) {
    const Ellipsoid outer{axes * (1 + growth)}, inner{axes};
    const double outer_kg = volume(outer), inner_kg = volume(inner);
    return Vector3d(
        (massProperties(outer, outer_kg).inertia_B() - massProperties(inner, inner_kg).inertia_B()).diagonal() /
        (outer_kg - inner_kg));
  };
  const Vector3d exact = massProperties(EllipsoidShell{axes}, 1).inertia_B().diagonal();
  const Vector3d extrapolated = 2 * thick(1e-4) - thick(2e-4);             // without the first order
  expectResidual("ellipsoid shell", relative(extrapolated, exact), 1e-7);  // measured 1.3e-8
}

TEST(SolidApproximation, PointsConvergeToHoopAndRod) {
  constexpr int kPoints = 1000;
  Vector3d hoop = Vector3d::Zero(), rod = Vector3d::Zero();
  for (int i = 0; i < kPoints; ++i) {
    const double angle = 2 * M_PI * i / kPoints, x = 3 * ((i + .5) / kPoints - .5);
    hoop += Vector3d(std::pow(.5 * std::sin(angle), 2), std::pow(.5 * std::cos(angle), 2), .25) / kPoints;
    rod += Vector3d(0, x * x, x * x) / kPoints;
  }
  expectResidual("hoop", relative(massProperties(Hoop{.5}, 1).inertia_B().diagonal(), hoop),
                 1e-14);  // measured 6.7e-16
  expectResidual("rod", relative(massProperties(Rod{3}, 1).inertia_B().diagonal(), rod),
                 2e-6);  // measured 1e-6 = 1/1000²
}

}  // namespace
}  // namespace poinsot::physics
