// SPDX-License-Identifier: Apache-2.0
// The Earth's wobble by three models, against numbers worked by hand, and the share of the mantle against an
// integral of the Earth's density.
#include "physics/earth.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "physics/catalogue.h"

namespace poinsot::physics {
namespace {

using Eigen::Vector3d;

constexpr double kTurn_s = 2 * 3.14159265358979323846 / 7.292115e-5;  // one turn of the Earth

std::optional<EarthWobble> wobbleOf(const PrincipalMoments& moments, double spin = 7.292115e-5) {
  return earthWobble(moments, *precessionCones(moments, Vector3d(1.145e-10, 0, spin)));
}

// Worked by hand: C - A = 0.003273795 8.0365e37 = 2.6309854e35 kg m²; Omega² a⁵ = 5.3174941e-9 1.0555264e34 =
// 5.6127552e25 m⁵/s²; k_s = 3 G (C - A)/(Omega² a⁵) = 5.2679799e25/5.6127552e25 = 0.9385729; k/k_s =
// 0.298/0.9385729 = 0.3175033. In turns: (1 - H)/H = 304.45590; divided by 0.6824967: 446.0914; times 0.8862136:
// 395.3322.
TEST(Earth, WobblesMoreSlowlyIfElasticAndFasterWithAFluidCore) {
  const EarthWobble wobble = wobbleOf(*findCatalogueBody("earth")->moments).value();
  EXPECT_NEAR(wobble.secularLoveNumber, 0.9385729, 1e-7);
  EXPECT_NEAR(wobble.rigid_s / kTurn_s, 304.45590, 1e-5);
  EXPECT_NEAR(wobble.elastic_s / kTurn_s, 446.0914, 1e-4);
  EXPECT_NEAR(wobble.fluidCore_s / kTurn_s, 395.3322, 1e-4);
}

// The observed period is between both models: oceans and the anelastic mantle, which are left out, lengthen it.
TEST(Earth, IsObservedBetweenTheModels) {
  const EarthWobble wobble = wobbleOf(*findCatalogueBody("earth")->moments).value();
  const double observed_s = earth::kObserved_days * kSolarDay_s;
  EXPECT_GT(observed_s, wobble.fluidCore_s);
  EXPECT_LT(observed_s, wobble.elastic_s);
}

TEST(Earth, IsRecognisedByItsMomentsAndItsSpin) {
  EXPECT_TRUE(wobbleOf(PrincipalMoments({8.0101e37, 8.0101e37, 8.0365e37})));
  EXPECT_FALSE(wobbleOf(PrincipalMoments({1, 1, 1.0033})));  // the Earth's shape, in other units
  EXPECT_FALSE(wobbleOf(PrincipalMoments({8.0101e37, 8.0101e37, 8.0365e37}), 9e-5));
  EXPECT_FALSE(wobbleOf(PrincipalMoments({7.9e37, 7.9e37, 8.0365e37})));
}

/// Shell of the seismic model PREM (A. M. Dziewonski, D. L. Anderson, Phys. Earth Planet. Inter. 25 (1981) 297,
/// table 1). The density, g/cm³, is a polynomial in x = r/6371 km up to this radius.
struct Shell {
  double to_km;
  std::array<double, 4> density;
};

const std::vector<Shell> kPrem = {{1221.5, {13.0885, 0, -8.8381, 0}},
                                  {3480, {12.5815, -1.2638, -3.6426, -5.5281}},
                                  {5701, {7.9565, -6.4761, 5.5283, -3.0807}},
                                  {5771, {5.3197, -1.4836, 0, 0}},
                                  {5971, {11.2494, -8.0298, 0, 0}},
                                  {6151, {7.1089, -3.8045, 0, 0}},
                                  {6346.6, {2.6910, 0.6924, 0, 0}},
                                  {6356, {2.900, 0, 0, 0}},
                                  {6368, {2.600, 0, 0, 0}},
                                  {6371, {1.020, 0, 0, 0}}};

/// Returns the integral of density x^power dx over the first shells, which is proportional to their mass if the
/// power is 2, and to their moment of inertia if it is 4.
double integral(std::size_t shells, int power) {
  double sum = 0, from = 0;
  for (std::size_t i = 0; i < shells; ++i) {
    const double to = kPrem[i].to_km / 6371;
    for (int n = 0; n < 4; ++n)
      sum += kPrem[i].density[static_cast<std::size_t>(n)] *
             (std::pow(to, n + power + 1) - std::pow(from, n + power + 1)) / (n + power + 1);
    from = to;
  }
  return sum;
}

// A check of the table: PREM's Earth has the mean density 5.515 g/cm³ and I/(M a²) = 0.3308.
TEST(Earth, HasTheMassAndMomentThatPremIsMadeFor) {
  EXPECT_NEAR(3 * integral(kPrem.size(), 2), 5.515, 1e-3);
  EXPECT_NEAR(2. / 3 * integral(kPrem.size(), 4) / integral(kPrem.size(), 2), 0.3308, 1e-4);
}

// The inner core, 0.07 % of the moment, floats in the fluid core and counts with it. PREM is a sphere, and the
// published moments are those of an ellipsoid with PREM's density: 2e-5 apart.
TEST(Earth, HasTheShareOfTheMantleThatPremGives) {
  EXPECT_NEAR(1 - integral(2, 4) / integral(kPrem.size(), 4), earth::kMantleShare, 3e-5);
}

}  // namespace
}  // namespace poinsot::physics
