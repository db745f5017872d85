// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "physics/particle_system.h"

namespace poinsot::physics {

/// The system that the lecture's eq (1) to (17) are checked on: five masses of no symmetry, numbers exact in
/// binary but for omega and the velocity. Expected values computed apart from the code, from the same numbers.
struct FiveMasses {
  std::vector<Particle> particles = {{1.5, {0.5, -1.25, 0.75}},
                                     {0.75, {-1, 0.25, 1.5}},
                                     {2.25, {0.125, 0.875, -0.625}},
                                     {1.125, {1.75, 0.5, -0.25}},
                                     {0.375, {-0.5, -0.75, -1.125}}};
  Eigen::Vector3d omega{0.6, -1.1, 0.8};
  Eigen::Vector3d velocity{1.2, -0.7, 0.4};  ///< of the centre of mass
  Eigen::Vector3d centre{0.34375, 0.09375, 0.0234375};

  /// Flying and turning.
  ParticleSystem flying() const { return rigidlyMoving(particles, centre, velocity, omega); }
  /// Turning about the origin, held fixed.
  ParticleSystem pivoted() const {
    return rigidlyMoving(particles, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), omega);
  }
};

}  // namespace poinsot::physics
