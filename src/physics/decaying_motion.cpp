// SPDX-License-Identifier: Apache-2.0
#include "physics/decaying_motion.h"

#include <cmath>

#include "physics/transcendental.h"

namespace poinsot::physics {

RigidBodyState DecayingMotion::at(double t_s) const {
  const auto state = find(t_s);
  if (!state) refuseTime(t_s);
  return *state;
}

std::optional<RigidBodyState> DecayingMotion::find(double t_s) const {
  if (!std::isfinite(t_s) || -rate_ * t_s > kLargestExponent) return std::nullopt;
  const double tau = rate_ == 0 ? t_s : -exponentialLessOne(-rate_ * t_s) / rate_;
  if (!free_.reaches(tau)) return std::nullopt;
  RigidBodyState state = free_.at(tau);
  if (rate_ == 0) return state;
  const double left = exponential(-rate_ * t_s);
  state.t_s = t_s;
  state.omega_B *= left;
  state.omega_W *= left;
  state.L_W *= left;
  state.kineticEnergy *= left * left;
  const bool finite = state.omega_B.allFinite() && state.omega_W.allFinite() && state.L_W.allFinite();
  return finite && std::isfinite(state.kineticEnergy) ? std::optional(state) : std::nullopt;
}

}  // namespace poinsot::physics
