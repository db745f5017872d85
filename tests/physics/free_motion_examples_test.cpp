// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>
#include <ostream>

#include "physics/free_motion.h"
#include "physics/herpolhode.h"
#include "physics/poinsot_construction.h"
#include "physics/polhode.h"
#include "physics/residual.h"
#include "physics/taylor_oracle.h"

namespace poinsot::physics {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Expected values from an evaluation to 50 digits by two other methods, made before this code; rounded to the 16
/// digits given.
struct Example {
  const char* name;
  Vector3d I, omega0;
  Quaterniond q0;
  double t_s;
  Vector3d omega_B;
  Quaterniond q_WB;
  PolhodeRegime regime;
  double L, planeHeight, polhodePeriod, anglePerRadialPeriod, smallestRadius, largestRadius;
};

std::ostream& operator<<(std::ostream& out, const Example& e) { return out << e.name; }

const Quaterniond kLevel = Quaterniond::Identity();

const Example kExamples[] = {
    {"AboutLargest",
     {2, 3, 4},
     {.5, .25, 1},
     kLevel,
     10,
     {0.5236187680914472, -0.1739669918974871, 1.006025997252955},
     {0.62981435521294, -0.2841657890067688, -0.02424579465704587, -0.7224927845780313},
     PolhodeRegime::kAboutLargest,
     4.190763653560053,
     1.1185312242598,
     11.18295442677762,
     9.205124422942755,
     0.1404323099902769,
     0.2630596897205497},
    {"AboutSmallest",
     {2, 3, 4},
     {1, .25, .25},
     kLevel,
     10,
     {0.9383078325604973, -0.4711028357030931, -0.05206528903395389},
     {0.6434603732916287, -0.7324001062683547, -0.07523597350378131, 0.2094955384547341},
     PolhodeRegime::kAboutSmallest,
     2.358495283014151,
     1.033497933006201,
     15.72394674738379,
     5.503334464491742,
     0.1898649234023409,
     0.254351179419145},
    {"Separatrix",
     {1, 2, 2.25},
     {.75, .5, 1},
     kLevel,
     5,
     {0.1257184405295321, 1.271509805025921, 0.1676245873727094},
     {0.8710409312400317, 0.4751788818785033, 0.05965812938122826, -0.1092411731899947},
     PolhodeRegime::kSeparatrix,
     2.57390753524675,
     1.286953767623375,
     kInfinity,
     kInfinity,
     0,
     0.4289845892077917},
    {"Flip",
     {1, 2, 3},
     {0x1p-10, 1, 0},
     kLevel,
     40,
     {0.3041872276674735, -0.9526127671820765, 0.1756216727340402},
     {0.1532492622421823, -0.8002233997206524, 0.01605999925539552, 0.5795681587058286},
     PolhodeRegime::kAboutSmallest,
     2.000000238418565,
     1.000000357627833,
     57.62716233737096,
     27.76639028070468,
     0.0004882811917923495,
     0.5773504756660859},
    {"Football",
     {1.5, 1.5, .9},
     {.5, 0, 2},
     kLevel,
     3,
     {-0.3686968577706227, -0.3377315902755755, 2},
     {0.9333625997272972, -0.129467598587728, 0.3330102937202236, 0.0343007670846943},
     PolhodeRegime::kAboutSmallest,
     1.95,
     2.038461538461538,
     7.853981633974483,
     5.105088062083414,
     0.3076923076923077,
     0.3076923076923077},
    {"OddAxisOrder",
     {3, 1, 2},
     {.25, 1, -.5},
     {.5, .5, .5, .5},
     1e5,
     {0.2529408128816368, 1.00221612662323, 0.4955429704236862},
     {0.584543349906213, -0.02175722928891995, 0.1796768396924888, 0.7909184081384196},
     PolhodeRegime::kAboutSmallest,
     1.600781059358212,
     1.054172892748091,
     10.80934530080282,
     3.694946268975696,
     0.3724506842457427,
     0.5334349496690813},
};

void expectNear(double measured, double expected) {
  if (std::isinf(expected))
    EXPECT_EQ(measured, expected);
  else
    EXPECT_NEAR(measured, expected, 7e-16 * std::abs(expected));  // 5e-16 is what 16 digits hold
}

class FreeMotionExample : public testing::TestWithParam<Example> {};

TEST_P(FreeMotionExample, State) {
  const Example& e = GetParam();
  const RigidBodyState state = FreeMotion(PrincipalMoments(e.I), e.omega0, e.q0).at(e.t_s);
  // Measured: at most 3.1e-16, 2.3e-16.
  expectResidual("attitude, rad",
                 TaylorOracle<long double>::angle({e.q_WB.w(), e.q_WB.x(), e.q_WB.y(), e.q_WB.z()}, state.q_WB),
                 4e-15);
  expectResidual("omega_B, rad/s", (state.omega_B - e.omega_B).norm(), 1e-15);
}

TEST_P(FreeMotionExample, Constants) {
  const Example& e = GetParam();
  const PrincipalMoments moments(e.I);
  const FreeMotion motion(moments, e.omega0, e.q0);
  expectNear(motion.L_W().norm(), e.L);
  expectNear(2 * motion.kineticEnergy() / e.L, e.planeHeight);
  expectNear(PoinsotConstruction(moments, e.omega0).planeHeight(), e.planeHeight);
}

TEST_P(FreeMotionExample, Curves) {
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

TEST(FreeMotionExamples, SemiAxesOfTheEnergyEllipsoid) {
  const PoinsotConstruction construction(PrincipalMoments({2, 3, 4}), {.5, .25, 1});
  // sqrt(2T/I_i) with 2T = 4.6875 by hand.
  EXPECT_NEAR(construction.semiAxes_P()[0], 1.530931089239486, 7e-16);
  EXPECT_EQ(construction.semiAxes_P()[1], 1.25);
  EXPECT_NEAR(construction.semiAxes_P()[2], 1.082531754730548, 7e-16);
}

}  // namespace
}  // namespace poinsot::physics
