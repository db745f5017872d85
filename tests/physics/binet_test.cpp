// SPDX-License-Identifier: Apache-2.0
#include "physics/binet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.h"
#include "physics/free_motion.h"
#include "physics/random_bodies.h"
#include "physics/residual.h"

namespace poinsot::physics {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

double energyOf(const PrincipalMoments& moments, const Vector3d& m_P) {
  return 0.5 * m_P.cwiseAbs2().cwiseQuotient(moments.values()).sum();
}

// Worked by hand: |L| = |(1, 0.75, 4)|, semi-axes sqrt(2T I_i) with 2T = 4.6875.
TEST(Binet, RadiusAndSemiAxesMatchAHandComputedExample) {
  const BinetConstruction binet(PrincipalMoments({2, 3, 4}), {.5, .25, 1});
  EXPECT_NEAR(binet.sphereRadius(), 4.190763653560053, 9e-16);
  EXPECT_NEAR(binet.semiAxes_P()[0], std::sqrt(9.375), 5e-16);
  EXPECT_EQ(binet.semiAxes_P()[1], 3.75);
  EXPECT_NEAR(binet.semiAxes_P()[2], std::sqrt(18.75), 9e-16);
}

TEST(Binet, MomentumIsOnTheSphereAndOnTheEllipsoid) {
  Draw draw(281);
  double sphere = 0, ellipsoid = 0;
  for (int i = 0; i < 200; ++i) {
    const PrincipalMoments moments = draw.moments();
    const Vector3d omega0 = draw.direction() * draw.decade(-100, 100);
    const BinetConstruction binet(moments, omega0);
    const FreeMotion motion(moments, omega0, draw.attitude());
    const Vector3d m = moments.angularMomentum(motion.at(draw.between(-50, 50) / omega0.norm()).omega_B);
    sphere = std::max(sphere, std::abs(m.norm() / binet.sphereRadius() - 1));
    ellipsoid = std::max(ellipsoid, std::abs(m.cwiseQuotient(binet.semiAxes_P()).squaredNorm() - 1));
  }
  expectResidual("|m|/L - 1", sphere, 4e-15);          // measured 4.4e-16
  expectResidual("sum (m/a)² - 1", ellipsoid, 4e-15);  // measured 6.7e-16
}

TEST(Binet, RefusesABodyAtRest) {
  EXPECT_THROW(BinetConstruction(PrincipalMoments({2, 3, 4}), {0, 0, 0}), core::Error);
}

// Points of the separatrix have T = L²/(2 I2).
TEST(Separatrix, CirclesHaveTheEnergyOfTheMiddleAxis) {
  Draw draw(282);
  double energy = 0, size = 0, angle = 0;
  for (int i = 0; i < 100; ++i) {
    const PrincipalMoments moments = draw.moments();
    const auto s = separatrix(moments);
    ASSERT_TRUE(s);
    for (const bool mirrored : {false, true}) {
      const auto circle = s->momentumCircle(3, 24, mirrored);
      ASSERT_EQ(circle.size(), 24u);
      for (const Vector3d& m : circle) {
        energy = std::max(energy, std::abs(energyOf(moments, m) * 2 * moments[s->middle] / 9 - 1));
        size = std::max(size, std::abs(m.norm() / 3 - 1));
        const Vector3d omega = m.cwiseQuotient(moments.values());
        angle = std::max(angle, std::abs(std::abs(omega[s->largest]) * std::cos(s->velocityAngle_rad) -
                                         std::abs(omega[s->smallest]) * std::sin(s->velocityAngle_rad)) /
                                    omega.norm());
      }
      EXPECT_GT((mirrored ? -1 : 1) * circle[3][s->largest] * circle[3][s->smallest], 0);
    }
  }
  expectResidual("T against L²/(2 I2), relative", energy, 1e-14);  // measured 6.7e-16
  expectResidual("|m| against L, relative", size, 2e-15);          // measured 2.2e-16
  expectResidual("plane in omega space", angle, 4e-15);            // measured 5.7e-16
}

TEST(Separatrix, HasTheAnglesOfAnExactExample) {
  // For I = (1, 2, 2.25), omega = (.75, .5, 1) and m = (.75, 1, 2.25) lie exactly on the separatrix.
  const auto s = separatrix(PrincipalMoments({1, 2, 2.25}));
  ASSERT_TRUE(s);
  EXPECT_NEAR(std::tan(s->momentumAngle_rad), 3, 4e-15);
  EXPECT_NEAR(std::tan(s->velocityAngle_rad), 4. / 3, 1e-15);
  EXPECT_FALSE(separatrix(PrincipalMoments({2, 2, 3})));
  EXPECT_FALSE(separatrix(PrincipalMoments({2, 3, 2})));
  EXPECT_FALSE(separatrix(PrincipalMoments({2, 1.5, 2})));
}

// Both polhodes of each energy must lie on the sphere, on the ellipsoid and on separate halves. The motion must
// follow them.
TEST(MomentumPolhodes, AreTheIntersectionsOfSphereAndEllipsoid) {
  Draw draw(283);
  double size = 0, energy = 0, motionOff = 0;
  for (int i = 0; i < 40; ++i) {
    const PrincipalMoments moments = draw.moments();
    const double L = draw.decade(-3, 3);
    for (const double T : evenEnergies(moments, L, 3)) {
      const auto curves = momentumPolhodes(moments, T, L, 40);
      ASSERT_EQ(curves.size(), 2u);
      for (const MomentumPolhode& curve : curves) {
        ASSERT_EQ(curve.m_P.size(), 40u);
        for (const Vector3d& m : curve.m_P) {
          size = std::max(size, std::abs(m.norm() / L - 1));
          energy = std::max(energy, std::abs(energyOf(moments, m) / T - 1));
        }
        // A motion from the first point must pass the others: distance of a late m from the nearest point.
        const FreeMotion motion(moments, curve.m_P[0].cwiseQuotient(moments.values()), Quaterniond::Identity());
        const Vector3d late = moments.angularMomentum(motion.at(draw.between(1, 50)).omega_B);
        double nearest = 1e300, gap = 0;
        for (std::size_t j = 0; j < 40; ++j) {
          nearest = std::min(nearest, (late - curve.m_P[j]).norm());
          gap = std::max(gap, (curve.m_P[(j + 1) % 40] - curve.m_P[j]).norm());
        }
        motionOff = std::max(motionOff, nearest / gap);
      }
      int axis = curves[0].regime == PolhodeRegime::kAboutLargest ? moments.ascendingAxes()[2]
                                                                  : moments.ascendingAxes()[0];
      for (const Vector3d& m : curves[0].m_P) EXPECT_GT(m[axis], 0);
      for (const Vector3d& m : curves[1].m_P) EXPECT_LT(m[axis], 0);
    }
  }
  expectResidual("|m| against L, relative", size, 1e-14);                           // measured 4.4e-16
  expectResidual("T, relative", energy, 1e-14);                                     // measured 8.9e-16
  expectResidual("late m from the curve, in gaps of its points", motionOff, 0.75);  // measured 0.5
}

TEST(MomentumPolhodes, AreCirclesOnTheSeparatrix) {
  const PrincipalMoments moments({1, 2, 2.25});
  const auto curves = momentumPolhodes(moments, 4, 4, 16);
  ASSERT_EQ(curves.size(), 2u);
  for (const MomentumPolhode& curve : curves) {
    EXPECT_EQ(curve.regime, PolhodeRegime::kSeparatrix);
    for (const Vector3d& m : curve.m_P) EXPECT_NEAR(energyOf(moments, m), 4, 2e-15);
  }
  EXPECT_LT(curves[0].m_P[2][0] * curves[0].m_P[2][2] * curves[1].m_P[2][0] * curves[1].m_P[2][2], 0);
}

TEST(MomentumPolhodes, AreTwoPointsForASteadySpin) {
  const auto curves = momentumPolhodes(PrincipalMoments({2, 3, 4}), 9, 6, 16);
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(curves[0].m_P, std::vector<Vector3d>{Vector3d(6, 0, 0)});
  EXPECT_EQ(curves[1].m_P, std::vector<Vector3d>{Vector3d(-6, 0, 0)});
  EXPECT_THROW(momentumPolhodes(PrincipalMoments({2, 3, 4}), 9, 1, 16), core::Error);
}

TEST(EvenEnergies, AscendFromTheLargestAxisAndSkipTheSeparatrix) {
  const PrincipalMoments moments({3, 2, 4});
  const auto energies = evenEnergies(moments, 2, 4);
  ASSERT_EQ(energies.size(), 8u);
  EXPECT_TRUE(std::ranges::is_sorted(energies));
  EXPECT_GT(energies.front(), 0.5);  // L²/(2 I3)
  EXPECT_LT(energies[3], 4. / 6);    // L²/(2 I2)
  EXPECT_GT(energies[4], 4. / 6);
  EXPECT_LT(energies.back(), 1);  // L²/(2 I1)
  EXPECT_EQ(evenEnergies(PrincipalMoments({2, 2, 3}), 2, 4).size(), 4u);
  EXPECT_EQ(evenEnergies(PrincipalMoments({1.5, 2, 2}), 2, 4).size(), 4u);
  EXPECT_TRUE(evenEnergies(PrincipalMoments({2, 2, 2}), 2, 4).empty());
  EXPECT_THROW(evenEnergies(moments, 0, 4), std::logic_error);
}

// A curve moved to another energy must lie on the ellipsoid of that energy in omega space.
TEST(MomentumPolhodes, CanBeMovedToAnotherEnergy) {
  const PrincipalMoments moments({2, 3, 4});
  for (const double T : evenEnergies(moments, 2, 3))
    for (const MomentumPolhode& curve : momentumPolhodes(moments, T, 2, 16)) {
      const auto omegas = onEnergyEllipsoid(curve, moments, 7);
      ASSERT_EQ(omegas.size(), 16u);
      const double L = moments.angularMomentum(omegas[0]).norm();
      for (const Vector3d& omega : omegas) {
        EXPECT_NEAR(moments.kineticEnergy(omega), 7, 4e-14);
        EXPECT_NEAR(moments.angularMomentum(omega).norm(), L, 1e-13);
      }
    }
}

TEST(Separatrix, RejectsNegativeAndInfiniteMomentum) {
  const Separatrix parting = *separatrix(PrincipalMoments({1, 2, 2.5}));
  for (const double bad : std::array<double, 3>{NAN, INFINITY, -1})
    EXPECT_THROW(parting.momentumCircle(bad, 9, false), core::Error);
  EXPECT_EQ(parting.momentumCircle(0, 9, false)[3], Vector3d(0, 0, 0));
}

}  // namespace
}  // namespace poinsot::physics
