// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string_view>
#include <variant>

#include "core/abi.h"
#include "physics/unaligned_types.h"

/// Homogeneous bodies with closed-form mass properties. Lengths are in m. S are the solid's own axes, with the
/// origin at the centre of mass unless a comment places it elsewhere. Solids of revolution are about z.
namespace poinsot::physics {

struct Box {
  Eigen::Vector3d edges_m;
};
/// Box with walls of constant thickness.
struct HollowBox {
  Eigen::Vector3d edges_m;
  double wall_m = 0;
};
/// Rectangle without thickness in the xy plane.
struct Plate {
  Vector2 edges_m;
};
struct Ellipsoid {
  Eigen::Vector3d semiAxes_m;
};
/// Thin shell between two similar, concentric ellipsoids.
struct EllipsoidShell {
  Eigen::Vector3d semiAxes_m;
};
/// Ball, hollow if innerRadius_m > 0.
struct Sphere {
  double radius_m = 0;
  double innerRadius_m = 0;
};
struct SphereShell {
  double radius_m = 0;
};
/// Half a ball with the dome towards +z. The origin is the centre of the flat face; the centre of mass is at z =
/// 3r/8.
struct Hemisphere {
  double radius_m = 0;
};
/// Cylinder, or a tube if innerRadius_m > 0.
struct Cylinder {
  double radius_m = 0;
  double height_m = 0;
  double innerRadius_m = 0;
};
/// Wall of a cylinder, without its ends.
struct CylinderShell {
  double radius_m = 0;
  double height_m = 0;
};
/// Disc without thickness in the xy plane.
struct Disc {
  double radius_m = 0;
};
/// Thin ring in the xy plane.
struct Hoop {
  double radius_m = 0;
};
/// Thin straight rod along x.
struct Rod {
  double length_m = 0;
};
/// Cone with the apex towards +z. The origin is its centre of mass, a quarter of the height above the base.
struct Cone {
  double radius_m = 0;
  double height_m = 0;
};
/// Side of a cone, without its base. The origin is its centre of mass, a third of the height above the base.
struct ConeShell {
  double radius_m = 0;
  double height_m = 0;
};
/// Torus about z. The centre line of its tube is a circle of radius_m. tubeRadius_m is less than radius_m.
struct Torus {
  double radius_m = 0;
  double tubeRadius_m = 0;
};
struct TorusShell {
  double radius_m = 0;
  double tubeRadius_m = 0;
};
/// Cylinder of height_m with half balls on its ends.
struct Capsule {
  double radius_m = 0;
  double height_m = 0;
};
enum class PolyhedronKind { kTetrahedron, kCube, kOctahedron, kDodecahedron, kIcosahedron };
struct Polyhedron {
  PolyhedronKind kind = PolyhedronKind::kCube;
  double edge_m = 0;
};

// Bodies of several pieces. All pieces have the same density, except in the racket.

/// Plate of two arms in the xy plane, with the outer corner at the origin. The arms, of width arm_m, lie along +x
/// and +y; edges_m are the outer lengths along x and y.
struct LPlate {
  Vector2 edges_m;
  double arm_m = 0;
};
/// T-shaped handle of two round bars. The bar lies along x, centred at the origin. The shaft runs along +y, from
/// the surface of the bar.
struct THandle {
  double barLength_m = 0, barRadius_m = 0;
  double shaftLength_m = 0, shaftRadius_m = 0;
};
/// Hoop of diameter width_m in the xy plane, with a thin handle from its rim along -x. length_m is the overall
/// length. The masses of hoop and handle are as 17 : 16 (0.17 kg and 0.16 kg). The origin is the hoop's centre.
struct Racket {
  double length_m = 0;
  double width_m = 0;
};
/// Wing nut: a round hub about z, centred at the origin, and two boxes with the edges wing_m as wings. The centres
/// of the wings are at x = ± wingCentre_m, z = wingRise_m.
struct WingNut {
  double hubRadius_m = 0, hubHeight_m = 0;
  Eigen::Vector3d wing_m{0, 0, 0};
  double wingCentre_m = 0;
  double wingRise_m = 0;
};

using Solid = std::variant<Box, HollowBox, Plate, Ellipsoid, EllipsoidShell, Sphere, SphereShell, Hemisphere,
                           Cylinder, CylinderShell, Disc, Hoop, Rod, Cone, ConeShell, Torus, TorusShell, Capsule,
                           Polyhedron, LPlate, THandle, Racket, WingNut>;

static_assert(core::laidOut<Plate, 16>() && core::laidOut<LPlate, 24>() && core::laidOut<Solid, 64>());

}  // namespace poinsot::physics
