// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "physics/particle_system.h"

namespace poinsot::physics {

/// Test body for the lecture's eq (1) to (17): five masses without symmetry. All numbers are exact in binary
/// except omega and the velocity. Expected values are computed from them apart from the code.
struct FiveMasses {
  std::vector<Particle> particles = {{1.5, {0.5, -1.25, 0.75}},
                                     {0.75, {-1, 0.25, 1.5}},
                                     {2.25, {0.125, 0.875, -0.625}},
                                     {1.125, {1.75, 0.5, -0.25}},
                                     {0.375, {-0.5, -0.75, -1.125}}};
  Eigen::Vector3d omega{0.6, -1.1, 0.8};
  Eigen::Vector3d velocity{1.2, -0.7, 0.4};  ///< velocity of the centre of mass
  Eigen::Vector3d centre{0.34375, 0.09375, 0.0234375};

  /// Returns the masses as a body that flies and turns.
  ParticleSystem flying() const { return rigidlyMoving(particles, centre, velocity, omega); }
  /// Returns the masses as a body that turns about the fixed origin.
  ParticleSystem pivoted() const {
    return rigidlyMoving(particles, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), omega);
  }
};

}  // namespace poinsot::physics
