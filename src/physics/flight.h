// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "core/abi.h"
#include "physics/rigid_body_state.h"

namespace poinsot::physics {

/// The highest point of a flight, against gravity.
struct FlightTop {
  double t_s = 0;     ///< motion time; not after 0 where it does not rise
  double rise_m = 0;  ///< above its place at motion time 0
};

/// Flight of the centre of mass under uniform gravity, which has no torque about it (eq 1 to 10): the rotation is
/// as free as without.
struct Flight {
  Eigen::Vector3d position_W = Eigen::Vector3d::Zero();         ///< at motion time 0, m
  Eigen::Vector3d velocity_W = Eigen::Vector3d::Zero();         ///< at motion time 0, m/s
  Eigen::Vector3d gravity_W = Eigen::Vector3d(0, 0, -9.80665);  ///< m/s²

  /// position + velocity t + gravity t²/2.
  /// @throws core::Error(kLimit), as velocityAt(), for a time at which it is beyond the range of numbers.
  Eigen::Vector3d positionAt(double t_s) const;
  Eigen::Vector3d velocityAt(double t_s) const;
  /// Where V has no part along gravity. Without gravity there is none: time and height are 0.
  FlightTop top() const;
};

/// Momenta and energies of a body that flies and turns, at one time, and what changes them. Points and axes of W.
struct FlightQuantities {
  Eigen::Vector3d P_W;             ///< M V_cm, kg·m/s (eq 1)
  Eigen::Vector3d orbital_W;       ///< R_cm × P, kg·m²/s (eq 5)
  Eigen::Vector3d intrinsic_W;     ///< L, kg·m²/s (eq 6)
  Eigen::Vector3d total_W;         ///< L_tot, their sum (eq 5)
  Eigen::Vector3d force_W;         ///< dP/dt = M g, N (eq 1)
  Eigen::Vector3d torque_W;        ///< dL_tot/dt = R_cm × M g about the origin, N·m (eq 1, 8)
  double translationalEnergy = 0;  ///< M V_cm²/2, J (eq 10)
  double rotationalEnergy = 0;     ///< omega·I·omega/2, J (eq 12)
  double potentialEnergy = 0;      ///< -M g·R_cm, J

  double kineticEnergy() const { return translationalEnergy + rotationalEnergy; }  ///< eq (10)
};

/// Returns the quantities of a body at the time of `state`, its rotation about the centre of mass. If `mass_kg` is
/// NaN, it is unknown, and so are they.
/// @throws core::Error(kLimit) for a time at which one of them is beyond the range of numbers.
FlightQuantities flightQuantities(double mass_kg, const Flight& flight, const RigidBodyState& state);

static_assert(core::laidOut<Flight, 72>() && core::laidOut<FlightQuantities, 168>());

}  // namespace poinsot::physics
