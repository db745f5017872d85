// SPDX-License-Identifier: Apache-2.0
// Bodies as scenes describe them. Expected values: closed forms of textbooks for solids, evaluated by hand; sums
// over five masses, computed apart from the code; and second moments of a simplex.
#include <gmock/gmock.h>

#include <algorithm>

#include "scene_testing.h"

namespace poinsot::scene {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using testing::HasSubstr;

const std::string kStart = "motion.omega_body = [0.1, 0.2, 1]\n";

Body bodyOf(const std::string& text) { return parseScene(kStart + text, dataPath("test.toml")).body; }

std::string problems(const std::string& text) { return messagesOf(kStart + text, {}, dataPath("test.toml")); }

/// Returns the principal moments in ascending order.
Vector3d momentsOf(const Body& body) {
  Vector3d moments = body.axes.moments().values();
  std::sort(moments.data(), moments.data() + 3);
  return moments;
}

struct ShapeCase {
  const char* keys;
  Vector3d moments;  // of 1 kg, ascending
};

const ShapeCase kShapes[] = {
    {"shape='box'\nsize=[0.205, 0.135, 0.03]", {0.00159375, 0.00357708333333333, 0.00502083333333333}},
    {"shape='hollow_box'\nsize=[1.2, 0.9, 0.5]\nwall=0.05",
     {0.128900709219858, 0.190762411347518, 0.24991134751773}},
    {"shape='plate'\nsize=[3, 2]", {4.0 / 12, 9.0 / 12, 13.0 / 12}},
    {"shape='ellipsoid'\nsize=[2.6, 1.6, 1]", {0.178, 0.388, 0.466}},
    {"shape='ellipsoid_shell'\nsize=[2.6, 1.6, 1]", {0.296666666666667, 0.646666666666667, 0.776666666666667}},
    {"shape='sphere'\nradius=0.45", {0.081, 0.081, 0.081}},
    {"shape='sphere'\nradius=0.45\ninner_radius=0.3",
     {0.0999473684210526, 0.0999473684210526, 0.0999473684210526}},
    {"shape='sphere_shell'\nradius=0.45", {0.135, 0.135, 0.135}},
    {"shape='hemisphere'\nradius=0.45", {0.0525234375, 0.0525234375, 0.081}},
    {"shape='cylinder'\nradius=0.45\nheight=1.7", {0.10125, 0.291458333333333, 0.291458333333333}},
    {"shape='cylinder'\nsize=[0.9, 0.9, 1.7]", {0.10125, 0.291458333333333, 0.291458333333333}},
    {"shape='cylinder'\nradius=0.45\nheight=1.7\ninner_radius=0.3",
     {0.14625, 0.313958333333333, 0.313958333333333}},
    {"shape='cylinder_shell'\nradius=0.45\nheight=1.7", {0.2025, 0.342083333333333, 0.342083333333333}},
    {"shape='disc'\nradius=2", {1, 1, 2}},
    {"shape='hoop'\nradius=2", {2, 2, 4}},
    {"shape='cone'\nradius=0.45\nheight=1.7", {0.06075, 0.13875, 0.13875}},
    {"shape='cone_shell'\nradius=0.45\nheight=1.7", {0.10125, 0.211180555555556, 0.211180555555556}},
    {"shape='torus'\nradius=1.1\ntube_radius=0.35", {0.6815625, 0.6815625, 1.301875}},
    {"shape='torus_shell'\nradius=1.1\ntube_radius=0.35", {0.758125, 0.758125, 1.39375}},
    {"shape='capsule'\nradius=0.45\nheight=1", {0.09365625, 0.271130208333333, 0.271130208333333}},
    {"shape='tetrahedron'\nedge=1", {0.05, 0.05, 0.05}},
    {"shape='cube'\nedge=1", {1 / 6.0, 1 / 6.0, 1 / 6.0}},
    {"shape='octahedron'\nedge=1", {0.1, 0.1, 0.1}},
    {"shape='icosahedron'\nedge=1", {0.261803398874989, 0.261803398874989, 0.261803398874989}},
    {"shape='dodecahedron'\nedge=1", {0.607355503741639, 0.607355503741639, 0.607355503741639}},
    {"shape='l_plate'\nsize=[3, 2]\narm=0.5", {0.183551788229696, 0.969225989548082, 1.15277777777778}},
    {"shape='t_handle'\nbar_length=3\nbar_radius=0.2\nshaft_length=1.5\nshaft_radius=0.2",
     {0.279722222222222, 0.513333333333333, 0.773055555555556}},
    {"shape='racket'\nlength=0.68\nwidth=0.26",
     {0.0014365 / 0.33, 0.0133167424242424 / 0.33, 0.0147532424242424 / 0.33}},
    {"shape='wing_nut'\nhub_radius=0.5\nhub_height=1\nwing=[1.2, 0.2, 0.9]\nwing_centre=1.1\nwing_rise=0.3",
     {0.139823164926434, 0.553783298426565, 0.610597655336842}},
};

// Measured: 1.5e-15 of the moments.
TEST(Shapes, HaveTheMomentsOfTextbooks) {
  for (const ShapeCase& shape : kShapes) {
    const Body body = bodyOf("[body]\nmass=1\n" + std::string(shape.keys));
    EXPECT_LE((momentsOf(body) - shape.moments).norm(), 1e-14 * shape.moments.norm()) << shape.keys;
    EXPECT_EQ(body.parts.size(), 1u);
  }
}

// A single part turns about its centre of mass, for any offset and rotation. Measured: 3e-15.
TEST(Parts, SinglePartHasTheMomentsOfItsShape) {
  for (const ShapeCase& shape : kShapes) {
    const Body body = bodyOf("[[body.part]]\nmass=2\noffset=[1, -2, 0.5]\naxis=[1, 2, 3]\nangle=0.7\n" +
                             std::string(shape.keys));
    EXPECT_LE((momentsOf(body) - 2 * shape.moments).norm(), 2e-14 * shape.moments.norm()) << shape.keys;
  }
}

constexpr const char* kFiveMasses =
    "[[body.point_mass]]\nmass=1.5\nposition=[0.5, -1.25, 0.75]\n"
    "[[body.point_mass]]\nmass=0.75\nposition=[-1, 0.25, 1.5]\n"
    "[[body.point_mass]]\nmass=2.25\nposition=[0.125, 0.875, -0.625]\n"
    "[[body.point_mass]]\nmass=1.125\nposition=[1.75, 0.5, -0.25]\n"
    "[[body.point_mass]]\nmass=0.375\nposition=[-0.5, -0.75, -1.125]\n";

// Expected tensors come from eq (7) and, about the origin, from eq (3). Measured: 8e-16.
TEST(PointMasses, AddUpToTheTensorOfTheBody) {
  const Body free = bodyOf(kFiveMasses), held = bodyOf("body.pivot=[0, 0, 0]\n" + std::string(kFiveMasses));
  Matrix3d about_cm, about_origin;
  about_cm << 8.5045166015625, -0.052734375, 1.06787109375, -0.052734375, 7.9420166015625, 2.19287109375,
      1.06787109375, 2.19287109375, 8.54296875;
  about_origin << 8.560546875, -0.24609375, 1.01953125, -0.24609375, 8.654296875, 2.1796875, 1.01953125, 2.1796875,
      9.3046875;
  EXPECT_LE((free.axes.inertia_B() - about_cm).norm(), 1e-14);
  EXPECT_LE((held.axes.inertia_B() - about_origin).norm(), 1e-14);
  EXPECT_EQ(free.mass->mass_kg(), 6);
  EXPECT_LE((free.fixedPoint_B() - Vector3d(0.34375, 0.09375, 0.0234375)).norm(), 1e-15);
  EXPECT_EQ(held.fixedPoint_B(), Vector3d(0, 0, 0));
  EXPECT_EQ(free.parts.size(), 5u);
}

// The pivot is the cone's apex, 3h/4 above its centre of mass (eq 14). Measured: 3e-16.
TEST(Pivot, BecomesTheReferencePointOfTheMoments) {
  const Body cone = bodyOf("[body]\nshape='cone'\nradius=0.45\nheight=1.7\nmass=1\npivot=[0, 0, 1.275]");
  EXPECT_LE((momentsOf(cone) - Vector3d(0.06075, 1.764375, 1.764375)).norm(), 1e-14);
}

// The T-handle of kShapes as two bars of one density. Measured: 6e-16 of the moments.
TEST(Parts, TwoBarsOfEqualDensityAddUpToATHandle) {
  const Body body = bodyOf(
      "[[body.part]]\nshape='cylinder'\nradius=0.2\nheight=3\ndensity=2\naxis=[0, 1, 0]\nangle='90 deg'\n"
      "[[body.part]]\nshape='cylinder'\nradius=0.2\nheight=1.5\ndensity=2\naxis=[-2, 0, 0]\nangle='90 deg'\n"
      "offset=[0, 0.95, 0]\n");
  const double mass = 2 * 3.14159265358979324 * 0.04 * 4.5;
  EXPECT_NEAR(body.mass->mass_kg() / mass, 1, 1e-15);
  EXPECT_LE((body.fixedPoint_B() - Vector3d(0, 0.316666666666667, 0)).norm(), 1e-15);
  EXPECT_LE((momentsOf(body) / mass - Vector3d(0.279722222222222, 0.513333333333333, 0.773055555555556)).norm(),
            1e-14);
}

// tests/scene/data/body.stl is a corner cut off a box of 20 x 30 x 40 mm, V = abc/6. A simplex with corners at 0
// and at a, b, c on the axes has its centre at a quarter of each, variances 3a²/80 and covariances -ab/80 (moments
// of a Dirichlet distribution). Measured: 4e-16.
TEST(Mesh, DeterminesTheMomentsOfTheBody) {
  const Body body = bodyOf("[body]\nshape='mesh'\nfile='body.stl'\nfile_unit='1 mm'\ndensity=1000");
  const double a = 0.02, b = 0.03, c = 0.04, mass = 1000 * a * b * c / 6;
  Matrix3d expected;
  expected << 3 * (b * b + c * c), a * b, a * c, a * b, 3 * (a * a + c * c), b * c, a * c, b * c,
      3 * (a * a + b * b);
  expected *= mass / 80;
  EXPECT_NEAR(body.mass->mass_kg() / mass, 1, 1e-14);
  EXPECT_LE((body.axes.inertia_B() - expected).norm(), 1e-14 * expected.norm());
  EXPECT_LE((body.fixedPoint_B() - Vector3d(a, b, c) / 4).norm(), 1e-16);
  EXPECT_TRUE(std::holds_alternative<std::shared_ptr<const geometry::Mesh>>(body.parts[0].figure));
}

// Eigenvalues of [[2, 1, 0], [1, 2, 0], [0, 0, 2.5]], by hand. Measured: exact.
TEST(Tensor, IsGivenRowByRow) {
  const Body body = bodyOf("body.inertia=[[2, 1, 0], [1, '2 kg m^2', 0], [0, 0, 2.5]]");
  EXPECT_LE((momentsOf(body) - Vector3d(1, 2.5, 3)).norm(), 1e-14);
  EXPECT_EQ(body.axes.inertia_B()(0, 1), body.axes.inertia_B()(1, 0));
  EXPECT_FALSE(body.mass);
}

TEST(Catalogue, ProvidesMassAndMomentsOfABody) {
  const Body body = bodyOf("body.catalogue='racket'");
  EXPECT_NEAR(body.mass->mass_kg(), 0.33, 1e-15);
  EXPECT_LE((momentsOf(body) - Vector3d(0.0014365, 0.0133167424242424, 0.0147532424242424)).norm(), 1e-15);
  EXPECT_FALSE(body.parts.empty());
  // Published moments are in the proportions 3.0836 : 3.235 : 1.
  const Vector3d toutatis = momentsOf(bodyOf("body.catalogue='toutatis'"));
  EXPECT_NEAR(toutatis[1] / toutatis[0], 3.0836, 1e-12);
  EXPECT_NEAR(toutatis[2] / toutatis[0], 3.235, 1e-12);
}

TEST(Bodies, RejectTwoDescriptionsOfOneBody) {
  const std::string ways =
      "; a body is described in one way: principal_moments, inertia, shape, catalogue, or parts "
      "and point masses\n";
  EXPECT_EQ(problems("body.inertia=[[2, 0, 0], [0, 2, 0], [0, 0, 2]]\nbody.principal_moments=[1, 2, 3]"),
            "body.inertia: body.principal_moments is given too" + ways);
  EXPECT_EQ(problems("body.catalogue='racket'\nbody.mass=2"), "body.mass: body.catalogue is given too" + ways);
  EXPECT_EQ(problems("body.catalogue='racket'\n[[body.point_mass]]\nmass=1\nposition=[1, 1, 1]"),
            "body.point_mass[0]: body.catalogue is given too" + ways);
}

TEST(Shapes, ErrorsListTheKeysOfTheShape) {
  EXPECT_EQ(
      problems("[body]\nmass=1\nshape='cone'\nradius=1"),
      "body.shape: \"cone\" takes radius and height; height is missing. For example:\n    height = \"20 cm\"\n");
  EXPECT_EQ(problems("[body]\nmass=1\nshape='cone'\nradius=1\nheight=2\nedge=3"),
            "body.edge: is not allowed here: shape \"cone\" takes radius and height\n");
  EXPECT_EQ(problems("[body]\nmass=1\nshape='cylinder'\nradius=1\nsize=[1, 1, 1]"),
            "body.radius: is not allowed here: shape \"cylinder\" takes size, or radius and height (optional: "
            "inner_radius)\n");
  EXPECT_EQ(
      problems("[body]\nmass=1\nradius=1"),
      "body.radius: body.shape is missing; this key describes a shape. For example:\n    shape = \"sphere\"\n");
  EXPECT_EQ(
      problems("[body]\nmass=1\nshape='plate'\nsize=[1, 2, 3]"),
      "body.shape: \"plate\" has 2 extents, got 3; a plate with a thickness is a box. For example:\n    shape = "
      "\"box\"\n");
  EXPECT_EQ(problems("[body]\nmass=1\nshape='box'\nsize=[1, 2]"),
            "body.size: shape \"box\" has 3 extents, got 2\n");
}

TEST(Shapes, ReportContradictoryLengthsAtTheSmallerOne) {
  EXPECT_EQ(problems("[body]\nmass=1\nshape='hollow_box'\nsize=[1, 2, 3]\nwall=0.5"),
            "body.wall: two walls of the hollow box must be less than its least edge 1, got a wall of 0.5\n");
  EXPECT_EQ(problems("[body]\nmass=1\nshape='torus'\nradius=1\ntube_radius=2"),
            "body.tube_radius: tube radius of the torus must be less than its radius 1, got 2\n");
  EXPECT_EQ(
      problems("[body]\nmass=1\nshape='sphere'\nradius=1\ninner_radius=1"),
      "body.inner_radius: inner radius of the sphere must be at least 0 and less than its radius 1, got 1\n");
}

TEST(Masses, NeedEitherAMassOrADensity) {
  EXPECT_EQ(problems("[body]\nshape='hoop'\nradius=1\ndensity=2"),
            "body.density: this shape has no volume, so a density does not determine its mass; give body.mass\n");
  EXPECT_EQ(problems("[body]\nshape='cube'\nedge=1\ndensity=2\nmass=3"),
            "body.density: body.mass is given too; give one of the two\n");
  EXPECT_EQ(problems("[[body.part]]\nshape='cube'\nedge=1"),
            "body.part[0].shape: body.part[0].mass is missing: a shape and its mass (or density) set the moments "
            "together. For example:\n    mass = 1\n");
}

TEST(Parts, ReportMissingKeys) {
  EXPECT_EQ(problems("[[body.part]]\n"), "body.part[0]: body.part[0].shape is missing\n");
  EXPECT_EQ(problems("[[body.part]]\nshape='cube'\nedge=1\nmass=1\nangle=1"),
            "body.part[0].angle: body.part[0].axis is missing: a turn is an axis and an angle\n");
  EXPECT_EQ(problems("[[body.part]]\nshape='cube'\nedge=1\nmass=1\nangle=1\naxis=[0, 0, 0]"),
            "body.part[0].axis: must not be zero, got (0, 0, 0): a zero vector is not an axis\n");
  EXPECT_EQ(
      problems("[[body.part]]\nshape='cube'\nedge=1\nmass=1\nangle=1\naxis=[0, 0, 1]\nrotation=[1, 0, 0, 0]"),
      "body.part[0].axis: body.part[0].rotation is given too; give rotation, or axis and angle\n");
  EXPECT_EQ(problems("[[body.point_mass]]\nmass=1"),
            "body.point_mass[0]: body.point_mass[0].position is missing: a point mass has mass and position\n");
}

TEST(Bodies, RejectImpossibleMoments) {
  EXPECT_THAT(
      problems("[[body.point_mass]]\nmass=1\nposition=[1, 0, 0]\n[[body.point_mass]]\nmass=1\nposition=[2, 0, 0]"),
      HasSubstr("body.point_mass[0]: the whole body lies on one line through its fixed point"));
  EXPECT_THAT(problems("body.inertia=[[1, 0, 0], [0, 1, 0], [0, 0, 3]]"), HasSubstr("body.inertia: "));
  EXPECT_THAT(problems("body.inertia=[[1, 2, 0], [2, 1, 0], [0, 0, 2]]"),
              HasSubstr("body.inertia: "));  // a negative moment
  EXPECT_EQ(problems("body.inertia=[[2, 1, 0], [1.5, 2, 0], [0, 0, 2]]"),
            "body.inertia: must be symmetric, got 1 in row 1 column 2 and 1.5 across the diagonal\n");
  EXPECT_THAT(problems("body.principal_moments=[1, 2, 2]\nbody.pivot=[0, 0, 1]"),
              HasSubstr("body.pivot: needs a body with a mass"));
}

TEST(Mesh, ReportsAnUnusableFileAsASceneError) {
  const std::string mesh = "[body]\nmass=1\nshape='mesh'\n";
  EXPECT_EQ(problems(mesh + "file='none.stl'"),
            "body.file: cannot read none.stl: No such file or directory in the scene's folder\n");
  EXPECT_THAT(problems(mesh + "file='torque.csv'"), HasSubstr("body.file: "));
  EXPECT_THAT(problems(mesh + "file='../data/body.stl'"), HasSubstr("without \"..\""));
  EXPECT_THAT(problems(mesh + "file='open.obj'"), HasSubstr("body.file: "));
  EXPECT_EQ(problems(mesh),
            "body.shape: \"mesh\" takes file (optional: file_unit); file is missing. For example:\n    file = "
            "\"body.stl\"\n");
}

}  // namespace
}  // namespace poinsot::scene
