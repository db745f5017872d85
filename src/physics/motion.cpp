// SPDX-License-Identifier: Apache-2.0
#include "physics/motion.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"
#include "physics/rotor.h"

namespace poinsot::physics {

void refuseTime(double t_s) {
  if (!std::isfinite(t_s))
    throw core::limitError(fmt::format("t = {} s: must be a finite number of seconds", t_s));
  throw core::limitError(fmt::format(
      "t = {} s: too far from the start; either |omega t| is larger than {:g}, or the motion exceeds the "
      "range of numbers; choose a time nearer to 0",
      t_s, kFarthestPhase_rad / 2));
}

std::vector<RigidBodyState> Motion::at(std::span<const double> times_s) const {
  std::vector<RigidBodyState> states;
  states.reserve(times_s.size());
  for (const double t_s : times_s) try {
      states.push_back(at(t_s));
    } catch (const core::Error& error) {
      throw core::Error(error.kind(), fmt::format("times_s[{}]: {}", states.size(), error.message()));
    }
  return states;
}

Eigen::Vector3d turningRate_B(const Motion& motion, const RigidBodyState& state) {
  const double alpha = motion.dissipation();
  if (alpha == 0) return state.omega_B;
  return state.omega_B + alpha * motion.axes().angularMomentum(state.omega_B).cross(state.omega_B);
}

Eigen::Vector3d turningRate_W(const Motion& motion, const RigidBodyState& state) {
  if (motion.dissipation() == 0) return state.omega_W;
  return rotated(state.q_WB, turningRate_B(motion, state));
}

}  // namespace poinsot::physics
