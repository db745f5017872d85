// SPDX-License-Identifier: Apache-2.0
#include "physics/solid_check.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"

namespace poinsot::physics {
namespace {

// Relative tolerance, so that wings may touch the hub in spite of rounding: 1.1 - 1.2/2 is not 0.5 in doubles.
constexpr double kTouching = 1e-12;

template <typename Vector>
void requireEach(const Vector& lengths_m, const char* name) {
  for (const double length : lengths_m) requirePositive(length, name);
}

void requireInner(double inner_m, double outer_m, const char* name) {
  if (inner_m >= 0 && inner_m < outer_m) return;
  throw core::physicsError(fmt::format(
      "inner radius of the {} must be at least 0 and less than its radius {}, got {}", name, outer_m, inner_m));
}

void requireTorus(double radius_m, double tubeRadius_m) {
  requirePositive(radius_m, "radius of the torus");
  requirePositive(tubeRadius_m, "tube radius of the torus");
  if (tubeRadius_m >= radius_m)
    throw core::physicsError(
        fmt::format("tube radius of the torus must be less than its radius {}, got {}", radius_m, tubeRadius_m));
}

void requireUpright(double radius_m, double height_m, const char* radius, const char* height) {
  requirePositive(radius_m, radius);
  requirePositive(height_m, height);
}

struct Check {
  void operator()(const Box& s) const { requireEach(s.edges_m, "edge of the box"); }
  void operator()(const HollowBox& s) const {
    requireEach(s.edges_m, "edge of the hollow box");
    requirePositive(s.wall_m, "wall of the hollow box");
    if (2 * s.wall_m >= s.edges_m.minCoeff())
      throw core::physicsError(
          fmt::format("two walls of the hollow box must be less than its least edge {}, got a wall of {}",
                      s.edges_m.minCoeff(), s.wall_m));
  }
  void operator()(const Plate& s) const { requireEach(s.edges_m, "edge of the plate"); }
  void operator()(const Ellipsoid& s) const { requireEach(s.semiAxes_m, "semi-axis of the ellipsoid"); }
  void operator()(const EllipsoidShell& s) const { requireEach(s.semiAxes_m, "semi-axis of the ellipsoid shell"); }
  void operator()(const Sphere& s) const {
    requirePositive(s.radius_m, "radius of the sphere");
    requireInner(s.innerRadius_m, s.radius_m, "sphere");
  }
  void operator()(const SphereShell& s) const { requirePositive(s.radius_m, "radius of the sphere shell"); }
  void operator()(const Hemisphere& s) const { requirePositive(s.radius_m, "radius of the hemisphere"); }
  void operator()(const Cylinder& s) const {
    requireUpright(s.radius_m, s.height_m, "radius of the cylinder", "height of the cylinder");
    requireInner(s.innerRadius_m, s.radius_m, "cylinder");
  }
  void operator()(const CylinderShell& s) const {
    requireUpright(s.radius_m, s.height_m, "radius of the cylinder shell", "height of the cylinder shell");
  }
  void operator()(const Disc& s) const { requirePositive(s.radius_m, "radius of the disc"); }
  void operator()(const Hoop& s) const { requirePositive(s.radius_m, "radius of the hoop"); }
  void operator()(const Rod& s) const { requirePositive(s.length_m, "length of the rod"); }
  void operator()(const Cone& s) const {
    requireUpright(s.radius_m, s.height_m, "radius of the cone", "height of the cone");
  }
  void operator()(const ConeShell& s) const {
    requireUpright(s.radius_m, s.height_m, "radius of the cone shell", "height of the cone shell");
  }
  void operator()(const Torus& s) const { requireTorus(s.radius_m, s.tubeRadius_m); }
  void operator()(const TorusShell& s) const { requireTorus(s.radius_m, s.tubeRadius_m); }
  void operator()(const Capsule& s) const {
    requireUpright(s.radius_m, s.height_m, "radius of the capsule", "height of the capsule's cylinder");
  }
  void operator()(const Polyhedron& s) const {
    if (s.kind < PolyhedronKind::kTetrahedron || s.kind > PolyhedronKind::kIcosahedron)
      throw core::physicsError(
          fmt::format("kind of the polyhedron must be 0 to 4, got {}", static_cast<int>(s.kind)));
    requirePositive(s.edge_m, "edge of the polyhedron");
  }
  void operator()(const LPlate& s) const {
    requireEach(s.edges_m, "edge of the L plate");
    requirePositive(s.arm_m, "arm width of the L plate");
    if (s.arm_m >= s.edges_m.minCoeff())
      throw core::physicsError(fmt::format("arm width of the L plate must be less than its least edge {}, got {}",
                                           s.edges_m.minCoeff(), s.arm_m));
  }
  void operator()(const THandle& s) const {
    requirePositive(s.barLength_m, "length of the T-handle's bar");
    requirePositive(s.barRadius_m, "radius of the T-handle's bar");
    requirePositive(s.shaftLength_m, "length of the T-handle's shaft");
    requirePositive(s.shaftRadius_m, "radius of the T-handle's shaft");
  }
  void operator()(const Racket& s) const {
    requirePositive(s.width_m, "width of the racket");
    requirePositive(s.length_m - s.width_m, "length of the racket minus its width");
  }
  void operator()(const WingNut& s) const {
    requireUpright(s.hubRadius_m, s.hubHeight_m, "radius of the wing nut's hub", "height of the wing nut's hub");
    requireEach(s.wing_m, "edge of the wing nut's wing");
    const double inner = s.wingCentre_m - s.wing_m[0] / 2;
    if (!(inner >= s.hubRadius_m * (1 - kTouching)) || !std::isfinite(inner))
      throw core::physicsError(
          fmt::format("wings of the wing nut must not enter its hub of radius {}, got an inner edge at {}",
                      s.hubRadius_m, inner));
    if (!std::isfinite(s.wingRise_m))
      throw core::physicsError(fmt::format("rise of the wing nut's wings must be finite, got {}", s.wingRise_m));
  }
};

}  // namespace

void requirePositive(double value, const char* name) {
  if (std::isfinite(value) && value > 0) return;
  throw core::physicsError(fmt::format("{} must be positive and finite, got {}", name, value));
}

void requirePossible(const Solid& solid) { std::visit(Check{}, solid); }

}  // namespace poinsot::physics
