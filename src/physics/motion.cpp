// SPDX-License-Identifier: Apache-2.0
#include "physics/motion.h"

namespace poinsot::physics {

Eigen::Vector3d turningRate_B(const Motion& motion, const RigidBodyState& state) {
  const double alpha = motion.dissipation();
  if (alpha == 0) return state.omega_B;
  return state.omega_B + alpha * motion.axes().angularMomentum(state.omega_B).cross(state.omega_B);
}

}  // namespace poinsot::physics
