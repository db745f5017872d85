// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string_view>
#include <variant>

#include "core/abi.h"
#include "physics/unaligned_types.h"

/// Homogeneous bodies with closed-form mass properties. Lengths in m. S: the solid's own axes, origin where the
/// comment says (its centre of mass unless said). Solids of revolution are about z.
namespace poinsot::physics {

struct Box {
  Eigen::Vector3d edges_m;
};
/// A box with walls of constant thickness.
struct HollowBox {
  Eigen::Vector3d edges_m;
  double wall_m = 0;
};
/// A rectangle of no thickness in the xy plane.
struct Plate {
  Vector2 edges_m;
};
struct Ellipsoid {
  Eigen::Vector3d semiAxes_m;
};
/// The matter between two similar, concentric ellipsoids that nearly touch.
struct EllipsoidShell {
  Eigen::Vector3d semiAxes_m;
};
/// A ball, hollow where innerRadius_m > 0.
struct Sphere {
  double radius_m = 0;
  double innerRadius_m = 0;
};
struct SphereShell {
  double radius_m = 0;
};
/// Half a ball: origin at the centre of its flat face, dome towards +z; the centre of mass is at z = 3r/8.
struct Hemisphere {
  double radius_m = 0;
};
/// A cylinder, a tube where innerRadius_m > 0.
struct Cylinder {
  double radius_m = 0;
  double height_m = 0;
  double innerRadius_m = 0;
};
/// The wall of a cylinder without its ends.
struct CylinderShell {
  double radius_m = 0;
  double height_m = 0;
};
/// A disc of no thickness in the xy plane.
struct Disc {
  double radius_m = 0;
};
/// A thin ring in the xy plane.
struct Hoop {
  double radius_m = 0;
};
/// A thin straight rod along x.
struct Rod {
  double length_m = 0;
};
/// A cone: origin at its centre of mass, a quarter of the height above the base, apex towards +z.
struct Cone {
  double radius_m = 0;
  double height_m = 0;
};
/// The side of a cone without its base: origin at its centre of mass, a third of the height above the base.
struct ConeShell {
  double radius_m = 0;
  double height_m = 0;
};
struct Torus {
  double radius_m = 0;      ///< of the circle that its tube follows
  double tubeRadius_m = 0;  ///< < radius_m
};
struct TorusShell {
  double radius_m = 0;
  double tubeRadius_m = 0;
};
/// A cylinder with half balls on its ends.
struct Capsule {
  double radius_m = 0;
  double height_m = 0;  ///< of the cylinder between the half balls
};
enum class PolyhedronKind { kTetrahedron, kCube, kOctahedron, kDodecahedron, kIcosahedron };
/// A regular polyhedron.
struct Polyhedron {
  PolyhedronKind kind = PolyhedronKind::kCube;
  double edge_m = 0;
};

// Bodies of several pieces of one density (per volume, or per length where the pieces are thin).

/// A plate of two arms, in the xy plane: outer corner at the origin, one arm along +x, one along +y.
struct LPlate {
  Vector2 edges_m;   ///< outer lengths along x and y
  double arm_m = 0;  ///< width of both arms
};
/// A T of two round bars of one density: the bar centred at the origin along x, the shaft from the bar's surface
/// along +y.
struct THandle {
  double barLength_m = 0, barRadius_m = 0;
  double shaftLength_m = 0, shaftRadius_m = 0;
};
/// A hoop in the xy plane and a thin handle from its rim along -x, masses 17 : 16 (0.17 kg and 0.16 kg). Origin at
/// the hoop's centre.
struct Racket {
  double length_m = 0;  ///< over all, along x
  double width_m = 0;   ///< of the hoop, along y
};
/// A hub about z, centred at the origin, with two boxes for wings along ±x.
struct WingNut {
  double hubRadius_m = 0, hubHeight_m = 0;
  Eigen::Vector3d wing_m{0, 0, 0};  ///< edges of a wing
  double wingCentre_m = 0;          ///< its centre at x = ± this
  double wingRise_m = 0;            ///< and z = this, from the hub's centre
};

using Solid = std::variant<Box, HollowBox, Plate, Ellipsoid, EllipsoidShell, Sphere, SphereShell, Hemisphere,
                           Cylinder, CylinderShell, Disc, Hoop, Rod, Cone, ConeShell, Torus, TorusShell, Capsule,
                           Polyhedron, LPlate, THandle, Racket, WingNut>;

static_assert(core::laidOut<Plate, 16>() && core::laidOut<LPlate, 24>() && core::laidOut<Solid, 64>());

}  // namespace poinsot::physics
