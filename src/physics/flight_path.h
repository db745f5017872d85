// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>

#include "core/abi.h"
#include "physics/flight.h"
#include "physics/forcing.h"
#include "physics/motion.h"

namespace poinsot::physics {

/// Flight of the centre of mass of a body under gravity and under forces at points of the body (eq 1): dP/dt is
/// the sum of the forces. Immutable and thread-safe. Copies are cheap.
///
/// Forces of constant direction in space give parabolas. The direction of a force that turns with the body is
/// expanded in Chebyshev polynomials of time, in intervals so short that the first omitted terms are below 1e-12,
/// or below the accuracy of the rotation. The polynomials are integrated twice.
class FlightPath {
 public:
  FlightPath() = default;
  /// Makes the flight under gravity alone, a parabola.
  // NOLINTNEXTLINE(google-explicit-constructor): every parabola is a flight, exactly.
  FlightPath(const Flight& flight) : gravity_(flight) {}

  /// Makes the flight under gravity and under the forces of the motion, over the span of the motion.
  /// @param motion  rotation of the body; a FreeMotion has no forces
  /// @throws core::Error(kPhysics) if there are forces and the mass is not positive and finite; (kLimit) if a
  /// force that turns with the body needs more than 200000 intervals.
  FlightPath(const Flight& flight, double mass_kg, const Motion& motion);

  /// Returns the position of the centre of mass, m.
  /// @throws core::Error(kLimit), as velocityAt() does, for a time outside the span if there are forces, or if the
  /// result is beyond the range of numbers.
  Eigen::Vector3d positionAt(double t_s) const;
  Eigen::Vector3d velocityAt(double t_s) const;

  /// Returns the flight that gravity alone would give from the same start.
  const Flight& gravityAlone() const { return gravity_; }
  bool hasForces() const { return pushed_ != nullptr; }

 private:
  struct Pushed;

  Flight gravity_;
  std::shared_ptr<const Pushed> pushed_;  // change of the flight by the forces; null without forces
};

/// Returns the quantities of a body under gravity, forces at its points and other torques. The force is the sum of
/// the weight and the forces. The torque about the origin is R_cm × force, plus the torque about the centre of
/// mass.
/// @throws core::Error(kLimit) as flightQuantities() in flight.h does.
FlightQuantities flightQuantities(double mass_kg, const FlightPath& path, const Forcing& forcing,
                                  const PrincipalAxes& axes, const RigidBodyState& state);

static_assert(core::laidOut<FlightPath, 88>());

}  // namespace poinsot::physics
