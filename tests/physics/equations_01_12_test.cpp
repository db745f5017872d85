// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <limits>

#include "core/error.h"
#include "physics/five_masses.h"
#include "physics/flight.h"
#include "physics/free_motion.h"
#include "physics/particle_system.h"
#include "physics/random_bodies.h"
#include "physics/residual.h"

// Momentum, angular momentum, torque and energy of a rigid body: the lecture's eq (1) to (12).

namespace poinsot::physics {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kRounding = 1e-14;  // values of order 10, given to 16 digits

void expectNear(const Vector3d& measured, const Vector3d& expected, double bound = kRounding) {
  EXPECT_LE((measured - expected).norm(), bound) << measured.transpose() << " for " << expected.transpose();
}

Matrix3d symmetric(double xx, double yy, double zz, double xy, double xz, double yz) {
  return (Matrix3d() << xx, xy, xz, xy, yy, yz, xz, yz, zz).finished();
}

TEST(Equation02And03, GiveTheAngularMomentumAboutAPivot) {
  const ParticleSystem body = FiveMasses().pivoted();
  const Matrix3d inertia = body.inertiaAbout(Vector3d::Zero());
  EXPECT_LE((inertia - symmetric(8.560546875, 8.654296875, 9.3046875, -0.24609375, 1.01953125, 2.1796875)).norm(),
            kRounding);
  expectNear(body.angularMomentumAbout(Vector3d::Zero()), {6.22265625, -7.9236328125, 5.6578125});
  expectNear(inertia * FiveMasses().omega, {6.22265625, -7.9236328125, 5.6578125});
}

TEST(Equation04And05, OrbitalAndIntrinsicPartsAddUp) {
  const ParticleSystem body = FiveMasses().flying();
  EXPECT_EQ(body.mass_kg(), 6);
  expectNear(body.centre_W(), FiveMasses().centre, 1e-16);
  expectNear(body.angularMomentumAbout(Vector3d::Zero()), {6.3384521484375, -7.66981201171875, 2.944189453125});
  expectNear(body.orbitalAngularMomentum(), {0.3234375, -0.65625, -2.11875});
  expectNear(body.intrinsicAngularMomentum(), {6.0150146484375, -7.01356201171875, 5.062939453125});
}

// Any point K of the body may be the reference of eq (4), but only the centre of mass splits L into two parts.
TEST(Equation04, SplitsLOnlyAboutTheCentreOfMass) {
  const FiveMasses five;
  const Vector3d K = five.particles[0].position_W;
  const Vector3d velocity = five.velocity + five.omega.cross(K - five.centre);
  expectNear(velocity, {1.47578125, -1.0109375, -0.234375});
  const ParticleSystem body = rigidlyMoving(five.particles, K, velocity, five.omega);
  expectNear(body.angularMomentumAbout(Vector3d::Zero()), {6.3384521484375, -7.66981201171875, 2.944189453125});
  const Vector3d split = K.cross(body.momentum_W()) + body.inertiaAbout(K) * five.omega;
  expectNear(split, {12.63515625, -1.0166015625, 13.894921875});
  EXPECT_GT((split - body.angularMomentumAbout(Vector3d::Zero())).norm(), 1);
}

TEST(Equation06And07, GiveTheIntrinsicAngularMomentum) {
  const ParticleSystem body = FiveMasses().flying();
  const Matrix3d inertia = body.inertiaAbout(body.centre_W());
  EXPECT_LE((inertia -
             symmetric(8.5045166015625, 7.9420166015625, 8.54296875, -0.052734375, 1.06787109375, 2.19287109375))
                .norm(),
            kRounding);
  expectNear(inertia * FiveMasses().omega, body.intrinsicAngularMomentum());
}

/// Returns forces on three of the five masses, N.
std::vector<Vector3d> forces() { return {{1, 0, -2}, {0, 0, 0}, {0, 1.5, 0.5}, {0, 0, 0}, {-1, -0.5, 0.25}}; }

TEST(Equation08And09, GiveTheTorquesAboutOriginAndCentre) {
  const ParticleSystem body = FiveMasses().flying();
  const Vector3d aboutOrigin = body.torqueAbout(Vector3d::Zero(), forces());
  const Vector3d aboutCentre = body.torqueAbout(body.centre_W(), forces());
  expectNear(aboutOrigin, {3.125, 2.9375, 0.9375});
  expectNear(aboutCentre, {3.265625, 2.5078125, 0.59375});
  expectNear(aboutOrigin - aboutCentre, body.centre_W().cross(Vector3d(0, 1, -1.25)));
  expectNear(aboutOrigin - aboutCentre, {-0.140625, 0.4296875, 0.34375});
}

/// Returns the accelerations of a rigid body's masses under forces by Gauss's principle of least constraint: the
/// rigid accelerations A + alpha × r + omega × (omega × r) with the least sum m |a - F/m|². Uses no equation of
/// torques.
std::vector<Vector3d> accelerations(const ParticleSystem& body, const Vector3d& omega,
                                    const std::vector<Vector3d>& forces) {
  const auto n = static_cast<Eigen::Index>(forces.size());
  Eigen::MatrixXd A(3 * n, 6);
  Eigen::VectorXd b(3 * n);
  std::vector<Vector3d> centripetal;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Particle& p = body.particles()[static_cast<std::size_t>(i)];
    const Vector3d& r = p.position_W;
    centripetal.push_back(omega.cross(omega.cross(r)));
    Matrix3d across;  // alpha × r = across alpha
    across << 0, r[2], -r[1], -r[2], 0, r[0], r[1], -r[0], 0;
    const double weight = std::sqrt(p.mass_kg);
    A.middleRows<3>(3 * i) << weight * Matrix3d::Identity(), weight * across;
    b.segment<3>(3 * i) = weight * (forces[static_cast<std::size_t>(i)] / p.mass_kg - centripetal.back());
  }
  const Eigen::VectorXd rigid = A.colPivHouseholderQr().solve(b);
  std::vector<Vector3d> result;
  for (std::size_t i = 0; i < centripetal.size(); ++i) {
    const Vector3d turning = rigid.tail<3>();
    result.push_back(rigid.head<3>() + turning.cross(body.particles()[i].position_W) + centripetal[i]);
  }
  return result;
}

