// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/error.h"
#include "physics/mass_properties.h"
#include "physics/mass_testing.h"
#include "physics/principal_axes.h"
#include "physics/residual.h"

namespace poinsot::physics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

struct Row {
  const char* name;
  Solid solid;
  Vector3d moments;  ///< about the centre of mass, per unit mass, m²
  Vector3d centre{0, 0, 0};
};

constexpr double kGolden = 1.6180339887498948482;

// Expected values are computed apart from the code to 15 digits; those of plate, disc, hoop and rod by hand from
// textbook formulas.
std::vector<Row> table() {
  return {
      {"ellipsoid", Ellipsoid{{1.3, .8, .5}}, {0.178, 0.388, 0.466}},
      {"ellipsoid shell", EllipsoidShell{{1.3, .8, .5}}, {0.89 / 3, 1.94 / 3, 2.33 / 3}},
      {"box", Box{{.205, .135, .03}}, {0.00159375, 0.0429250 / 12, 0.060250 / 12}},
      {"hollow box", HollowBox{{1.2, .9, .5}, .05}, {0.128900709219858, 0.190762411347518, 0.24991134751773}},
      {"plate", Plate{{3, 2}}, {4. / 12, 9. / 12, 13. / 12}},
      {"cylinder", Cylinder{.45, 1.7}, {3.4975 / 12, 3.4975 / 12, 0.10125}},
      {"tube", Cylinder{.45, 1.7, .3}, {3.7675 / 12, 3.7675 / 12, 0.14625}},
      {"cylinder shell", CylinderShell{.45, 1.7}, {4.105 / 12, 4.105 / 12, 0.2025}},
      {"disc", Disc{.5}, {.0625, .0625, .125}},
      {"hoop", Hoop{.5}, {.125, .125, .25}},
      {"rod", Rod{3}, {0, .75, .75}},
      {"cone", Cone{.45, 1.7}, {0.13875, 0.13875, 0.06075}},
      {"cone shell", ConeShell{.45, 1.7}, {7.6025 / 36, 7.6025 / 36, 0.10125}},
      {"torus", Torus{1.1, .35}, {0.6815625, 0.6815625, 1.301875}},
      {"torus shell", TorusShell{1.1, .35}, {0.758125, 0.758125, 1.39375}},
      {"sphere", Sphere{.45}, {.081, .081, .081}},
      {"thick shell", Sphere{.45, .3}, Vector3d::Constant(0.0999473684210526)},
      {"sphere shell", SphereShell{.45}, {.135, .135, .135}},
      {"hemisphere", Hemisphere{.45}, {0.0525234375, 0.0525234375, 0.081}, {0, 0, .16875}},
      {"capsule", Capsule{.45, 1}, {0.271130208333333, 0.271130208333333, 0.09365625}},
      {"tetrahedron", Polyhedron{PolyhedronKind::kTetrahedron, 1}, Vector3d::Constant(.05)},
      {"cube", Polyhedron{PolyhedronKind::kCube, 1}, Vector3d::Constant(1. / 6)},
      {"octahedron", Polyhedron{PolyhedronKind::kOctahedron, 1}, Vector3d::Constant(.1)},
      {"dodecahedron", Polyhedron{PolyhedronKind::kDodecahedron, 1}, Vector3d::Constant(0.607355503741639)},
      {"icosahedron", Polyhedron{PolyhedronKind::kIcosahedron, 1}, Vector3d::Constant((kGolden + 1) / 10)},
      {"T-handle",
       THandle{3, .2, 1.5, .2},
       {0.279722222222222, 0.513333333333333, 0.773055555555556},
       {0, .95 / 3, 0}},
      {"wing nut",
       WingNut{.5, 1, {1.2, .2, .9}, 1.1, .3},
       {0.139823164926434, 0.610597655336842, 0.553783298426565},
       {0, 0, 0.10645654305763}},
      {"racket",
       Racket{.68, .26},
       Vector3d(0.0014365, 0.0133167424242424, 0.0147532424242424) / .33,
       {0.385151515151515 - .55, 0, 0}},  // distance of the balance from the butt, which is at x = -0.55
  };
}

TEST(Solid, MomentsAndCentresMatchTextbookFormulas) {
  for (const Row& row : table()) {
    const MassProperties whole = massProperties(row.solid, 1);
    const Matrix3d& I = whole.inertia_B();
    expectResidual(row.name, relative(I.diagonal(), row.moments), 3e-15);  // measured 2e-15: 15 digits given
    EXPECT_LE((whole.centre_B() - row.centre).norm(), 2e-15) << row.name;
    EXPECT_TRUE(PrincipalAxes(I + Matrix3d::Identity()).aligned()) << row.name;  // no axis is invented
    EXPECT_TRUE(I.isDiagonal(0)) << row.name;
    EXPECT_EQ(whole.mass_kg(), 1) << row.name;
  }
}

