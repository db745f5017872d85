// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "physics/forcing.h"
#include "physics/principal_axes.h"

namespace poinsot::physics {

/// Torque that is linear in time: `start` (N·m) at a reference time, plus `slope` (N·m/s) times the time since.
struct LinearTorque {
  std::array<double, 3> start{};
  std::array<double, 3> slope{};

  std::array<double, 3> at(double sinceReference_s) const {
    return {start[0] + sinceReference_s * slope[0], start[1] + sinceReference_s * slope[1],
            start[2] + sinceReference_s * slope[2]};
  }
  bool zero() const { return start == std::array<double, 3>{} && slope == std::array<double, 3>{}; }
};

/// Returns the table's torque at an instant, N·m; at a jump, the torque just after it.
Eigen::Vector3d torqueAt(const TorqueHistory& history, double t_s);

/// Stretch of time between two knots of the torque tables, in which the given torques are smooth. The torque
/// formulas also hold beyond its ends, which the stages of a step may pass.
struct ForcingPiece {
  double begin_s = 0;  ///< end nearer to time 0; reference time of the torques
  double end_s = 0;    ///< less than begin_s if time runs backwards
  LinearTorque torque_P;
  LinearTorque torque_W;
};

/// Returns the pieces from time 0 to end_s (either sign), in the order of integration; none if end_s is 0.
std::vector<ForcingPiece> forcingPieces(const Forcing& forcing, const PrincipalAxes& axes, double end_s);

}  // namespace poinsot::physics
