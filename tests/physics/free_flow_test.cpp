// SPDX-License-Identifier: Apache-2.0
#include "physics/free_flow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "physics/free_motion.h"
#include "physics/random_bodies.h"
#include "physics/residual.h"
#include "physics/taylor_oracle.h"

// One step of the free flow is compared with the Taylor integrator in long double (taylor_oracle.h). The bound
// counts roundings of the angle turned, plus the rounding of the returned quaternion.

namespace poinsot::physics {
namespace {

using Eigen::Vector3d;

DrivenState startOf(const Vector3d& I, const Vector3d& omega, const Eigen::Quaterniond& q) {
  DrivenState state;
  state.q_WP = normalized(Rotor<DoubleDouble>{q.w(), q.x(), q.y(), q.z()});
  std::array<DoubleDouble, 3> m;
  for (int i = 0; i < 3; ++i) m[static_cast<std::size_t>(i)] = twoProduct(I[i], omega[i]);
  state.L_W = rotated(state.q_WP, m);
  return state;
}

/// Returns the largest error of one step over all draws, in units of 2^-53 (1 + angle turned).
double worstError(std::uint64_t seed, const std::function<void(Draw&, Vector3d& I, Vector3d& omega)>& drawBody) {
  Draw draw(seed);
  double worst = 0;
  for (int i = 0; i < 300; ++i) {
    Vector3d I, omega;
    drawBody(draw, I, omega);
    const Eigen::Quaterniond q0 = draw.attitude();
    const double h = draw.sign() * draw.decade(-4, 0) / omega.norm();
    DrivenState state = startOf(I, omega, q0);
    FreeFlow(PrincipalMoments(I)).apply(state, h);
    const TaylorOracle<long double> oracle(I, omega, q0);
    const Rotor<double> q = toDouble(state.q_WP);
    const double error = TaylorOracle<long double>::angle(oracle.at(h).q, Eigen::Quaterniond(q.w, q.x, q.y, q.z));
    worst = std::max(worst, error / (0x1p-53 * (1 + omega.norm() * std::abs(h))));
  }
  return worst;
}

TEST(FreeFlow, IsExactToWithinRounding) {  // measured 1.1 to 1.4
  const auto moments = [](Draw& draw) { return draw.moments().values(); };
  expectResidual("random bodies, roundings",
                 worstError(201,
                            [&](Draw& draw, Vector3d& I, Vector3d& omega) {
                              I = moments(draw);
                              omega = draw.direction() * draw.decade(-3, 3);
                            }),
                 4);
  expectResidual("symmetric bodies, roundings",
                 worstError(202,
                            [&](Draw& draw, Vector3d& I, Vector3d& omega) {
                              I = {1, 1, draw.between(0.01, 2)};
                              omega = draw.direction();
                            }),
                 4);
  expectResidual("near spheres, roundings",
                 worstError(203,
                            [&](Draw& draw, Vector3d& I, Vector3d& omega) {
                              I = Vector3d(1, 1, 1) + draw.decade(-16, -3) * draw.direction();
                              omega = draw.direction();
                            }),
                 4);
  expectResidual("near the separatrix, roundings",
                 worstError(204,
                            [&](Draw& draw, Vector3d& I, Vector3d& omega) {
                              I = {1, 1.5, 2};
                              omega = Vector3d(0, draw.sign(), 0) + draw.decade(-12, -1) * draw.direction();
                            }),
                 4);
  expectResidual("nearly steady, roundings",
                 worstError(205,
                            [&](Draw& draw, Vector3d& I, Vector3d& omega) {
                              I = moments(draw);
                              omega = Vector3d(0, 0, draw.sign()) + draw.decade(-15, -3) * draw.direction();
                            }),
                 4);
}

void drawRod(Draw& draw, double thinnest, Vector3d& I, Vector3d& omega) {
  const double thin = draw.decade(thinnest, -1);
  I = {thin, 1, 1 + thin * draw.between(-0.9, 0.9)};
  omega = draw.direction();
}

// A rounding of the attitude changes the momentum along the rod, which its small moment turns into a large change
// of the spin: up to I_max/I_min roundings if the step is cut into parts.
TEST(FreeFlow, StaysWithinAmplifiedRoundingForRods) {
  expectResidual("rods to 1 : 100, roundings",
                 worstError(206, [](Draw& draw, Vector3d& I, Vector3d& omega) { drawRod(draw, -2, I, omega); }),
                 60);  // measured 8.1
  expectResidual("rods to 1 : 1e6, roundings",
                 worstError(207, [](Draw& draw, Vector3d& I, Vector3d& omega) { drawRod(draw, -6, I, omega); }),
                 1e5);  // measured 2.5e4
}

TEST(FreeFlow, ConservesMomentumAndKeepsABodyAtRest) {
  const Vector3d I(1, 1.5, 2);
  DrivenState state = startOf(I, {0.3, 1, -2}, Eigen::Quaterniond(0.5, 0.5, -0.5, 0.5));
  const auto L = state.L_W;
  FreeFlow(PrincipalMoments(I)).apply(state, 0.2);
  EXPECT_EQ(state.L_W, L);
  DrivenState resting = startOf(I, {0, 0, 0}, Eigen::Quaterniond(0.5, 0.5, -0.5, 0.5));
  FreeFlow(PrincipalMoments(I)).apply(resting, 1e9);
  EXPECT_EQ(resting.q_WP.x.hi, 0.5);
}

// The moments are scaled towards both ends of the range of doubles.
TEST(FreeFlow, DoesNotDependOnUnits) {
  const Vector3d I(1, 1.5, 2), omega(0.3, 1, -2);
  DrivenState plain = startOf(I, omega, Eigen::Quaterniond::Identity());
  FreeFlow(PrincipalMoments(I)).apply(plain, 0.1);
  for (const double unit : {0x1p-400, 0x1p400}) {
    DrivenState scaled = startOf(I * unit, omega, Eigen::Quaterniond::Identity());
    FreeFlow(PrincipalMoments(I * unit)).apply(scaled, 0.1);
    EXPECT_EQ(scaled.q_WP.x.hi, plain.q_WP.x.hi);
    EXPECT_EQ(scaled.q_WP.z.hi, plain.q_WP.z.hi);
  }
}

// Over 1400 rad, roundings must neither add up nor show in the energy.
TEST(FreeFlow, AgreesWithTheClosedForm) {
  const Vector3d I(1, 1.5, 2), omega(0.3, 1, -2);
  DrivenState state = startOf(I, omega, Eigen::Quaterniond::Identity());
  const FreeFlow flow{PrincipalMoments(I)};
  for (int k = 0; k < 10000; ++k) {
    flow.apply(state, 0.0625);
    state.normalize();
  }
  const Eigen::Quaterniond exact =
      FreeMotion(PrincipalMoments(I), omega, Eigen::Quaterniond::Identity()).at(625).q_WB;
  const Rotor<double> d =
      conjugate(toDouble(state.q_WP)) * Rotor<double>{exact.w(), exact.x(), exact.y(), exact.z()};
  expectResidual("10000 free flows, rad", 2 * norm({d.x, d.y, d.z}), 5e-13);  // measured 5.1e-14
  const auto m = state.momentum_P();
  const double twoT = m[0] * m[0] / I[0] + m[1] * m[1] / I[1] + m[2] * m[2] / I[2];
  const double twoT0 = omega.cwiseProduct(I).dot(omega);
  expectResidual("  energy", std::abs(twoT / twoT0 - 1), 1e-14);  // measured 0
}

}  // namespace
}  // namespace poinsot::physics
