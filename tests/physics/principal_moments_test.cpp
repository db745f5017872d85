// SPDX-License-Identifier: Apache-2.0
#include "physics/principal_moments.h"

#include <gtest/gtest.h>

#include <limits>

#include "physics/mass_testing.h"

namespace poinsot::physics {
namespace {

TEST(PrincipalMoments, AcceptThreeNumbersOrAVector) {
  const Eigen::Vector3d three(1, 2, 2.5);
  EXPECT_EQ(PrincipalMoments(1, 2, 2.5).values(), three);
  EXPECT_EQ(PrincipalMoments({1, 2, 2.5}).values(), three);
  EXPECT_EQ(PrincipalMoments(three).values(), three);
  EXPECT_EQ(PrincipalMoments(0.5 * (three + three)).values(), three);  // an Eigen expression
  EXPECT_THROW(PrincipalMoments(1, 2, 3.5), core::Error);
}

using Eigen::Vector3d;

TEST(PrincipalMoments, AcceptPossibleMoments) {
  EXPECT_EQ(PrincipalMoments({3, 1, 2}).values(), Vector3d(3, 1, 2));  // a lamina
  EXPECT_EQ(PrincipalMoments({0.1, 0.2, 0.30000000000000004}).values()[2], 0.1 + 0.2);
  EXPECT_EQ(PrincipalMoments({1e300, 1e300, 1e300})[1], 1e300);
}

TEST(PrincipalMoments, RejectImpossibleMoments) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal([] {
              PrincipalMoments({0.9, 0.2, 0.1});
            }),
            "no moment may exceed the sum of the other two (a solid body cannot have these values), got "
            "(0.9, 0.2, 0.1) kg·m²");
  EXPECT_EQ(refusal([] {
              PrincipalMoments({1, 0, 1});
            }),
            "principal moments must be positive, got (1, 0, 1) kg·m²");
  EXPECT_EQ(refusal([&] {
              PrincipalMoments({1, nan, 1});
            }),
            "principal moments must be finite, got (1, nan, 1) kg·m²");
}

TEST(PrincipalMoments, GiveAngularMomentumAndEnergy) {
  const PrincipalMoments moments({2, 3, 4});
  EXPECT_EQ(moments.angularMomentum({.5, .25, 1}), Vector3d(1, .75, 4));
  EXPECT_EQ(moments.kineticEnergy({.5, .25, 1}), 2.34375);  // (0.5 + 0.1875 + 4)/2
}

}  // namespace
}  // namespace poinsot::physics
