// SPDX-License-Identifier: Apache-2.0
#include "physics/mean_periods.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "core/error.h"
#include "physics/free_motion.h"

namespace poinsot::physics {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

constexpr double kPi = std::numbers::pi;
const PrincipalMoments kMoments({1, 1.5, 2});

template <class Work>
std::string refusal(Work work) {
  try {
    work();
  } catch (const core::Error& error) {
    return error.message();
  }
  return "";
}

// Worked out by hand for small wobbles, in which omega circles an axis at the rate sqrt((I3 - I1)(I3 - I2)/(I1
// I2)) L/I3 (lecture, eq 24). About the short axis, the body and its long axis turn at L/I3. Measured: 2e-9, the
// square of the wobble.
TEST(MeanPeriods, OfASmallWobbleFollowFromEquation24) {
  const auto periods = meanPeriods(kMoments, {1e-5, 0, 1}).value();
  EXPECT_EQ(periods.mode, AxisMode::kShort);
  EXPECT_NEAR(periods.phi_s, 2 * kPi, 1e-8);
  EXPECT_NEAR(periods.psi_s, 2 * kPi / std::sqrt(1 * 0.5 / (1 * 1.5)), 1e-8);
  const auto along = meanPeriods(kMoments, {1, 1e-5, 0}).value();
  EXPECT_EQ(along.mode, AxisMode::kLong);
  EXPECT_NEAR(along.psi_s, 2 * kPi / std::sqrt(0.5 * 1 / (1.5 * 2)), 1e-8);
}

// Oracle: the long axis of the moving body, followed about L over a period of the polhode. Measured: 5e-15.
TEST(MeanPeriods, AreThoseOfTheMotion) {
  for (const Vector3d& omega :
       {Vector3d(0.3, 0.2, 1), Vector3d(1, 0.7, 0.3), Vector3d(0.2, 2, 0.9), Vector3d(2, 1, -0.1)}) {
    const auto [phi_s, psi_s, mode] = meanPeriods(kMoments, omega).value();
    const FreeMotion motion(kMoments, omega, Quaternion::Identity());
    const Vector3d pole = motion.at(0).L_W.normalized(), x = pole.unitOrthogonal(), y = pole.cross(x);
    double turned = 0, before = 0;
    for (int i = 0; i <= 500; ++i) {
      const Vector3d k = motion.at(psi_s * i / 500).q_WB * Vector3d::UnitX();
      const double azimuth = std::atan2(k.dot(y), k.dot(x));
      if (i > 0) turned += std::remainder(azimuth - before, 2 * kPi);
      before = azimuth;
    }
    EXPECT_NEAR(turned * phi_s / (2 * kPi * psi_s), 1, 1e-13) << omega.transpose();
    EXPECT_LT((motion.at(psi_s).omega_B - omega).norm(), 1e-13);
    EXPECT_EQ(mode == AxisMode::kShort,
              kMoments.angularMomentum(omega).squaredNorm() > 3 * kMoments.kineticEnergy(omega));
  }
}

// The periods of the found rotation must be the given ones. Measured: 4e-13, near the separatrix.
TEST(OmegaFromPeriods, HasThePeriods) {
  for (const AxisMode mode : {AxisMode::kShort, AxisMode::kLong})
    for (const double psi_s : {18.0, 25.0, 60.0, 130.0}) {
      const Vector3d omega = omegaFromPeriods(kMoments, {.phi_s = 10, .psi_s = psi_s, .mode = mode, .phase = 0.3});
      const auto periods = meanPeriods(kMoments, omega).value();
      EXPECT_EQ(periods.mode, mode);
      EXPECT_NEAR(periods.phi_s / 10, 1, 1e-11) << psi_s;
      EXPECT_NEAR(periods.psi_s / psi_s, 1, 1e-11) << psi_s;
    }
}

// Worked out by hand: the least ratios are those of small wobbles, 1.73205 = (L/I3)/(0.288675 L) about the short
// axis.
TEST(OmegaFromPeriods, TellsWhichRatiosExist) {
  const auto of = [](double psi_s, std::optional<AxisMode> mode = {}) {
    return refusal([&] { omegaFromPeriods(kMoments, {.phi_s = 10, .psi_s = psi_s, .mode = mode}); });
  };
  EXPECT_THAT(of(10),
              HasSubstr("no rotation of this body has P_psi/P_phi = 1; the ratio is at least 1.73205 if L circles "
                        "the short axis (SAM), and at least 1.4"));
  EXPECT_EQ(of(16), "");  // only about the long axis
  EXPECT_THAT(of(16, AxisMode::kShort), HasSubstr("P_psi/P_phi = 1.6 in this mode"));
  EXPECT_THAT(of(30),
              HasSubstr("two rotations of this body have these periods; choose one by the mode SAM or LAM"));
  EXPECT_EQ(of(30, AxisMode::kLong), "");
  EXPECT_THAT(of(-1), HasSubstr("P_psi must be positive"));
  EXPECT_THAT(refusal([] {
                omegaFromPeriods(PrincipalMoments({1, 1, 2}), {1, 2, std::nullopt});
              }),
              HasSubstr("need three different moments"));
}

TEST(MeanPeriods, DoNotExistForSteadySpinsAndSymmetricBodies) {
  EXPECT_FALSE(meanPeriods(kMoments, {0, 0, 1}));
  EXPECT_FALSE(meanPeriods(kMoments, {0, 0, 0}));
  EXPECT_FALSE(meanPeriods(PrincipalMoments({1, 1, 2}), {1, 0, 1}));
}

}  // namespace
}  // namespace poinsot::physics
