// SPDX-License-Identifier: Apache-2.0
#include "physics/theta_oracle.h"

#include <gtest/gtest.h>

#include "physics/random_bodies.h"
#include "physics/residual.h"
#include "physics/taylor_oracle.h"

// The oracle in theta functions is compared with the Taylor integrator of 60 digits, which uses Euler's equations
// alone. Tolerances are near the last digits of the arithmetic, far below the 1e-16 for which the oracle serves.

namespace poinsot::physics {
namespace {

using Eigen::Vector3d;

Real100 widened(const Real60& x) { return Real100(x); }

/// Returns the largest difference of any entry of R or component of omega after up to 20 rad.
double worstDifference(Draw& draw, const Vector3d& I, const Vector3d& omega0) {
  const Eigen::Quaterniond q0 = draw.attitude();
  const double t = draw.between(-20, 20) / omega0.norm();
  const ThetaOracle::State theta = ThetaOracle(I, omega0, q0).at(Real100(t));
  const auto taylor = TaylorOracle<Real60>(I, omega0, q0).at(Real60(t));
  std::array<Real100, 4> q;
  std::transform(taylor.q.begin(), taylor.q.end(), q.begin(), widened);
  const Matrix100 R = ThetaOracle::rotationMatrix(q);
  Real100 worst = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    worst = std::max(worst, Real100(abs(Real100(theta.omega[i] - widened(taylor.omega[i])))));
    for (std::size_t j = 0; j < 3; ++j) worst = std::max(worst, Real100(abs(Real100(theta.R[i][j] - R[i][j]))));
  }
  return static_cast<double>(worst);
}

TEST(ThetaOracle, AgreesWithTheTaylorIntegrator) {
  Draw draw(121);
  double worst = 0;
  for (int i = 0; i < 20; ++i)
    worst = std::max(worst, worstDifference(draw, draw.moments().values(), draw.direction()));
  expectResidual("random bodies", worst, 1e-57);  // measured 5.6e-60
}

TEST(ThetaOracle, AgreesForNearlyAndExactlySymmetricBodies) {
  Draw draw(122);
  double worst = 0;
  for (int i = 0; i < 6; ++i) {
    const double gap = i < 3 ? 0 : draw.decade(-15, -5), other = draw.between(0.2, 1.8);
    worst = std::max(worst, worstDifference(draw, {1 + gap, other, 1}, draw.direction()));
  }
  expectResidual("symmetric bodies", worst, 1e-57);  // measured 1.3e-59
}

TEST(ThetaOracle, AgreesNearTheSeparatrixAndForNeedles) {
  Draw draw(123);
  double separatrix = 0, needle = 0;
  for (int i = 0; i < 4; ++i) {
    const Vector3d omega(0.75, draw.between(-1, 1), 1 + draw.sign() * 0x1p-52);
    separatrix = std::max(separatrix, worstDifference(draw, {1, 2, 2.25}, omega));
    needle = std::max(needle, worstDifference(draw, {1e-6, 1, 1 + 0x1p-22}, {1, 0.5, draw.unit()}));
  }
  expectResidual("one ulp off the separatrix", separatrix, 1e-57);  // measured 1.2e-59
  expectResidual("needles", needle, 1e-57);                         // measured 6.5e-60
}

TEST(ThetaOracle, AgreesForFaintWobblesAndSteadySpins) {
  Draw draw(124);
  double worst = 0;
  for (int i = 0; i < 6; ++i) {
    const double wobble = i < 2 ? 0 : draw.decade(-16, -3);
    const Vector3d omega = Vector3d::Unit(i % 3) + wobble * draw.direction();
    worst = std::max(worst, worstDifference(draw, draw.moments().values(), omega));
  }
  expectResidual("nearly steady", worst, 1e-57);  // measured 7.3e-60
}

TEST(ThetaOracle, RejectsTheSeparatrix) {
  EXPECT_THROW(ThetaOracle({1, 2, 2.25}, {.75, .5, 1}, Eigen::Quaterniond::Identity()), std::invalid_argument);
}

}  // namespace
}  // namespace poinsot::physics
