// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "physics/free_motion.h"
#include "physics/herpolhode.h"
#include "physics/poinsot_construction.h"
#include "physics/polhode.h"
#include "physics/residual.h"
#include "physics/taylor_oracle.h"
#include "support/development_examples.h"

namespace poinsot::physics {
namespace {

void expectNear(double measured, double expected) {
  if (std::isinf(expected))
    EXPECT_EQ(measured, expected);
  else
    EXPECT_NEAR(measured, expected, 7e-16 * std::abs(expected));  // 16 digits hold 5e-16
}

class FreeMotionExample : public testing::TestWithParam<Example> {};

TEST_P(FreeMotionExample, StateMatchesTheExample) {
  const Example& e = GetParam();
  const RigidBodyState state = FreeMotion(PrincipalMoments(e.I), e.omega0, e.q0).at(e.t_s);
  // Measured: at most 3.1e-16 rad and 2.3e-16 rad/s.
  expectResidual("attitude, rad",
                 TaylorOracle<long double>::angle({e.q_WB.w(), e.q_WB.x(), e.q_WB.y(), e.q_WB.z()}, state.q_WB),
                 4e-15);
  expectResidual("omega_B, rad/s", (state.omega_B - e.omega_B).norm(), 1e-15);
}

TEST_P(FreeMotionExample, ConstantsMatchTheExample) {
  const Example& e = GetParam();
  const PrincipalMoments moments(e.I);
  const FreeMotion motion(moments, e.omega0, e.q0);
  expectNear(motion.L_W().norm(), e.L);
  expectNear(2 * motion.kineticEnergy() / e.L, e.planeHeight);
  expectNear(PoinsotConstruction(moments, e.omega0).planeHeight(), e.planeHeight);
}

TEST_P(FreeMotionExample, PolhodeAndHerpolhodeMatchTheExample) {
  const Example& e = GetParam();
  const Polhode polhode(PrincipalMoments(e.I), e.omega0);
  const Herpolhode herpolhode(PrincipalMoments(e.I), e.omega0);
  EXPECT_EQ(polhode.regime(), e.regime);
  EXPECT_EQ(herpolhode.regime(), e.regime);
  expectNear(polhode.period(), e.polhodePeriod);
  expectNear(herpolhode.radialPeriod(), e.polhodePeriod / 2);
  expectNear(herpolhode.anglePerRadialPeriod(), e.anglePerRadialPeriod);
  expectNear(herpolhode.smallestRadius(), e.smallestRadius);
  expectNear(herpolhode.largestRadius(), e.largestRadius);
}

INSTANTIATE_TEST_SUITE_P(Physics, FreeMotionExample, testing::ValuesIn(kExamples),
                         [](const auto& example) { return std::string(example.param.name); });

TEST(FreeMotionExamples, SemiAxesMatchAHandComputedExample) {
  const PoinsotConstruction construction(PrincipalMoments({2, 3, 4}), {.5, .25, 1});
  // Worked by hand: sqrt(2T/I_i) with 2T = 4.6875.
  EXPECT_NEAR(construction.semiAxes_P()[0], 1.530931089239486, 7e-16);
  EXPECT_EQ(construction.semiAxes_P()[1], 1.25);
  EXPECT_NEAR(construction.semiAxes_P()[2], 1.082531754730548, 7e-16);
}

}  // namespace
}  // namespace poinsot::physics