TEST(Solid, LPlateHasItsLeastAxisAt22AndAHalfDegrees) {
  const MassProperties plate = massProperties(LPlate{{3, 2}, .5}, 1);
  Matrix3d expected;
  expected << 0.298611111111111, 0.277777777777778, 0, 0.277777777777778, 0.854166666666667, 0, 0, 0,
      1.15277777777778;
  expectResidual("tensor", (plate.inertia_B() - expected).cwiseAbs().maxCoeff(),
                 4e-15);  // measured 2.2e-15: 15 digits given
  expectResidual("centre", (plate.centre_B() - Vector3d(13. / 12, 7. / 12, 0)).norm(), 1e-15);  // measured 0
  const PrincipalAxes axes(plate.inertia_B());
  expectResidual(
      "moments",
      relative(axes.moments().values(), Vector3d(0.183551788229696, 0.969225989548082, 1.15277777777778)),
      3e-15);  // measured 1.9e-15
  const Vector3d least = axes.toB(Vector3d::UnitX());
  expectResidual("direction", std::abs(std::atan2(least[1], least[0]) + M_PI / 8), 1e-15);  // measured 5.6e-17
  EXPECT_EQ(axes.toB(Vector3d::UnitZ()), Vector3d::UnitZ());
}

TEST(Solid, MomentsScaleWithTheMass) {
  for (const Row& row : table()) {
    const MassProperties one = massProperties(row.solid, 1), many = massProperties(row.solid, 12.5);
    EXPECT_EQ(many.mass_kg(), 12.5);
    EXPECT_LE(relative(many.inertia_B().diagonal(), 12.5 * one.inertia_B().diagonal()), 1e-15) << row.name;
  }
}

TEST(Solid, ThinWallsKeepFullAccuracy) {
  const double wall = 1e-9;
  const Vector3d e(1.2, .9, .5);
  const double ab = e[0] * e[1], bc = e[1] * e[2], ca = e[2] * e[0];  // the six faces as plates
  const double area = 2 * (ab + bc + ca);
  Vector3d squares;  // ∫x² etc. over the faces, per area
  squares[0] = (2 * ab + 2 * ca) * e[0] * e[0] / 12 + 2 * bc * e[0] * e[0] / 4;
  squares[1] = (2 * ab + 2 * bc) * e[1] * e[1] / 12 + 2 * ca * e[1] * e[1] / 4;
  squares[2] = (2 * bc + 2 * ca) * e[2] * e[2] / 12 + 2 * ab * e[2] * e[2] / 4;
  squares /= area;
  const Vector3d faces(squares[1] + squares[2], squares[2] + squares[0], squares[0] + squares[1]);
  expectResidual("hollow box", relative(massProperties(HollowBox{e, wall}, 1).inertia_B().diagonal(), faces),
                 1e-8);
  EXPECT_NEAR(volume(HollowBox{e, wall}) / (area * wall), 1, 1e-8);
  EXPECT_NEAR(massProperties(Sphere{1, 1 - 1e-12}, 1).inertia_B()(0, 0), 2. / 3, 1e-12);
  EXPECT_NEAR(volume(Sphere{1, 1 - 0x1p-40}) / (4 * M_PI * 0x1p-40), 1, 2e-12);
  EXPECT_NEAR(volume(Cylinder{1, 1, 1 - 0x1p-40}) / (2 * M_PI * 0x1p-40), 1, 2e-12);
}

TEST(Solid, PartsOfACompositeAddUpToTheWhole) {
  for (const Solid& solid : std::vector<Solid>{LPlate{{3, 2}, .5}, THandle{3, .2, 1.5, .2}, Racket{.68, .26},
                                               WingNut{.5, 1, {1.2, .2, .9}, 1.1, .3}}) {
    const std::vector<SolidPart> parts = partsOf(solid, 4);
    EXPECT_GT(parts.size(), 1U);
    std::vector<MassProperties> pieces;
    for (const SolidPart& part : parts) pieces.push_back(massProperties(part));
    const MassProperties sum = combined(pieces), whole = massProperties(solid, 4);
    EXPECT_NEAR(sum.mass_kg(), 4, 1e-15);
    EXPECT_LE((sum.inertia_B() - whole.inertia_B()).cwiseAbs().maxCoeff() / whole.inertia_B().maxCoeff(), 1e-15);
    EXPECT_LE((sum.centre_B() - whole.centre_B()).norm(), 4e-16);
  }
  const std::vector<SolidPart> alone = partsOf(Capsule{.45, 1}, 4);
  ASSERT_EQ(alone.size(), 1U);
  EXPECT_EQ(alone[0].mass_kg, 4);
}

