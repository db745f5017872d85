// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "core/abi.h"
#include "physics/solid.h"
#include "physics/unaligned_types.h"

namespace poinsot::physics {

/// Mass, centre of mass and inertia tensor of a piece of matter in axes B. Impossible values are rejected. Points,
/// rods and plates are allowed, so that a moment may be 0.
class MassProperties {
 public:
  /// @param inertia_B tensor about the centre of mass, in B, kg·m²
  /// @throws core::Error(kPhysics) naming a value that is not finite, a mass that is not positive, a tensor that
  /// is not symmetric, or impossible moments (negative, or I3 > I1 + I2).
  MassProperties(double mass_kg, const Eigen::Vector3d& centre_B, const Eigen::Matrix3d& inertia_B);

  static MassProperties ofPoint(double mass_kg, const Eigen::Vector3d& position_B);

  /// Creates mass properties from a tensor about another point: I_cm = I - M(a² - a a), where a points from the
  /// centre of mass to `point_B` (eq 14).
  /// @param inertia_B tensor about point_B, in B, kg·m²
  /// @throws core::Error(kPhysics) as the constructor does, if the tensor about the centre of mass is impossible.
  static MassProperties fromInertiaAbout(const Eigen::Vector3d& point_B, double mass_kg,
                                         const Eigen::Vector3d& centre_B, const Eigen::Matrix3d& inertia_B);

  double mass_kg() const { return mass_kg_; }
  const Eigen::Vector3d& centre_B() const { return centre_B_; }
  /// Returns the tensor about the centre of mass, kg·m² (eq 7).
  const Eigen::Matrix3d& inertia_B() const { return inertia_B_; }
  /// Returns the tensor about another point: I_cm + M(a² - a a), where a points from the centre of mass to
  /// `point_B` (eq 14).
  /// @throws core::Error(kPhysics) if the point is not finite, or is so far away that the tensor is not finite.
  Eigen::Matrix3d inertiaAbout(const Eigen::Vector3d& point_B) const;

  /// Returns the mass properties of this matter, first rotated by q about the origin, then moved by `offset_B` (eq
  /// 16).
  /// @throws core::Error(kPhysics) for a zero or non-finite quaternion, or an offset that is not finite.
  MassProperties moved(const Quaternion& q, const Eigen::Vector3d& offset_B) const;

 private:
  /// @param scale_kgm2 moment whose rounding error is accepted, if it is larger than the tensor's own moments
  MassProperties(double mass_kg, const Eigen::Vector3d& centre_B, const Eigen::Matrix3d& inertia_B,
                 double scale_kgm2);

  double mass_kg_;
  Eigen::Vector3d centre_B_;
  Eigen::Matrix3d inertia_B_;
};

/// Joins two pieces by the displaced-axis theorem (eq 14).
MassProperties operator+(const MassProperties& a, const MassProperties& b);

/// Joins several pieces into one. The sums are in double-double, so that a symmetric arrangement of pieces gives a
/// body that is symmetric to the last bit.
/// @pre at least one piece.
MassProperties combined(const std::vector<MassProperties>& pieces);

/// Returns the mass properties of a solid in its own axes S.
/// @throws core::Error(kPhysics) for a mass or a length that is not positive and finite, lengths that do not fit
/// together, or a kind of polyhedron that does not exist.
MassProperties massProperties(const Solid& solid, double mass_kg);

/// Returns the volume, m³; 0 for shells, plates, hoops and rods, which have no density per volume.
/// @throws as massProperties().
double volume(const Solid& solid);

/// Solid placed in a body: turned by q_BS, then moved so that the origin of S is at offset_B (m).
struct SolidPart {
  Solid solid;
  double mass_kg = 1;
  Quaternion q_BS = Quaternion::Identity();
  Eigen::Vector3d offset_B = Eigen::Vector3d::Zero();
};

/// Returns the part's mass properties in the body's axes.
/// @throws as massProperties() of the solid and MassProperties::moved().
MassProperties massProperties(const SolidPart& part);

/// Returns the simple solids of a composite solid (L plate, T-handle, racket, wing nut), with masses that add up
/// to `mass_kg`. Any other solid is returned alone.
std::vector<SolidPart> partsOf(const Solid& solid, double mass_kg);

static_assert(core::laidOut<MassProperties, 104>() && core::laidOut<SolidPart, 128>());

}  // namespace poinsot::physics
