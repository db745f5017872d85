// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/abi.h"

namespace poinsot::physics {

struct Particle {
  double mass_kg = 1;
  Eigen::Vector3d position_W = Eigen::Vector3d::Zero();  ///< m, from the origin of W
  Eigen::Vector3d velocity_W = Eigen::Vector3d::Zero();  ///< m/s
};

/// Point masses and what the lecture sums over them, eq (1) to (14), every quantity by its definition. The
/// yardstick for rigid bodies: nothing here knows of a moment of inertia but inertiaAbout().
class ParticleSystem {
 public:
  /// @throws core::Error(kPhysics) for no particle, a mass that is not positive and finite, or a place or velocity
  /// that is not finite.
  explicit ParticleSystem(std::vector<Particle> particles);

  const std::vector<Particle>& particles() const { return particles_; }

  double mass_kg() const { return mass_kg_; }
  const Eigen::Vector3d& centre_W() const { return centre_W_; }  ///< of mass, m
  Eigen::Vector3d centreVelocity_W() const { return momentum_W_ / mass_kg_; }

  /// P = sum m v, kg·m/s (eq 1).
  const Eigen::Vector3d& momentum_W() const { return momentum_W_; }

  /// About a point at rest: sum m (r - point) × v, kg·m²/s. About the origin: L_tot (eq 2, 4).
  Eigen::Vector3d angularMomentumAbout(const Eigen::Vector3d& point_W) const;
  /// R_cm × P, kg·m²/s (eq 5).
  Eigen::Vector3d orbitalAngularMomentum() const;
  /// L = sum m (r - R_cm) × (v - V_cm), kg·m²/s (eq 6).
  Eigen::Vector3d intrinsicAngularMomentum() const;

  /// sum m v²/2, J, and its two parts (eq 10): M V_cm²/2 and sum m (v - V_cm)²/2.
  double kineticEnergy() const;
  double translationalEnergy() const;
  double rotationalEnergy() const;

  /// sum m (r² 1 - r r), r from the point, kg·m² (eq 3, 7, 13).
  Eigen::Matrix3d inertiaAbout(const Eigen::Vector3d& point_W) const;

  /// sum (r - point) × F, N·m (eq 8, 9). forces_W in N. @pre one force for each particle.
  Eigen::Vector3d torqueAbout(const Eigen::Vector3d& point_W, const std::vector<Eigen::Vector3d>& forces_W) const;

 private:
  std::vector<Particle> particles_;
  double mass_kg_ = 0;
  Eigen::Vector3d centre_W_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d momentum_W_ = Eigen::Vector3d::Zero();
};

/// The particles given the velocities of a rigid body: v = V_K + omega × (r - R_K) (eq 4), K any point of the
/// body. In m, m/s, rad/s; the velocities that the particles had do not matter. @throws as ParticleSystem.
ParticleSystem rigidlyMoving(std::vector<Particle> particles, const Eigen::Vector3d& K_W,
                             const Eigen::Vector3d& velocityOfK_W, const Eigen::Vector3d& omega_W);

static_assert(core::laidOut<Particle, 56>());

}  // namespace poinsot::physics
