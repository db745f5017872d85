// SPDX-License-Identifier: Apache-2.0
#include "physics/particle_system.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "core/error.h"
#include "core/expect.h"
#include "physics/fixed_order.h"

namespace poinsot::physics {
namespace {

using Eigen::Vector3d;

void requireValid(const Particle& p) {
  if (!std::isfinite(p.mass_kg) || p.mass_kg <= 0)
    throw core::physicsError(
        fmt::format("the mass of a particle must be positive and finite, got {} kg", p.mass_kg));
  if (!p.position_W.allFinite() || !p.velocity_W.allFinite())
    throw core::physicsError("the position and the velocity of a particle must be finite");
}

double energyOf(double mass_kg, const Vector3d& velocity) {
  return 0.5 * mass_kg * dotProduct(velocity, velocity);
}

}  // namespace

ParticleSystem::ParticleSystem(std::vector<Particle> particles) : particles_(std::move(particles)) {
  if (particles_.empty()) throw core::physicsError("a body of particles needs at least one particle");
  Vector3d firstMoment = Vector3d::Zero();
  for (const Particle& p : particles_) {
    requireValid(p);
    mass_kg_ += p.mass_kg;
    firstMoment += p.mass_kg * p.position_W;
    momentum_W_ += p.mass_kg * p.velocity_W;
  }
  centre_W_ = firstMoment / mass_kg_;
}

Vector3d ParticleSystem::angularMomentumAbout(const Vector3d& point_W) const {
  Vector3d sum = Vector3d::Zero();
  for (const Particle& p : particles_) sum += p.mass_kg * crossProduct(p.position_W - point_W, p.velocity_W);
  return sum;
}

Vector3d ParticleSystem::orbitalAngularMomentum() const { return crossProduct(centre_W_, momentum_W_); }

Vector3d ParticleSystem::intrinsicAngularMomentum() const {
  const Vector3d velocity_W = centreVelocity_W();
  Vector3d sum = Vector3d::Zero();
  for (const Particle& p : particles_)
    sum += p.mass_kg * crossProduct(p.position_W - centre_W_, p.velocity_W - velocity_W);
  return sum;
}

double ParticleSystem::kineticEnergy() const {
  double sum = 0;
  for (const Particle& p : particles_) sum += energyOf(p.mass_kg, p.velocity_W);
  return sum;
}

double ParticleSystem::translationalEnergy() const { return energyOf(mass_kg_, centreVelocity_W()); }

double ParticleSystem::rotationalEnergy() const {
  const Vector3d velocity_W = centreVelocity_W();
  double sum = 0;
  for (const Particle& p : particles_) sum += energyOf(p.mass_kg, p.velocity_W - velocity_W);
  return sum;
}

Eigen::Matrix3d ParticleSystem::inertiaAbout(const Vector3d& point_W) const {
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  for (const Particle& p : particles_) {
    const Vector3d r = p.position_W - point_W;
    const double square = dotProduct(r, r);
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) inertia(a, b) += p.mass_kg * ((a == b ? square : 0) - r[a] * r[b]);
  }
  return inertia;
}

Vector3d ParticleSystem::torqueAbout(const Vector3d& point_W, const std::vector<Vector3d>& forces_W) const {
  POINSOT_EXPECT(forces_W.size() == particles_.size());
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 0; i < forces_W.size(); ++i)
    sum += crossProduct(particles_[i].position_W - point_W, forces_W[i]);
  return sum;
}

ParticleSystem rigidlyMoving(std::vector<Particle> particles, const Vector3d& K_W, const Vector3d& velocityOfK_W,
                             const Vector3d& omega_W) {
  for (Particle& p : particles) p.velocity_W = velocityOfK_W + crossProduct(omega_W, p.position_W - K_W);
  return ParticleSystem(std::move(particles));
}

}  // namespace poinsot::physics
