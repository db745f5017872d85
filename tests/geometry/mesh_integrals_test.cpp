// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh_integrals.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/mesh_samples.h"
#include "geometry/primitives.h"
#include "physics/residual.h"

namespace poinsot::geometry {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using physics::expectResidual;

double worst(const Matrix3d& measured, const Matrix3d& expected) {
  return (measured - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
}

Matrix3d boxInertia(const Vector3d& e) {
  const Vector3d s = e.cwiseAbs2();
  return Vector3d((s[1] + s[2]) / 12, (s[2] + s[0]) / 12, (s[0] + s[1]) / 12).asDiagonal();
}

// Expected moments: closed forms per unit mass, evaluated apart from the code.
TEST(MeshIntegrals, CubeTetrahedronAndLPrismAreExact) {
  expectResidual("cube", worst(integrals(cubeMesh(1)).inertiaPerMass_M, Matrix3d::Identity() / 6),
                 1e-15);  // measured 1.7e-16
  expectResidual("tetrahedron", worst(integrals(tetrahedronMesh(1)).inertiaPerMass_M, Matrix3d::Identity() / 20),
                 2e-15);  // measured 2.8e-16
  const MeshIntegrals prism = integrals(lPrismMesh({3, 2}, .5, .25));
  Matrix3d plate;
  plate << 0.298611111111111, 0.277777777777778, 0, 0.277777777777778, 0.854166666666667, 0, 0, 0,
      1.15277777777778;
  const double tt = .25 * .25 / 12;  // the thickness adds t²/12 to ∫z²
  plate.diagonal() += Vector3d(tt, tt, 0);
  expectResidual("L prism", worst(prism.inertiaPerMass_M, plate), 4e-15);  // measured 1.9e-15: 15 digits given
  expectResidual("its centre", (prism.centre_M - Vector3d(13. / 12, 7. / 12, 0)).norm(), 1e-15);  // measured 0
  expectResidual("its volume", std::abs(prism.volume_m3 - 2.25 * .25), 1e-15);                    // measured 0
}

/// Splits triangles of a surface at random points inside them.
Mesh resplit(Mesh mesh, Draw& draw) {
  for (int round = 0; round < 200; ++round) {
    const std::size_t at = draw.below(mesh.triangles.size());
    const auto [a, b, c] = mesh.triangles[at];
    const double u = draw.between(.2, .4), v = draw.between(.2, .4);
    const auto d = static_cast<std::uint32_t>(mesh.vertices_M.size());
    mesh.vertices_M.push_back(mesh.vertices_M[a] * (1 - u - v) + mesh.vertices_M[b] * u + mesh.vertices_M[c] * v);
    mesh.triangles[at] = {a, b, d};
    mesh.triangles.push_back({b, c, d});
    mesh.triangles.push_back({c, a, d});
  }
  return mesh;
}

TEST(MeshIntegrals, DoNotDependOnTheTriangulation) {
  Draw draw(5);
  for (const Mesh& mesh : {boxMesh({1.2, .9, .5}), lPrismMesh({3, 2}, .5, .25), dodecahedronMesh(1)}) {
    const MeshIntegrals once = integrals(mesh), again = integrals(resplit(mesh, draw));
    expectResidual("volume", std::abs(again.volume_m3 / once.volume_m3 - 1), 5e-15);         // measured 2.2e-16
    expectResidual("inertia", worst(again.inertiaPerMass_M, once.inertiaPerMass_M), 5e-15);  // measured 1.8e-16
    expectResidual("centre", (again.centre_M - once.centre_M).norm(), 5e-15);                // measured 5.1e-17
  }
}

TEST(MeshIntegrals, TurnWithTheBody) {
  const Matrix3d R = Eigen::AngleAxisd(.7, Vector3d(1, -2, .5).normalized()).toRotationMatrix();
  const Vector3d e(1.2, .9, .5), offset(3, -4, 5);
  const MeshIntegrals turned = integrals(transformed(boxMesh(e), R, offset));
  expectResidual("turned inertia", worst(turned.inertiaPerMass_M, R * boxInertia(e) * R.transpose()),
                 1e-14);                                                      // measured 2.3e-16
  expectResidual("turned centre", (turned.centre_M - offset).norm(), 3e-15);  // measured 0
}

TEST(MeshIntegrals, HaveNegativeVolumeForAFlippedMesh) {
  EXPECT_EQ(integrals(flipped(cubeMesh(1))).volume_m3, -integrals(cubeMesh(1)).volume_m3);
  EXPECT_LT(integrals(flipped(torusMesh(1.1, .35, 12))).volume_m3, 0);
}

// Integrals about a far origin would lose all digits. The offsets leave the corners exact.
TEST(MeshIntegrals, StayAccurateFarFromTheOrigin) {
  const Vector3d e(1.25, .875, .5);
  for (const double far : {1e3, 1e6, 0x1p40}) {
    const MeshIntegrals moved = integrals(transformed(boxMesh(e), Matrix3d::Identity(), {far, -far, far / 2}));
    expectResidual("far box", worst(moved.inertiaPerMass_M, boxInertia(e)), 1e-15);  // measured 1.4e-16
    EXPECT_EQ(moved.centre_M, Vector3d(far, -far, far / 2));
  }
}

// A speck moves the middle of the bounding box 500 lengths away from the body. The first pass loses six digits;
// the second pass recovers them.
TEST(MeshIntegrals, StayAccurateForABodyFarFromItsBoxCentre) {
  const double edge = 0x1p-10, speck = 0x1p-30;
  const MeshIntegrals both =
      integrals(joined(cubeMesh(edge), transformed(cubeMesh(speck), Matrix3d::Identity(), {1, 0, 0})));
  const double m = edge * edge * edge, n = speck * speck * speck, steiner = n / (m + n) * m / (m + n);
  Matrix3d expected = Matrix3d::Identity() * (m * edge * edge + n * speck * speck) / (6 * (m + n));
  expected.diagonal() += Vector3d(0, steiner, steiner);
  expectResidual("body at one end", worst(both.inertiaPerMass_M, expected), 1e-14);  // measured 1.7e-16
}

TEST(MeshIntegrals, NeitherOverflowNorVanish) {
  for (const double size : {1e-90, 1e90}) {
    const MeshIntegrals cube = integrals(cubeMesh(size));
    expectResidual("volume of another size", std::abs(cube.volume_m3 / (size * size * size) - 1),
                   2e-15);  // measured 0
    expectResidual("inertia of it", worst(cube.inertiaPerMass_M, Matrix3d::Identity() * (size * size / 6)),
                   2e-15);  // measured 0
  }
}

// Relative errors of an ellipsoid's moments from icospheres of 80, 320, 1280 and 5120 faces, computed apart from
// the code.
TEST(MeshIntegrals, ConvergeInSecondOrderForAnIcosphere) {
  const Vector3d s(1.3, .8, .5);
  const Matrix3d exact = boxInertia(s) * 12 / 5;
  const double expected[] = {-8.55e-2, -2.26e-2, -5.74e-3, -1.44e-3};
  for (int level = 1; level <= 4; ++level) {
    const Matrix3d I = integrals(ellipsoidMesh(s, level)).inertiaPerMass_M;
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(I(axis, axis) / exact(axis, axis) - 1, expected[level - 1], .005 * -expected[level - 1]);
  }
}

// Moments of solids of revolution per unit mass, from closed forms. The error of a mesh falls as 1/n².
TEST(MeshIntegrals, ConvergeToClosedFormsForSolidsOfRevolution) {
  const struct {
    const char* name;
    std::function<Mesh(int)> make;
    Vector3d centre;
    double across, along;
  } rows[] = {{"cylinder",
               [](int n) { return frustumMesh(.45, .45, -.85, .85, n); },
               {0, 0, 0},
               0.291458333333333,
               0.10125},
              {"tube", [](int n) { return tubeMesh(.45, .3, 1.7, n); }, {0, 0, 0}, 0.313958333333333, 0.14625},
              {"cone", [](int n) { return frustumMesh(.45, 0, 0, 1.7, n); }, {0, 0, .425}, 0.13875, 0.06075},
              {"torus", [](int n) { return torusMesh(1.1, .35, n); }, {0, 0, 0}, 0.6815625, 1.301875},
              {"hemisphere", [](int n) { return hemisphereMesh(.45, n); }, {0, 0, .16875}, 0.0525234375, 0.081},
              {"capsule", [](int n) { return capsuleMesh(.45, 1, n); }, {0, 0, 0}, 0.271130208333333, 0.09365625}};
  for (const auto& row : rows) {
    const auto error = [&](int n) {
      const MeshIntegrals mesh = integrals(row.make(n));
      EXPECT_LE((mesh.centre_M - row.centre).norm(), 4. / n / n) << row.name;
      return worst(mesh.inertiaPerMass_M, Vector3d(row.across, row.across, row.along).asDiagonal());
    };
    const double coarse = error(64), fine = error(128);
    EXPECT_LE(fine, 1.5e-3) << row.name;
    EXPECT_NEAR(fine / coarse, .25, .01) << row.name;  // slope 2
  }
}

}  // namespace
}  // namespace poinsot::geometry
