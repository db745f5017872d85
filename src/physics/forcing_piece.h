// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "physics/forcing.h"
#include "physics/principal_axes.h"

namespace poinsot::physics {

/// Torque that changes linearly with time: `start` (N·m) is its value at a reference time, `slope` (N·m/s) its
/// rate of change.
struct LinearTorque {
  std::array<double, 3> start{};
  std::array<double, 3> slope{};

  std::array<double, 3> at(double sinceReference_s) const {
    return {start[0] + sinceReference_s * slope[0], start[1] + sinceReference_s * slope[1],
            start[2] + sinceReference_s * slope[2]};
  }
  bool zero() const { return start == std::array<double, 3>{} && slope == std::array<double, 3>{}; }
};

/// Returns the torque of a table at a time, N·m. At a jump, returns the torque after the jump.
Eigen::Vector3d torqueAt(const TorqueHistory& history, double t_s);

/// Torque of forces of constant direction in space, at points of the body. It depends on the attitude alone.
/// Column c is the sum of lever times F_c over the forces, along P, where F_c is the component of a force along
/// axis c of W. The torque is the sum of (R column c) × (unit vector c of W).
struct LeverTorque {
  std::array<std::array<double, 3>, 3> columns_P{};

  bool zero() const { return columns_P == std::array<std::array<double, 3>, 3>{}; }
};

/// Time interval between two neighbouring times at which a torque table or a force changes. The given torques are
/// smooth in it. They can be evaluated beyond its ends, too, because the stages of a step may leave the interval.
struct ForcingPiece {
  double begin_s = 0;  ///< end of the piece nearer to time 0; reference time of the torques
  double end_s = 0;    ///< less than begin_s if time runs backwards
  LinearTorque torque_P;
  LinearTorque torque_W;
  LeverTorque lever;
  bool hasForces = false;  ///< whether forces act on the body at some time, in this piece or in another
};

/// Returns the times from 0 to end_s (either sign), both included, at which a torque table or a force changes, in
/// the order of integration.
std::vector<double> forcingTimes(const Forcing& forcing, double end_s);

/// Divides the time from 0 to end_s (either sign) into pieces, in the order of integration. Returns no piece if
/// end_s is 0.
std::vector<ForcingPiece> forcingPieces(const Forcing& forcing, const PrincipalAxes& axes, double end_s);

}  // namespace poinsot::physics
