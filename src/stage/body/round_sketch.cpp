// SPDX-License-Identifier: Apache-2.0
#include "stage/body/round_sketch.h"

#include <cmath>
#include <numbers>

#include "geometry/primitives.h"

namespace poinsot::stage {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using geometry::Vector2;

/// Profile of a solid of revolution: points (distance from the z axis, z).
using Profile = std::vector<Vector2>;

constexpr double kPi = std::numbers::pi;
constexpr int kSegments = 120;  // number of segments around a mesh; a circle of radius 300 px is off by 0.1 px
constexpr double kHeavy = 1.8;  // width of the thick meridian, as a multiple of an ordinary line

// Drawn thickness of solids without thickness, as a fraction of their radius, or of the length of a rod. With this
// thickness, solids stay visible edge on.
constexpr double kDiscHalfThickness = 0.025, kHoopTube = 0.045, kRodRadius = 0.02;
// Radius of the flat apex of a cone's mesh, as a fraction of the cone's radius. An exact point has no normal,
// which would spoil the shading of the side.
constexpr double kSpeck = 1e-3;
constexpr double kShellWall = 0.05;   // thickness of a shell, as a fraction of its radius
constexpr double kWindow_rad = 0.55;  // half the angle of the opening at a ball's pole
constexpr double kGutter_rad = 0.6;   // half the angle of the opening along a torus shell

Vector3d at(const Vector2& p, double angle) { return {p.x() * std::cos(angle), p.x() * std::sin(angle), p.y()}; }

void ring(const Sketch& sketch, double radius, double z) {
  sketch.mark(loop(96, [&](double s) { return at({radius, z}, s); }), true);
}

/// Returns an arc of a circle about the origin, both ends included. Angles are measured from the +z axis.
Profile arc(double radius, double from_rad, double to_rad) {
  constexpr int kSteps = 48;
  Profile points;
  for (int i = 0; i <= kSteps; ++i) {
    const double angle = from_rad + (to_rad - from_rad) * i / kSteps, sine = std::sin(angle);
    points.emplace_back(std::abs(sine) < 1e-12 ? 0 : radius * sine, radius * std::cos(angle));
  }
  return points;
}

Profile joined(Profile first, const Profile& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// Draws a line of a surface of revolution at `count` angles about the z axis. The first line is thicker.
void meridians(const Sketch& sketch, const Profile& line, int count) {
  for (int i = 0; i < count; ++i) {
    std::vector<Vector3d> points;
    for (const Vector2& p : line) points.push_back(at(p, 2 * kPi * i / count));
    sketch.mark(points, false, i == 0 ? kHeavy : 1);
  }
}

/// Returns the profile of a hollow ball of radius 1 that is open around +z.
Profile hollowBall(double innerRadius) {
  return joined(arc(1, kPi, kWindow_rad), arc(innerRadius, kWindow_rad, kPi));
}

void openEllipsoid(const Sketch& sketch, const Vector3d& semiAxes, double innerShare) {
  const geometry::Mesh ball = geometry::turnedMesh(hollowBall(innerShare), kSegments);
  sketch.mesh(geometry::transformed(ball, semiAxes.asDiagonal()), false);
  const auto onIt = [&](double latitude, double longitude) {
    return Vector3d(semiAxes.cwiseProduct(Vector3d(std::sin(latitude) * std::cos(longitude),
                                                   std::sin(latitude) * std::sin(longitude), std::cos(latitude))));
  };
  for (const double latitude : {kWindow_rad, 0.3 * kPi, 0.5 * kPi, 0.7 * kPi, 0.85 * kPi})
    sketch.mark(loop(96, [&](double s) { return onIt(latitude, s); }), true);
  sketch.mark(loop(96, [&](double s) { return Vector3d(innerShare * onIt(kWindow_rad, s)); }), true);
  for (int i = 0; i < 4; ++i) {
    std::vector<Vector3d> line;
    for (const Vector2& p : arc(1, kWindow_rad, 0.96 * kPi))
      line.push_back(semiAxes.cwiseProduct(at(p, 0.5 * kPi * i)));
    sketch.mark(line, false, i == 0 ? kHeavy : 1);
  }
}

void tube(const Sketch& sketch, double inner, double outer, double h) {
  sketch.mesh(geometry::tubeMesh(outer, inner, 2 * h, kSegments), false);
  for (const double z : {-h, h})
    for (const double radius : {inner, outer}) ring(sketch, radius, z);
  meridians(sketch, {{outer, -h}, {outer, h}}, 3);
  meridians(sketch, {{inner, -h}, {inner, h}}, 3);
  for (const double z : {-h, h}) meridians(sketch, {{inner, z}, {outer, z}}, 3);
}

void cylinder(const Sketch& sketch, double radius, double h) {
  sketch.frustum({0, 0, -h}, {0, 0, h}, radius, radius);
  for (const double z : {-h, h}) ring(sketch, radius, z);
  meridians(sketch, {{radius, -h}, {radius, h}}, 3);
  for (const double z : {-h, h}) meridians(sketch, {{0, z}, {radius, z}}, 3);
}

}  // namespace

void add(const Sketch& sketch, const physics::Ellipsoid& solid) { sketch.ellipsoid({0, 0, 0}, solid.semiAxes_m); }

// Opens the shell at one end of its longest axis, like an egg.
void add(const Sketch& sketch, const physics::EllipsoidShell& solid) {
  const Vector3d& h = solid.semiAxes_m;
  int longest = 2;
  if (h.maxCoeff() > 1.1 * h.minCoeff()) h.maxCoeff(&longest);
  const int i = (longest + 1) % 3, k = (longest + 2) % 3;
  Matrix3d R;
  R << Vector3d::Unit(i), Vector3d::Unit(k), Vector3d::Unit(longest);
  openEllipsoid(sketch.turned(R, {0, 0, 0}), {h[i], h[k], h[longest]}, 1 - kShellWall);
}

void add(const Sketch& sketch, const physics::Sphere& solid) {
  const Vector3d semiAxes = Vector3d::Constant(solid.radius_m);
  if (solid.innerRadius_m > 0)
    openEllipsoid(sketch, semiAxes, solid.innerRadius_m / solid.radius_m);
  else
    sketch.ellipsoid({0, 0, 0}, semiAxes);
}

void add(const Sketch& sketch, const physics::SphereShell& solid) {
  openEllipsoid(sketch, Vector3d::Constant(solid.radius_m), 1 - kShellWall);
}

void add(const Sketch& sketch, const physics::Hemisphere& solid) {
  const double r = solid.radius_m;
  sketch.mesh(geometry::hemisphereMesh(r, kSegments), false);
  for (const double angle : {0.5, 0.35, 0.2}) ring(sketch, r * std::sin(angle * kPi), r * std::cos(angle * kPi));
  meridians(sketch, arc(r, 0.5 * kPi, 0), 4);
  meridians(sketch, {{0, 0}, {r, 0}}, 4);
}

void add(const Sketch& sketch, const physics::Cylinder& solid) {
  const double h = 0.5 * solid.height_m;
  if (solid.innerRadius_m > 0)
    tube(sketch, solid.innerRadius_m, solid.radius_m, h);
  else
    cylinder(sketch, solid.radius_m, h);
}

void add(const Sketch& sketch, const physics::CylinderShell& solid) {
  tube(sketch, (1 - kShellWall) * solid.radius_m, solid.radius_m, 0.5 * solid.height_m);
}

void add(const Sketch& sketch, const physics::Disc& solid) {
  cylinder(sketch, solid.radius_m, kDiscHalfThickness * solid.radius_m);
}

namespace {

void torusMarks(const Sketch& sketch, double radius, double tubeRadius, const Profile& section, bool closed) {
  constexpr int kRings = 8;
  for (int i = 0; i < kRings; ++i) {
    std::vector<Vector3d> points;
    for (const Vector2& p : section) points.push_back(at(p, 2 * kPi * i / kRings));
    sketch.mark(points, closed, i == 0 ? kHeavy : 1);
  }
  ring(sketch, radius + tubeRadius, 0);
}

/// Returns an arc of the circular cross-section of a torus's tube. Angles are about the centre of the tube, and
/// angle 0 points away from the axis of the torus.
Profile tubeSection(double radius, double tubeRadius, double from_rad, double to_rad, int steps) {
  Profile section;
  for (int i = 0; i <= steps; ++i) {
    const double angle = from_rad + (to_rad - from_rad) * i / steps;
    section.emplace_back(radius + tubeRadius * std::cos(angle), tubeRadius * std::sin(angle));
  }
  return section;
}

}  // namespace

void add(const Sketch& sketch, const physics::Torus& solid) {
  const double R = solid.radius_m, a = solid.tubeRadius_m;
  sketch.tube(loop(128, [&](double s) { return at({R, 0}, s); }), true, a);
  Profile section = tubeSection(R, a, 0, 2 * kPi, 48);
  section.pop_back();
  torusMarks(sketch, R, a, section, true);
}

// Draws the tube with an opening towards the axis, like a tyre.
void add(const Sketch& sketch, const physics::TorusShell& solid) {
  const double R = solid.radius_m, a = solid.tubeRadius_m, inner = (1 - 2 * kShellWall) * a;
  const double from = -kPi + kGutter_rad, to = kPi - kGutter_rad;
  const Profile wall = joined(tubeSection(R, a, from, to, 64), tubeSection(R, inner, to, from, 64));
  sketch.mesh(geometry::turnedMesh(wall, kSegments), false);
  torusMarks(sketch, R, a, tubeSection(R, a, from, to, 48), false);
  for (const double angle : {from, to}) ring(sketch, R + a * std::cos(angle), a * std::sin(angle));
}

void add(const Sketch& sketch, const physics::Hoop& solid) {
  add(sketch, physics::Torus{solid.radius_m, kHoopTube * solid.radius_m});
}

void add(const Sketch& sketch, const physics::Rod& solid) {
  Matrix3d R;
  R << Vector3d::UnitY(), Vector3d::UnitZ(), Vector3d::UnitX();
  const double r = kRodRadius * solid.length_m, h = 0.5 * solid.length_m;
  const Sketch along = sketch.turned(R, {0, 0, 0});
  along.frustum({0, 0, -h}, {0, 0, h}, r, r);
  for (const double z : {-h, h}) ring(along, r, z);
}

void add(const Sketch& sketch, const physics::Cone& solid) {
  const double r = solid.radius_m, base = -0.25 * solid.height_m, apex = 0.75 * solid.height_m;
  sketch.frustum({0, 0, base}, {0, 0, apex}, r, 0);
  ring(sketch, r, base);
  meridians(sketch, {{r, base}, {0, apex}}, 3);
  meridians(sketch, {{0, base}, {r, base}}, 3);
}

void add(const Sketch& sketch, const physics::ConeShell& solid) {
  const double r = solid.radius_m, base = -solid.height_m / 3, apex = solid.height_m + base;
  const double wall = kShellWall * r, inner = r - wall, innerApex = apex - wall * solid.height_m / r;
  const Profile wallProfile{{0, innerApex}, {inner, base}, {r, base}, {kSpeck * r, apex}, {0, apex}};
  sketch.mesh(geometry::turnedMesh(wallProfile, kSegments), false);
  for (const double radius : {inner, r}) ring(sketch, radius, base);
  meridians(sketch, {{r, base}, {0, apex}}, 3);
  meridians(sketch, {{inner, base}, {0, innerApex}}, 3);
}

void add(const Sketch& sketch, const physics::Capsule& solid) {
  const double r = solid.radius_m, h = 0.5 * solid.height_m;
  sketch.frustum({0, 0, -h}, {0, 0, h}, r, r);
  for (const double z : {-h, h}) {
    sketch.ball({0, 0, z}, r);
    ring(sketch, r, z);
  }
  Profile side = arc(r, 0, 0.5 * kPi), bottom = arc(r, 0.5 * kPi, kPi);
  for (Vector2& p : side) p.y() += h;
  for (Vector2& p : bottom) p.y() -= h;
  meridians(sketch, joined(side, bottom), 4);
}

void addTop(const Sketch& sketch, const Vector3d& h) {
  const auto onRim = [&](double angle) {
    return Vector3d(h.x() * std::cos(angle), h.y() * std::sin(angle), h.z());
  };
  if (std::abs(h.x() - h.y()) < 1e-9 * h.x())
    sketch.frustum({0, 0, 0}, {0, 0, h.z()}, 0, h.x());
  else
    sketch.mesh(geometry::transformed(geometry::frustumMesh(kSpeck, 1, 0, 1, kSegments), h.asDiagonal()), false);
  sketch.mark(loop(96, onRim), true);
  for (int i = 0; i < 4; ++i) {
    const double width = i == 0 ? kHeavy : 1;
    sketch.mark({{0, 0, 0}, onRim(0.5 * kPi * i)}, false, width);
    sketch.mark({{0, 0, h.z()}, onRim(0.5 * kPi * i)}, false, width);
  }
}

}  // namespace poinsot::stage
