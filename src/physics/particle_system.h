// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/abi.h"

namespace poinsot::physics {

/// Point mass, with its position from the origin of W in m and its velocity in m/s.
struct Particle {
  double mass_kg = 1;
  Eigen::Vector3d position_W = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity_W = Eigen::Vector3d::Zero();
};

/// System of point masses. Each quantity is a sum over the particles, computed as the lecture defines it (eq 1 to
/// 14). The sums are the reference for rigid bodies, because only inertiaAbout() involves moments of inertia.
class ParticleSystem {
 public:
  /// @throws core::Error(kPhysics) for an empty list, a mass that is not positive and finite, or a position or
  /// velocity that is not finite.
  explicit ParticleSystem(std::vector<Particle> particles);

  const std::vector<Particle>& particles() const { return particles_; }

  double mass_kg() const { return mass_kg_; }
  const Eigen::Vector3d& centre_W() const { return centre_W_; }  ///< centre of mass, in W, m
  Eigen::Vector3d centreVelocity_W() const { return momentum_W_ / mass_kg_; }

  /// Returns P = sum m v, kg·m/s (eq 1).
  const Eigen::Vector3d& momentum_W() const { return momentum_W_; }

  /// Returns sum m (r - point) × v, kg·m²/s, for a point at rest. About the origin, the sum is L_tot (eq 2, 4).
  Eigen::Vector3d angularMomentumAbout(const Eigen::Vector3d& point_W) const;
  /// Returns the angular momentum of the centre of mass, R_cm × P, kg·m²/s (eq 5).
  Eigen::Vector3d orbitalAngularMomentum() const;
  /// Returns the angular momentum about the centre of mass, L = sum m (r - R_cm) × (v - V_cm), kg·m²/s (eq 6).
  Eigen::Vector3d intrinsicAngularMomentum() const;

  /// Returns the kinetic energy sum m v²/2, J. It is translationalEnergy(), M V_cm²/2, plus rotationalEnergy(),
  /// sum m (v - V_cm)²/2 (eq 10).
  double kineticEnergy() const;
  double translationalEnergy() const;
  double rotationalEnergy() const;

  /// Returns the inertia tensor sum m (r² 1 - r r), kg·m², with r measured from the point (eq 3, 7, 13).
  Eigen::Matrix3d inertiaAbout(const Eigen::Vector3d& point_W) const;

  /// Returns the torque sum (r - point) × F, N·m, for forces F in N (eq 8, 9). @pre one force for each particle.
  Eigen::Vector3d torqueAbout(const Eigen::Vector3d& point_W, const std::vector<Eigen::Vector3d>& forces_W) const;

 private:
  std::vector<Particle> particles_;
  double mass_kg_ = 0;
  Eigen::Vector3d centre_W_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d momentum_W_ = Eigen::Vector3d::Zero();
};

/// Returns the particles with the velocities of a rigid body: v = V_K + omega × (r - R_K) (eq 4), where K is any
/// point of the body. The particles' own velocities are ignored. Units are m, m/s and rad/s. @throws as
/// ParticleSystem.
ParticleSystem rigidlyMoving(std::vector<Particle> particles, const Eigen::Vector3d& K_W,
                             const Eigen::Vector3d& velocityOfK_W, const Eigen::Vector3d& omega_W);

static_assert(core::laidOut<Particle, 56>());

}  // namespace poinsot::physics
