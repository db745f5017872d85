// SPDX-License-Identifier: Apache-2.0
// Every solid as drawn, in metres and in the body's own axes: how far it reaches, where its centre of mass is, and
// that its marks lie on it. Expected values come from the solids' dimensions, and from surfaces written out here.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>

#include "scene_samples.h"
#include "stage/body/body_figure.h"
#include "stage/to_picture.h"

namespace poinsot::stage {
namespace {

using namespace physics;  // for its many solids
using Eigen::Matrix3d;
using Eigen::Vector3d;

scene::Scene sceneOf(const Solid& solid) {
  scene::Scene scene = sample();
  scene.body.mass = massProperties(solid, 2);
  scene.body.axes = PrincipalMoments({2, 3, 4});  // equal to B, in which figures are checked
  scene.body.parts = {scene::Part{solid, 2}};
  return scene;
}

/// Returns the draw list of a scene's body, with 2000 pixels to a metre.
draw::DrawList drawn(const scene::Scene& scene) {
  draw::DrawList list;
  list.camera.size_px = {4000, 4000};
  BodyFigure(scene).add(list, {Matrix3d::Identity(), 1}, palette(scene::Theme::kLight), 2);
  return list;
}

/// Returns points all over the drawn surfaces.
std::vector<Vector3d> cloudOf(const draw::DrawList& list) {
  std::vector<Vector3d> cloud;
  const auto add = [&](const glm::vec3& p) { cloud.push_back(fromPicture(p)); };
  constexpr int kTurns = 720;
  for (int i = 0; i < kTurns; ++i) {
    const auto a = static_cast<float>(2 * std::numbers::pi * i / kTurns);
    for (const auto& f : list.frustums) {
      const glm::vec3 axis = glm::normalize(f.to_V - f.from_V);
      const glm::vec3 u = glm::normalize(glm::cross(axis, glm::vec3(axis.y, axis.z, -axis.x)));
      const glm::vec3 out = std::cos(a) * u + std::sin(a) * glm::cross(axis, u);
      add(f.from_V + f.fromRadius * out);
      add(f.to_V + f.toRadius * out);
    }
    for (const auto& e : list.ellipsoids)
      for (int k = 0; k <= 90; ++k) {
        const auto b = static_cast<float>(std::numbers::pi * k / 90);
        add(e.centre_V +
            e.semiAxes_V * glm::vec3(std::sin(b) * std::cos(a), std::sin(b) * std::sin(a), std::cos(b)));
      }
  }
  for (const auto& b : list.boxes)
    for (int corner = 0; corner < 8; ++corner)
      add(b.centre_V + b.halfAxes_V * glm::vec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1));
  for (const auto& m : list.meshes)
    for (const glm::vec3& v : m.mesh->vertices_M) add(m.origin_V + m.axes_V * v);
  return cloud;
}

/// Returns the farthest that is drawn in a direction; tubes count as balls moved along a curve.
double drawnReach(const draw::DrawList& list, const std::vector<Vector3d>& cloud, const Vector3d& direction) {
  double farthest = -1e300;
  for (const Vector3d& p : cloud) farthest = std::max(farthest, p.dot(direction));
  for (const auto& c : list.curves)
    for (const glm::vec3& p : c.points_V)
      if (c.radius_V > 0)
        farthest = std::max(farthest, fromPicture(p).dot(direction) + static_cast<double>(c.radius_V));
  return farthest;
}

const std::pair<const char*, Solid> kSolids[] = {
    {"box", Box{{0.24, 0.16, 0.04}}},
    {"hollow box", HollowBox{{1.2, 0.9, 0.5}, 0.05}},
    {"plate", Plate{{0.3, 0.2}}},
    {"ellipsoid", Ellipsoid{{0.15, 0.1, 0.08}}},
    {"ellipsoid shell", EllipsoidShell{{0.15, 0.1, 0.08}}},
    {"sphere", Sphere{0.1}},
    {"thick shell", Sphere{0.45, 0.3}},
    {"sphere shell", SphereShell{0.1}},
    {"hemisphere", Hemisphere{0.45}},
    {"cylinder", Cylinder{0.45, 1.7}},
    {"tube", Cylinder{0.45, 1.7, 0.3}},
    {"cylinder shell", CylinderShell{0.45, 1.7}},
    {"disc", Disc{0.1}},
    {"hoop", Hoop{0.1}},
    {"rod", Rod{0.3}},
    {"cone", Cone{0.45, 1.7}},
    {"cone shell", ConeShell{0.45, 1.7}},
    {"torus", Torus{1.1, 0.35}},
    {"torus shell", TorusShell{1.1, 0.35}},
    {"capsule", Capsule{0.45, 1}},
    {"tetrahedron", Polyhedron{PolyhedronKind::kTetrahedron, 1}},
    {"cube", Polyhedron{PolyhedronKind::kCube, 1}},
    {"octahedron", Polyhedron{PolyhedronKind::kOctahedron, 1}},
    {"dodecahedron", Polyhedron{PolyhedronKind::kDodecahedron, 1}},
    {"icosahedron", Polyhedron{PolyhedronKind::kIcosahedron, 1}},
    {"L plate", LPlate{{3, 2}, 0.5}},
    {"T-handle", THandle{3, 0.2, 1.5, 0.2}},
    {"racket", Racket{0.68, 0.26}},
    {"wing nut", WingNut{0.5, 1, {1.2, 0.2, 0.9}, 1.1, 0.3}},
};
static_assert(std::size(kSolids) >= std::variant_size_v<Solid>);

// Measured over all solids: the drawn points end at most 4e-4 of the radius inside the reach (from sampling a
// circle), and at most 1e-7 outside (floats).
TEST(SolidFigures, ReachAsFarAsTheirSupportPoints) {
  for (const auto& [name, solid] : kSolids) {
    const scene::Scene scene = sceneOf(solid);
    const BodyFigure figure(scene);
    const draw::DrawList list = drawn(scene);
    const std::vector<Vector3d> cloud = cloudOf(list);
    for (const Vector3d& direction : {Vector3d(1, 0, 0), Vector3d(-0.6, 0.8, 0), Vector3d(0.48, -0.6, 0.64),
                                      Vector3d(0, 0, -1), Vector3d(-0.36, 0.48, 0.8)}) {
      const double inside = direction.dot(figure.supportPoint(direction)) - drawnReach(list, cloud, direction);
      EXPECT_LE(inside, 2e-3 * figure.radius()) << name << " along " << direction.transpose();
      EXPECT_GE(inside, -1e-6 * figure.radius()) << name << " along " << direction.transpose();
    }
    double farthest = 0;
    for (const Vector3d& p : cloud) farthest = std::max(farthest, p.norm());
    EXPECT_LE(farthest, figure.radius() * (1 + 1e-6)) << name;
  }
}

// Extents along x, y, z from the dimensions; 0 marks a solid without thickness, which is drawn with a little.
TEST(SolidFigures, HaveTheSolidsDimensions) {
  const double phi = std::numbers::phi;
  const std::pair<const char*, Vector3d> extents[] = {
      {"box", {0.24, 0.16, 0.04}},
      {"hollow box", {1.2, 0.9, 0.5}},
      {"plate", {0.3, 0.2, 0}},
      {"ellipsoid", {0.3, 0.2, 0.16}},
      {"ellipsoid shell", {0.3 - 0.15 * (1 - std::cos(0.55)), 0.2, 0.16}},  // open at the end of its longest axis
      {"sphere", {0.2, 0.2, 0.2}},
      {"hemisphere", {0.9, 0.9, 0.45}},
      {"cylinder", {0.9, 0.9, 1.7}},
      {"tube", {0.9, 0.9, 1.7}},
      {"cylinder shell", {0.9, 0.9, 1.7}},
      {"disc", {0.2, 0.2, 0}},
      {"rod", {0.3, 0, 0}},
      {"cone", {0.9, 0.9, 1.7}},
      {"cone shell", {0.9, 0.9, 1.7}},
      {"torus", {2.9, 2.9, 0.7}},
      {"torus shell", {2.9, 2.9, 0.7}},
      {"capsule", {0.9, 0.9, 1.9}},
      {"cube", {1, 1, 1}},
      {"octahedron", Vector3d::Constant(std::sqrt(2))},
      {"icosahedron", Vector3d::Constant(phi)},
      {"dodecahedron", Vector3d::Constant(phi * phi)},
      {"L plate", {3, 2, 0}},
      {"T-handle", {3, 1.9, 0.4}},
      {"wing nut", {3.4, 1, 1.25}}};
  for (const auto& [name, expected] : extents) {
    const auto found =
        std::ranges::find(kSolids, std::string(name), [](const auto& s) { return std::string(s.first); });
    ASSERT_NE(found, std::end(kSolids)) << name;
    const Vector3d extent = 2 * BodyFigure(sceneOf(found->second)).halfExtents();
    for (int i = 0; i < 3; ++i) {
      // Meshes of curved surfaces are inscribed: 3e-4 of the radius.
      const bool thin = expected[i] == 0;
      const double least = thin ? 0.01 * extent.maxCoeff() : expected[i] * (1 - 1e-3);
      const double most = thin ? 0.1 * extent.maxCoeff() : expected[i] * (1 + 1e-6);
      EXPECT_GT(extent[i], least) << name << " axis " << i;
      EXPECT_LT(extent[i], most) << name << " axis " << i;
    }
  }
}

// Distances of the centre of mass from the solid's ends: textbook values and table 3.1 of the project's physics
// notes.
TEST(SolidFigures, HaveTheCentreOfMassAtTheOrigin) {
  const auto below = [](const Solid& solid, const Vector3d& direction) {
    return direction.dot(BodyFigure(sceneOf(solid)).supportPoint(direction));
  };
  const Vector3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  EXPECT_NEAR(below(Hemisphere{0.8}, -z), 0.3, 1e-6);  // 3r/8
  EXPECT_NEAR(below(Cone{0.45, 1.7}, -z), 1.7 / 4, 1e-14);
  EXPECT_NEAR(below(Cone{0.45, 1.7}, z), 3 * 1.7 / 4, 1e-14);
  EXPECT_NEAR(below(ConeShell{0.45, 1.7}, -z), 1.7 / 3, 1e-6);  // a mesh of floats
  EXPECT_NEAR(below(LPlate{{3, 2}, 0.5}, -x), 1.08333333333333, 1e-6);
  EXPECT_NEAR(below(LPlate{{3, 2}, 0.5}, -y), 0.583333333333333, 1e-6);
  EXPECT_NEAR(below(THandle{3, 0.2, 1.5, 0.2}, -y), 0.316666666666667 + 0.2, 1e-13);
  EXPECT_NEAR(below(WingNut{0.5, 1, {1.2, 0.2, 0.9}, 1.1, 0.3}, -z), 0.5 + 0.10645654305763, 1e-13);
  EXPECT_NEAR(below(Racket{0.68, 0.26}, -x), 0.385151515152, 1e-12);  // balance from the butt
}

/// Surface of a solid; off() returns how far a point is off the surface, in S, in the solid's size.
struct Surface {
  const char* name;
  Solid solid;
  Vector3d centre_S;  // centre of mass, if not the origin
  std::function<double(const Vector3d&)> off;
};

double across(const Vector3d& p) { return std::hypot(p.x(), p.y()); }

// Marks are chords of the curves they follow, and some lie on a mesh: measured 6e-4 of the size at most.
TEST(SolidFigures, HaveTheirMarksOnTheirSurface) {
  const double r = 0.45, h = 0.85;
  const Surface surfaces[] = {
      {"cylinder",
       Cylinder{r, 2 * h},
       {0, 0, 0},
       [=](const Vector3d& p) { return std::max(across(p) / r, std::abs(p.z()) / h) - 1; }},
      {"tube",
       Cylinder{r, 2 * h, 0.3},
       {0, 0, 0},
       [=](const Vector3d& p) {
         const double wall = std::min(std::abs(across(p) - r), std::abs(across(p) - 0.3));
         return std::min(wall, std::abs(std::abs(p.z()) - h));
       }},
      {"torus",
       Torus{1.1, 0.35},
       {0, 0, 0},
       [](const Vector3d& p) { return std::hypot(across(p) - 1.1, p.z()) / 0.35 - 1; }},
      {"torus shell",
       TorusShell{1.1, 0.35},
       {0, 0, 0},
       [](const Vector3d& p) { return std::hypot(across(p) - 1.1, p.z()) / 0.35 - 1; }},
      {"capsule",
       Capsule{r, 2 * h},
       {0, 0, 0},
       [=](const Vector3d& p) { return std::hypot(across(p), std::max(std::abs(p.z()) - h, 0.0)) / r - 1; }},
      {"hemisphere",
       Hemisphere{r},
       {0, 0, 3 * r / 8},
       [=](const Vector3d& p) { return std::min(std::abs(p.norm() / r - 1), std::abs(p.z())); }},
      {"cone",
       Cone{r, 1.7},
       {0, 0, 0},  // r(z) falls from r at -h/4 to 0 at 3h/4
       [=](const Vector3d& p) {
         const double side = across(p) - r * (1.275 - p.z()) / 1.7;
         return std::min(std::abs(side), std::abs(p.z() + 0.425));
       }},
      {"thick shell",
       Sphere{r, 0.3},
       {0, 0, 0},
       [=](const Vector3d& p) { return std::min(std::abs(p.norm() - r), std::abs(p.norm() - 0.3)); }},
  };
  for (const Surface& surface : surfaces) {
    int marks = 0;
    for (const auto& curve : drawn(sceneOf(surface.solid)).curves) {
      if (curve.radius_V > 0) continue;
      ++marks;
      for (const glm::vec3& p : curve.points_V)
        ASSERT_NEAR(surface.off(fromPicture(p) + surface.centre_S), 0, 2e-3) << surface.name;
    }
    EXPECT_GE(marks, 6) << surface.name;
  }
}

// One meridian is heavier than the others; without it, a turn by 120 degrees would not show.
TEST(SolidFigures, HaveOneBoldMeridianIfRotationallySymmetric) {
  for (const auto& [name, solid] : kSolids) {
    const std::string known = "cylinder tube cylinder shell disc hoop cone cone shell torus torus shell capsule";
    if (known.find(name) == std::string::npos) continue;
    std::vector<float> widths;
    for (const auto& curve : drawn(sceneOf(solid)).curves)
      if (curve.radius_V == 0) widths.push_back(curve.width_px);
    ASSERT_FALSE(widths.empty()) << name;
    EXPECT_GT(*std::ranges::max_element(widths), 1.5f * *std::ranges::min_element(widths)) << name;
  }
}

// The lines are 2 pixels wide. A part that is 5 pixels wide has no lines, a part of 7 has lines; a thin plate is a
// thousand wide. Strings of a racket do not count as marks.
TEST(SolidFigures, HaveNoMarksIfTheyAreFewPixelsWide) {
  const auto marks = [](const physics::Solid& solid) {
    const auto list = drawn(sceneOf(solid));
    return std::ranges::count_if(list.curves, [](const draw::Curve& curve) { return curve.radius_V == 0; });
  };
  EXPECT_EQ(marks(Cylinder{0.00125, 1}), 0);
  EXPECT_GT(marks(Cylinder{0.00175, 1}), 0);
  EXPECT_EQ(marks(Box{{0.0025, 0.0025, 1}}), 0);
  EXPECT_GT(marks(Box{{0.001, 0.5, 1}}), 0);
  EXPECT_EQ(marks(Torus{0.5, 0.00125}), 0);
  EXPECT_GT(marks(Torus{0.5, 0.00175}), 0);
  EXPECT_EQ(marks(physics::Racket{0.06, 0.02}), 2 * 8);  // 3 pixels of frame, 7 of handle
}

}  // namespace
}  // namespace poinsot::stage
