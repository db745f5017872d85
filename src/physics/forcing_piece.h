// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "physics/forcing.h"
#include "physics/principal_axes.h"

namespace poinsot::physics {

/// A torque that is linear in time, N·m.
struct LinearTorque {
  std::array<double, 3> start{};  ///< at the reference time
  std::array<double, 3> slope{};  ///< per second

  std::array<double, 3> at(double sinceReference_s) const {
    return {start[0] + sinceReference_s * slope[0], start[1] + sinceReference_s * slope[1],
            start[2] + sinceReference_s * slope[2]};
  }
  bool zero() const { return start == std::array<double, 3>{} && slope == std::array<double, 3>{}; }
};

/// The table's torque at an instant, N·m; at a jump, that of the instants after.
Eigen::Vector3d torqueAt(const TorqueHistory& history, double t_s);

/// A stretch of time in which the explicit torques are smooth: between two knots of their tables. Their formulas
/// hold beyond its ends too, where the stages of a step may reach.
struct ForcingPiece {
  double begin_s = 0;  ///< the end nearer to 0; the reference time of the torques
  double end_s = 0;    ///< before begin_s where time runs backwards
  LinearTorque torque_P;
  LinearTorque torque_W;
};

/// The pieces from time 0 to end_s (either sign), in the order in which they are met. None for end_s = 0.
std::vector<ForcingPiece> forcingPieces(const Forcing& forcing, const PrincipalAxes& axes, double end_s);

}  // namespace poinsot::physics
