// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "physics/driven_testing.h"
#include "physics/splitting.h"

// Order of each composition: the slope of log error over log step across three halvings, with the Taylor
// integrator as reference. Trailing comments give measured slopes.

namespace poinsot::physics {
namespace {

DrivenState startOf(const DrivenCase& c) {
  DrivenState state;
  state.q_WP = normalized(Rotor<DoubleDouble>{c.q0.w(), c.q0.x(), c.q0.y(), c.q0.z()});
  std::array<DoubleDouble, 3> m;
  for (int i = 0; i < 3; ++i) m[static_cast<std::size_t>(i)] = twoProduct(c.I[i], c.omega0[i]);
  state.L_W = rotated(state.q_WP, m);
  return state;
}

DrivenState advanced(DrivenState state, const DrivenCase& c, const Composition& composition, int steps, double h) {
  const PrincipalAxes axes{PrincipalMoments(c.I)};
  const Splitting splitting(axes, c.forcing);
  ForcingPiece piece;
  for (int i = 0; i < 3; ++i) {
    const auto j = static_cast<std::size_t>(i);
    piece.torque_P.start[j] = c.forcing.torque_B[i];
    piece.torque_W.start[j] = c.forcing.torque_W[i];
  }
  for (int k = 0; k < steps; ++k) splitting.step(state, composition, piece, k * h, h);
  return state;
}

/// Returns the least-squares slope of log error for `steps` steps and 2, 4 and 8 times as many.
double slope(const DrivenCase& c, const Composition& composition, int steps) {
  const DrivenOracle<long double> oracle(c.I, c.forcing);
  const double T = c.span.to_s;
  const auto expected = oracle.advanced(oracle.start(c.omega0, c.q0), T);
  double sum = 0;
  for (int i = 0; i < 4; ++i, steps *= 2) {
    const Rotor<double> q = toDouble(advanced(startOf(c), c, composition, steps, T / steps).q_WP);
    const double error = TaylorOracle<long double>::angle(expected.q, Eigen::Quaterniond(q.w, q.x, q.y, q.z));
    sum += (2 * i - 3) * std::log2(error);
  }
  return -sum / 10;
}

void expectOrder(const char* name, const DrivenCase& c, const Composition& composition, int steps) {
  const double measured = slope(c, composition, steps);
  if (std::getenv("POINSOT_SHOW_RESIDUALS")) std::printf("  order of %s: %.3f\n", name, measured);
  EXPECT_NEAR(measured, composition.order, 0.15) << name;
}

DrivenCase drivenByAll() {
  DrivenCase c;
  c.forcing.gravity_B = {0.3, 0.5, 1};
  c.forcing.torque_B = {0.1, -0.2, 0.1};
  c.forcing.torque_W = {0.2, 0.1, 0};
  c.span = {0, 4};
  return c;
}

DrivenCase lasting(DrivenCase c, double end_s) {
  c.span = {0, end_s};
  return c;
}

// The longest steps are short enough to show the order; the shortest are long enough to hide rounding.
TEST(IntegratorOrder, HoldsForTheHeavyTop) {
  const DrivenCase top = heavyTop(4);
  expectOrder("Strang", top, strang2(), 200);                 // 2.000
  expectOrder("Nystrom 4", top, nystrom4(), 60);              // 3.95
  expectOrder("Nystrom 6", top, nystrom6(), 24);              // 6.0
  expectOrder("Kahan-Li", lasting(top, 24), kahanLi8(), 56);  // 7.92
}

TEST(IntegratorOrder, HoldsForTorquesAndGravity) {
  const DrivenCase c = drivenByAll();
  expectOrder("Strang", c, strang2(), 200);                 // 2.000
  expectOrder("Nystrom 4", c, nystrom4(), 60);              // 3.98
  expectOrder("Nystrom 6", c, nystrom6(), 20);              // 5.9
  expectOrder("Kahan-Li", lasting(c, 16), kahanLi8(), 32);  // 7.96
}

// Equal drag is part of the drift, so that the Nyström methods keep their order.
TEST(IntegratorOrder, HoldsForEqualDrag) {
  DrivenCase c = drivenByAll();
  c.forcing.dragRate_P.setConstant(0.3);
  expectOrder("Nystrom 4", c, nystrom4(), 60);  // 3.99
  expectOrder("Nystrom 6", c, nystrom6(), 20);  // 5.95
}

TEST(IntegratorOrder, HoldsForUnequalDragAndDissipation) {
  DrivenCase c = drivenByAll();
  c.forcing.dragRate_P = {0.3, 0.1, 0.2};
  expectOrder("Strang, drag", c, strang2(), 200);                 // 2.000
  expectOrder("Kahan-Li, drag", lasting(c, 24), kahanLi8(), 32);  // 8.03
  c.forcing.dissipation = 0.05;
  expectOrder("Strang, all", c, strang2(), 200);                 // 2.000
  expectOrder("Kahan-Li, all", lasting(c, 24), kahanLi8(), 40);  // 8.09
}

double disagreement(const DrivenState& a, const DrivenState& b) {
  const Rotor<double> d = conjugate(toDouble(a.q_WP)) * toDouble(b.q_WP);
  double largest = 2 * norm({d.x, d.y, d.z});
  for (std::size_t i = 0; i < 3; ++i) largest = std::max(largest, std::abs(a.L_W[i].hi - b.L_W[i].hi));
  return largest;
}

// Every composition is a palindrome of reversible flows, so that a step back undoes a step.
void expectReversible(const DrivenCase& c, const Composition& composition) {
  const DrivenState start = startOf(c);
  const DrivenState there = advanced(start, c, composition, 100, 0.05);
  EXPECT_GT(disagreement(start, there), 0.1);
  expectResidual(composition.name, disagreement(start, advanced(there, c, composition, 100, -0.05)), 1e-13);
}

TEST(IntegratorOrder, StepsAreReversible) {  // measured 3e-16 to 3e-15
  DrivenCase c = drivenByAll();
  for (const Composition* composition : {&strang2(), &nystrom4(), &nystrom6(), &kahanLi8()})
    expectReversible(c, *composition);
  c.forcing.dragRate_P = {0.3, 0.1, 0.2};
  c.forcing.dissipation = 0.05;
  for (const Composition* composition : {&strang2(), &kahanLi8()}) expectReversible(c, *composition);
}

}  // namespace
}  // namespace poinsot::physics
