// SPDX-License-Identifier: Apache-2.0
// The physics alone: no picture, no OpenGL. Prints what a test can look for.
#include <cmath>
#include <cstdio>

#include "physics/free_motion.h"

int main() {
  const poinsot::physics::PrincipalMoments moments({1, 2, 2.5});
  const poinsot::physics::FreeMotion motion(moments, {0.01, 3, 0}, Eigen::Quaterniond::Identity());
  const Eigen::Vector3d omega_B = motion.at(1e6).omega_B;
  const double energy = 0.5 * (omega_B.array().square() * Eigen::Array3d(1, 2, 2.5)).sum();
  const bool kept = std::abs(energy / motion.kineticEnergy() - 1) < 1e-14;
  std::printf("energy after 1e6 s: %s\n", kept ? "kept" : "lost");
  return kept ? 0 : 1;
}
