// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/abi.h"
#include "physics/motion.h"
#include "physics/unaligned_types.h"

namespace poinsot::physics {

/// Circular cone that rolls on a level table without slipping, at a constant rate, while its apex stays at one
/// point of the table (lecture: "cone rolling on a plane", Assignment 7). In W, the table is the plane z = 0
/// through the apex. The line of contact makes the angle phi with x, and turns at the rate Omega_v = phi'. With
/// the half-angle alpha and the unit vectors e_rho along the line of contact, e_phi = z × e_rho, and a from the
/// apex to the centre of the base:
///
///   a = cos alpha e_rho + sin alpha z
///   omega = -Omega_v cot alpha e_rho = Omega_v z - (Omega_v/sin alpha) a
///
/// The points of the line of contact are at rest, because omega lies along it. Moments are about the apex: I_a
/// about a (`along`), and I_t across it (`across`).
struct RollingCone {
  Eigen::Vector3d axis_B{0, 0, 0};  ///< a in the body, of unit length
  double radius_m = 0;              ///< radius of the base
  double height_m = 0;
  double rate = 0;               ///< Omega_v, rad/s, positive counter-clockwise seen from above
  double across = 0, along = 0;  ///< I_t and I_a, kg·m²

  double slant_m() const;
  double sinAlpha() const;
  double cosAlpha() const;
  double cotAlpha() const { return height_m / radius_m; }
  double halfAngle_rad() const;

  /// Returns the component of omega along e_rho, -Omega_v cot alpha, rad/s.
  double alongContact() const { return -rate * cotAlpha(); }
  /// Returns the second part of omega, along a: -Omega_v/sin alpha, rad/s.
  double spin() const { return -rate / sinAlpha(); }
  /// Returns the kinetic energy, J: half of I_a (omega·a)² + I_t |omega × a|².
  double kineticEnergy() const;
  /// Returns L about the apex along e_rho, e_phi and z, kg·m²/s. These components are constant.
  Eigen::Vector3d angularMomentum() const;
  /// Returns the torque about the apex, dL/dt = Omega_v z × L, along e_phi, N·m. It is not positive: the table and
  /// the weight give -Omega_v² cot alpha (I_t sin² alpha + I_a cos² alpha).
  double torque() const;

  /// Returns the attitude at time t_s. At t = 0, the axis a leans towards -y.
  /// @throws core::Error(kLimit) if the angle of the spin exceeds kFarthestPhase_rad.
  Quaternion q_WB(double t_s) const;
  /// Returns the unit vector e_rho at time t_s.
  /// @throws as q_WB().
  Eigen::Vector3d contact_W(double t_s) const;
};

/// Makes a rolling cone of a body.
/// @param axes  principal axes about the apex
/// @param axis_B  direction from the apex to the centre of the base; any length
/// @throws core::Error(kPhysics) if a length or the rate is not finite and not positive (the rate may be
/// negative), or if the cone cannot roll uniformly: axis_B is not a principal axis, or the moments across it
/// differ by more than 1e-9.
RollingCone rollingCone(const PrincipalAxes& axes, const Eigen::Vector3d& axis_B, double radius_m, double height_m,
                        double rate);

/// Forces on a rolling cone from the table and at the apex, in uniform gravity.
struct RollingForces {
  double normal_N = 0;  ///< normal force, M g
  /// Distance from the apex, along the line of contact, at which the normal force acts, m:
  ///   d cos alpha + Omega_v² cot alpha (I_t sin² alpha + I_a cos² alpha)/(M g)
  double place_m = 0;
  /// Horizontal force along the line of contact, towards the apex, N: M Omega_v² d cos alpha. It has no torque
  /// about the apex.
  double inward_N = 0;
  /// Largest |Omega_v|, rad/s, at which the normal force is still on the cone. A faster cone tips over the rim of
  /// its base. 0 if the cone tips at rest already.
  double fastest = 0;

  /// Returns whether the place of the normal force is within the cone's slant height.
  bool holds(const RollingCone& cone) const { return place_m <= cone.slant_m(); }
};

/// @param mass_kg  mass; `centre_m` is the distance d of the centre of mass from the apex
/// @param g  acceleration of gravity, m/s²
/// @throws core::Error(kPhysics) if a number is not finite and positive.
RollingForces rollingForces(const RollingCone& cone, double mass_kg, double centre_m, double g);

/// Motion of a rolling cone in closed form, at any time. Immutable and thread-safe. L is about the apex.
class RollingMotion final : public Motion {
 public:
  /// @param cone  result of rollingCone() with the same axes
  RollingMotion(const PrincipalAxes& axes, const RollingCone& cone) : axes_(axes), cone_(cone) {}

  /// Returns the state at motion time t_s (seconds).
  /// @throws core::Error(kLimit) for a time that is not finite, or beyond kFarthestPhase_rad.
  RigidBodyState at(double t_s) const override;
  using Motion::at;

  const PrincipalAxes& axes() const override { return axes_; }
  double dissipation() const override { return 0; }
  const RollingCone& cone() const { return cone_; }
  /// Returns the torque about the apex in W, dL/dt, N·m.
  Eigen::Vector3d torque_W(double t_s) const;

 private:
  PrincipalAxes axes_;
  RollingCone cone_;
};

static_assert(core::laidOut<RollingCone, 64>() && core::laidOut<RollingForces, 32>());

}  // namespace poinsot::physics