/// Returns d/dt of sum m (r - point) × (v - u) for accelerations a of the masses and an acceleration of the point.
Vector3d momentRate(const ParticleSystem& body, const Vector3d& point, const std::vector<Vector3d>& a,
                    const Vector3d& ofPoint) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Particle& p = body.particles()[i];
    sum += p.mass_kg * (p.position_W - point).cross(a[i] - ofPoint);
  }
  return sum;
}

TEST(Equation01And08And09, HoldOnlyAboutFixedPointsAndTheCentre) {
  const FiveMasses five;
  const ParticleSystem body = five.flying();
  const std::vector<Vector3d> a = accelerations(body, five.omega, forces());
  Vector3d momentumRate = Vector3d::Zero();
  for (std::size_t i = 0; i < a.size(); ++i) momentumRate += five.particles[i].mass_kg * a[i];
  expectNear(momentumRate, {0, 1, -1.25});  // measured 4e-15
  expectNear(momentRate(body, Vector3d::Zero(), a, Vector3d::Zero()), {3.125, 2.9375, 0.9375}, 2e-14);
  expectNear(momentRate(body, body.centre_W(), a, momentumRate / 6), {3.265625, 2.5078125, 0.59375}, 2e-14);
  // The lecture: "But not any other moving point". Here the point is particle 1.
  const Vector3d moving = five.particles[0].position_W;
  EXPECT_GT((momentRate(body, moving, a, a[0]) - body.torqueAbout(moving, forces())).norm(), 1);
}

// The lecture derives eq (9) with "R_cm × P = 0", which is not 0. The derivation needs only d(R_cm)/dt × P = 0.
TEST(Equation09, VelocityOfTheCentreIsParallelToTheMomentum) {
  const ParticleSystem body = FiveMasses().flying();
  EXPECT_LE(body.centreVelocity_W().cross(body.momentum_W()).norm(), 2e-15);  // measured 8.3e-16
  EXPECT_GT(body.orbitalAngularMomentum().norm(), 2);
}

TEST(Equation10To12, GiveTheEnergiesOfFiveMasses) {
  const FiveMasses five;
  const ParticleSystem body = five.flying();
  EXPECT_NEAR(body.kineticEnergy(), 13.95713928222656, kRounding);
  EXPECT_NEAR(body.translationalEnergy(), 6.27, kRounding);
  EXPECT_NEAR(body.rotationalEnergy(), 7.68713928222656, kRounding);
  EXPECT_NEAR(five.pivoted().kineticEnergy(), 8.487919921875, kRounding);
  EXPECT_NEAR(0.5 * five.omega.dot(body.inertiaAbout(Vector3d::Zero()) * five.omega), 8.487919921875, kRounding);
}

// Eq (12) for random systems: the sum over masses, omega·I·omega/2 and the sum over components are equal.
TEST(Equation12, ThreeExpressionsOfTheEnergyAgree) {
  Draw draw(211);
  double worst = 0;
  for (int n = 0; n < 200; ++n) {
    std::vector<Particle> particles;
    for (int i = 0; i < 6; ++i) particles.push_back({draw.decade(-2, 1), draw.direction() * draw.between(0.1, 3)});
    const Vector3d omega = draw.direction();
    const ParticleSystem body = rigidlyMoving(particles, Vector3d::Zero(), Vector3d::Zero(), omega);
    const Matrix3d I = body.inertiaAbout(Vector3d::Zero());
    double components = 0;
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) components += 0.5 * I(a, b) * omega[a] * omega[b];
    worst = std::max({worst, std::abs(0.5 * omega.dot(I * omega) / body.kineticEnergy() - 1),
                      std::abs(components / body.kineticEnergy() - 1)});
  }
  expectResidual("T three ways, relative", worst, 1e-14);  // measured 7.8e-16
}