TEST(Solid, ARacketIsALamina) {
  const Vector3d I = massProperties(Racket{.68, .26}, .33).inertia_B().diagonal();
  EXPECT_NEAR(I[2] / (I[0] + I[1]), 1, 3e-16);
  EXPECT_NEAR(massProperties(Racket{.68, .26}, .33).centre_B()[0] + .55, 0.385151515152, 1e-12);  // from the butt
}

TEST(Solid, HasTheVolumesOfCompositesAndThinBodies) {
  EXPECT_NEAR(volume(THandle{3, .2, 1.5, .2}), M_PI * .04 * 4.5, 1e-15);
  EXPECT_NEAR(volume(WingNut{.5, 1, {1.2, .2, .9}, 1.1, .3}), M_PI * .25 + .432, 3e-16);
  for (const Solid& thin : std::vector<Solid>{Plate{{3, 2}}, EllipsoidShell{{1, 2, 3}}, SphereShell{1}, Disc{1},
                                              Hoop{1}, Rod{1}, CylinderShell{1, 1}, ConeShell{1, 1},
                                              TorusShell{2, 1}, LPlate{{3, 2}, .5}, Racket{.68, .26}})
    EXPECT_EQ(volume(thin), 0);
  EXPECT_NEAR(volume(Ellipsoid{{1, 2, 3}}), 8 * M_PI, 1e-14);
}

std::string verdict(const Solid& solid, double mass_kg = 1) {
  EXPECT_EQ(refusal([&] { partsOf(solid, mass_kg); }), refusal([&] { massProperties(solid, mass_kg); }));
  return refusal([&] { massProperties(solid, mass_kg); });
}

TEST(Solid, RejectsLengthsThatAreNotPositive) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(verdict(Sphere{1}, 0), "mass must be positive and finite, got 0");
  EXPECT_EQ(verdict(Box{{1, -1, 1}}), "edge of the box must be positive and finite, got -1");
  EXPECT_EQ(verdict(Plate{{1, 0}}), "edge of the plate must be positive and finite, got 0");
  EXPECT_EQ(verdict(Ellipsoid{{1, nan, 1}}), "semi-axis of the ellipsoid must be positive and finite, got nan");
  EXPECT_EQ(verdict(Cylinder{0, 1}), "radius of the cylinder must be positive and finite, got 0");
  EXPECT_EQ(verdict(Cone{1, 0}), "height of the cone must be positive and finite, got 0");
  EXPECT_EQ(verdict(Capsule{1, -2}), "height of the capsule's cylinder must be positive and finite, got -2");
  EXPECT_EQ(verdict(Polyhedron{PolyhedronKind::kCube, 0}),
            "edge of the polyhedron must be positive and finite, got 0");
  EXPECT_EQ(verdict(THandle{1, 1, 1, 0}), "radius of the T-handle's shaft must be positive and finite, got 0");
  EXPECT_EQ(verdict(Racket{.25, .25}), "length of the racket minus its width must be positive and finite, got 0");
  EXPECT_THROW(volume(Rod{0}), core::Error);
}

TEST(Solid, RejectsContradictoryLengths) {
  EXPECT_EQ(verdict(HollowBox{{1, 2, 3}, .5}),
            "two walls of the hollow box must be less than its least edge 1, got a wall of 0.5");
  EXPECT_EQ(verdict(Sphere{1, 1}),
            "inner radius of the sphere must be at least 0 and less than its radius 1, got 1");
  EXPECT_EQ(verdict(Cylinder{1, 1, -.5}),
            "inner radius of the cylinder must be at least 0 and less than its radius 1, got -0.5");
  EXPECT_EQ(verdict(Torus{1, 1}), "tube radius of the torus must be less than its radius 1, got 1");
  EXPECT_EQ(verdict(LPlate{{3, 2}, 2}), "arm width of the L plate must be less than its least edge 2, got 2");
  EXPECT_EQ(verdict(WingNut{.5, 1, {1.2, .2, .9}, 1, .3}),
            "wings of the wing nut must not enter its hub of radius 0.5, got an inner edge at 0.4");
}

TEST(Solid, RejectsAnUnknownKindOfPolyhedron) {
  const Polyhedron none{PolyhedronKind(9), 1};
  EXPECT_EQ(refusal([&] { massProperties(none, 1); }), "kind of the polyhedron must be 0 to 4, got 9");
  EXPECT_EQ(refusal([&] { volume(none); }), "kind of the polyhedron must be 0 to 4, got 9");
}

}  // namespace
}  // namespace poinsot::physics
