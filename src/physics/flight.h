// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "core/abi.h"
#include "physics/rigid_body_state.h"

namespace poinsot::physics {

/// Highest point of a flight. t_s is its motion time, which is 0 or less if the body never rises. rise_m is its
/// height above the position at motion time 0.
struct FlightTop {
  double t_s = 0;
  double rise_m = 0;
};

/// Flight of the centre of mass under uniform gravity (eq 1 to 10). Gravity has no torque about the centre of
/// mass, so that the rotation is free. Position (m) and velocity (m/s) are those at motion time 0. Gravity is in
/// m/s².
struct Flight {
  Eigen::Vector3d position_W = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity_W = Eigen::Vector3d::Zero();
  Eigen::Vector3d gravity_W = Eigen::Vector3d(0, 0, -9.80665);

  /// Returns position + velocity t + gravity t²/2, in m.
  /// @throws core::Error(kLimit), as velocityAt() does, if the result is beyond the range of numbers.
  Eigen::Vector3d positionAt(double t_s) const;
  Eigen::Vector3d velocityAt(double t_s) const;
  /// Returns the point at which the velocity has no component along gravity. Without gravity, its time and height
  /// are 0.
  FlightTop top() const;
};

/// Momenta, energies, force and torque of a body that flies and rotates, at one time, in W.
struct FlightQuantities {
  Eigen::Vector3d P_W;             ///< momentum M V_cm, kg·m/s (eq 1)
  Eigen::Vector3d orbital_W;       ///< angular momentum of the centre of mass, R_cm × P, kg·m²/s (eq 5)
  Eigen::Vector3d intrinsic_W;     ///< angular momentum L about the centre of mass, kg·m²/s (eq 6)
  Eigen::Vector3d total_W;         ///< total angular momentum L_tot = orbital + intrinsic (eq 5)
  Eigen::Vector3d force_W;         ///< force dP/dt = M g, N (eq 1)
  Eigen::Vector3d torque_W;        ///< torque dL_tot/dt = R_cm × M g about the origin, N·m (eq 1, 8)
  double translationalEnergy = 0;  ///< energy of translation M V_cm²/2, J (eq 10)
  double rotationalEnergy = 0;     ///< energy of rotation omega·I·omega/2, J (eq 12)
  double potentialEnergy = 0;      ///< potential energy -M g·R_cm, J

  double kineticEnergy() const { return translationalEnergy + rotationalEnergy; }
};

/// Returns the quantities of a body at the time of `state`, which holds the rotation about the centre of mass. If
/// `mass_kg` is NaN, the mass is unknown, and the quantities that depend on it are NaN.
/// @throws core::Error(kLimit) if a quantity is beyond the range of numbers at that time.
FlightQuantities flightQuantities(double mass_kg, const Flight& flight, const RigidBodyState& state);

static_assert(core::laidOut<Flight, 72>() && core::laidOut<FlightQuantities, 168>());

}  // namespace poinsot::physics
