// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "physics/mass_properties.h"
#include "physics/solid_check.h"

namespace poinsot::physics {
namespace {

double cube(double a) { return a * a * a; }

double volumePerCube(PolyhedronKind kind) {
  switch (kind) {
    case PolyhedronKind::kTetrahedron:
      return std::sqrt(2.0) / 12;
    case PolyhedronKind::kCube:
      return 1;
    case PolyhedronKind::kOctahedron:
      return std::sqrt(2.0) / 3;
    case PolyhedronKind::kDodecahedron:
      return (15 + 7 * std::sqrt(5.0)) / 4;
    case PolyhedronKind::kIcosahedron:
      break;
  }
  return 5 * (3 + std::sqrt(5.0)) / 12;
}

struct Volume {
  double operator()(const Box& s) const { return s.edges_m[0] * s.edges_m[1] * s.edges_m[2]; }
  double operator()(const HollowBox& s) const {
    // Computes abc - a'b'c' as a sum of positive terms, so that thin walls lose no digits.
    const double gap = 2 * s.wall_m, b = s.edges_m[1], c = s.edges_m[2];
    const double a1 = s.edges_m[0] - gap, b1 = b - gap;
    return gap * (b * c + a1 * c + a1 * b1);
  }
  double operator()(const Ellipsoid& s) const {
    return 4 * std::numbers::pi / 3 * (s.semiAxes_m[0] * s.semiAxes_m[1] * s.semiAxes_m[2]);
  }
  double operator()(const Sphere& s) const {
    const double r = s.radius_m, i = s.innerRadius_m;
    return 4 * std::numbers::pi / 3 * ((r - i) * (r * r + r * i + i * i));
  }
  double operator()(const Hemisphere& s) const { return 2 * std::numbers::pi / 3 * cube(s.radius_m); }
  double operator()(const Cylinder& s) const {
    return std::numbers::pi * ((s.radius_m - s.innerRadius_m) * (s.radius_m + s.innerRadius_m)) * s.height_m;
  }
  double operator()(const Cone& s) const { return std::numbers::pi / 3 * (s.radius_m * s.radius_m) * s.height_m; }
  double operator()(const Torus& s) const {
    return 2 * std::numbers::pi * std::numbers::pi * s.radius_m * (s.tubeRadius_m * s.tubeRadius_m);
  }
  double operator()(const Capsule& s) const {
    return std::numbers::pi * (s.radius_m * s.radius_m) * (s.height_m + 4 * s.radius_m / 3);
  }
  double operator()(const Polyhedron& s) const { return volumePerCube(s.kind) * cube(s.edge_m); }
  double operator()(const THandle& s) const {
    return std::numbers::pi *
           (s.barRadius_m * s.barRadius_m * s.barLength_m + s.shaftRadius_m * s.shaftRadius_m * s.shaftLength_m);
  }
  double operator()(const WingNut& s) const {
    return std::numbers::pi * (s.hubRadius_m * s.hubRadius_m) * s.hubHeight_m +
           2 * (s.wing_m[0] * s.wing_m[1] * s.wing_m[2]);
  }
  template <typename Thin>
  double operator()(const Thin&) const {
    return 0;
  }
};

}  // namespace

double volume(const Solid& solid) {
  requirePossible(solid);
  return std::visit(Volume{}, solid);
}

}  // namespace poinsot::physics