// Eq (1) for a body thrown under gravity: P and L_tot change by the time integrals of force and torque.
TEST(Equation01, ThrownBodyGainsTheImpulseOfItsWeight) {
  const FiveMasses five;
  const ParticleSystem start = five.flying();
  const PrincipalAxes axes(start.inertiaAbout(start.centre_W()));
  const FreeMotion motion(axes, five.omega, Quaterniond::Identity());
  const Flight flight{five.centre, five.velocity, {0, 0, -9.81}};
  const FlightQuantities before = flightQuantities(6, flight, motion.at(0));
  const FlightQuantities after = flightQuantities(6, flight, motion.at(0.5));
  expectNear(before.total_W, start.angularMomentumAbout(Vector3d::Zero()), 2e-14);
  expectNear(after.P_W - before.P_W, {0, 0, -29.43}, 2e-14);
  expectNear(after.total_W - before.total_W, {2.3911875, 18.9455625, 0}, 2e-14);
  expectNear(after.intrinsic_W, before.intrinsic_W, 0);
  EXPECT_NEAR(after.kineticEnergy() + after.potentialEnergy, before.kineticEnergy() + before.potentialEnergy,
              2e-14);
}

// Worked by hand: 3 m/s upward against 4 m/s² last 0.75 s and rise 1.125 m, along any axis.
TEST(Flight, TopMatchesAHandComputedExample) {
  const FlightTop top = Flight{.velocity_W = {3, 7, 0}, .gravity_W = {-4, 0, 0}}.top();
  EXPECT_EQ(top.t_s, 0.75);
  EXPECT_EQ(top.rise_m, 1.125);
  EXPECT_LT((Flight{.velocity_W = {0, 0, -1}}.top().t_s), 0);
  EXPECT_EQ((Flight{.velocity_W = {1, 2, 3}, .gravity_W = Vector3d::Zero()}.top().t_s), 0);
}

// A flight by its separate masses, whose positions and velocities follow from attitude and omega.
TEST(Equation01To10, ThrownBodyAgreesWithItsSeparateMasses) {
  const FiveMasses five;
  const ParticleSystem start = five.flying();
  const FreeMotion motion(PrincipalAxes(start.inertiaAbout(start.centre_W())), five.omega,
                          Quaterniond::Identity());
  const Flight flight{five.centre, five.velocity, {0.3, -0.4, -9.81}};
  double momentum = 0, angular = 0, energy = 0;
  for (const double t : {-2.0, 0.25, 1.5, 7.0}) {
    const RigidBodyState state = motion.at(t);
    std::vector<Particle> moved = five.particles;
    for (Particle& p : moved) p.position_W = flight.positionAt(t) + state.q_WB * (p.position_W - five.centre);
    const ParticleSystem body = rigidlyMoving(moved, flight.positionAt(t), flight.velocityAt(t), state.omega_W);
    const FlightQuantities q = flightQuantities(6, flight, state);
    momentum = std::max(momentum, (q.P_W - body.momentum_W()).norm() / q.P_W.norm());
    angular =
        std::max(angular, (q.total_W - body.angularMomentumAbout(Vector3d::Zero())).norm() / q.total_W.norm());
    angular = std::max(angular, (q.orbital_W - body.orbitalAngularMomentum()).norm() / q.total_W.norm());
    energy = std::max(energy, std::abs(q.kineticEnergy() / body.kineticEnergy() - 1));
    const std::vector<Vector3d> weights = [&] {
      std::vector<Vector3d> w;
      for (const Particle& p : moved) w.push_back(p.mass_kg * flight.gravity_W);
      return w;
    }();
    expectNear(q.torque_W, body.torqueAbout(Vector3d::Zero(), weights), 1e-12 * q.torque_W.norm());
  }
  expectResidual("P, relative", momentum, 1e-14);                          // measured 3.1e-16
  expectResidual("L_tot and its orbital part, relative", angular, 3e-14);  // measured 6.6e-15
  expectResidual("T, relative", energy, 1e-14);                            // measured 4.4e-16
}

TEST(ParticleSystem, RejectsInvalidParticles) {
  const auto message = [](std::vector<Particle> particles) -> std::string {
    try {
      ParticleSystem{std::move(particles)};
    } catch (const core::Error& error) {
      EXPECT_EQ(error.kind(), core::ErrorKind::kPhysics);
      return error.message();
    }
    return "accepted";
  };
  EXPECT_EQ(message({}), "a body of particles needs at least one particle");
  EXPECT_EQ(message({{-1, {0, 0, 0}, {0, 0, 0}}}),
            "the mass of a particle must be positive and finite, got -1 kg");
  EXPECT_EQ(message({{1, {std::numeric_limits<double>::quiet_NaN(), 0, 0}, {0, 0, 0}}}),
            "the position and the velocity of a particle must be finite");
  EXPECT_THROW(FiveMasses().flying().torqueAbout({0, 0, 0}, {}), std::logic_error);
}

}  // namespace
}  // namespace poinsot::physics
