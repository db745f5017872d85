// SPDX-License-Identifier: Apache-2.0
#include "physics/decaying_motion.h"

#include "core/expect.h"
#include "physics/transcendental.h"

namespace poinsot::physics {

RigidBodyState DecayingMotion::at(double t_s) const {
  if (rate_ == 0) return free_.at(t_s);
  POINSOT_EXPECT(-rate_ * t_s <= kLargestExponent);
  const double lost = exponentialLessOne(-rate_ * t_s);
  RigidBodyState state = free_.at(-lost / rate_);
  const double left = exponential(-rate_ * t_s);
  state.t_s = t_s;
  state.omega_B *= left;
  state.omega_W *= left;
  state.L_W *= left;
  state.kineticEnergy *= left * left;
  return state;
}

}  // namespace poinsot::physics
