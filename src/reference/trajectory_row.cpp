// SPDX-License-Identifier: Apache-2.0
#include "reference/trajectory_row.h"

namespace poinsot::reference {

TrajectoryRow trajectoryRow(const physics::Motion& motion, const physics::RigidBodyState& s) {
  const Eigen::Vector3d rate_B = physics::turningRate_B(motion, s);
  const Eigen::Vector3d rate_W = physics::turningRate_W(motion, s);
  return {s.t_s,           s.q_WB.w(),    s.q_WB.x(),    s.q_WB.y(),    s.q_WB.z(), s.omega_B.x(), s.omega_B.y(),
          s.omega_B.z(),   s.omega_W.x(), s.omega_W.y(), s.omega_W.z(), s.L_W.x(),  s.L_W.y(),     s.L_W.z(),
          s.kineticEnergy, rate_B.x(),    rate_B.y(),    rate_B.z(),    rate_W.x(), rate_W.y(),    rate_W.z()};
}

}  // namespace poinsot::reference
