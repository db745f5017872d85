// SPDX-License-Identifier: Apache-2.0
// Computes a motion from three moments, as in docs/library.md, and prints a row of t and omega for each time.
#include <cstdio>
#include <vector>

#include "core/error.h"
#include "core/version.h"
#include "physics/free_motion.h"

#if POINSOT_VERSION < POINSOT_MAKE_VERSION(0, 1, 0)
#error "poinsot 0.1 or later is needed"
#endif

int main() try {
  using namespace poinsot;
  const physics::FreeMotion motion(physics::PrincipalMoments(1, 2, 2.5), {0.05, 2, 0.1},
                                   Eigen::Quaterniond::Identity());
  const std::vector<double> times_s = {0, 1, 2.5, 10};
  for (const physics::RigidBodyState& state : motion.at(times_s))
    std::printf("%g %.15g %.15g %.15g\n", state.t_s, state.omega_B[0], state.omega_B[1], state.omega_B[2]);
} catch (const poinsot::core::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
