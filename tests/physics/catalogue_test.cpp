// SPDX-License-Identifier: Apache-2.0
#include "physics/catalogue.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "physics/principal_axes.h"
#include "physics/residual.h"

namespace poinsot::physics {
namespace {

using Eigen::Vector3d;

const CatalogueBody& named(const char* name) {
  const CatalogueBody* body = findCatalogueBody(name);
  if (body == nullptr) throw std::out_of_range(name);
  return *body;
}

Vector3d momentsOf(const char* name) {
  return PrincipalAxes(massProperties(named(name)).inertia_B()).moments().values();
}

TEST(Catalogue, HasTheBodiesOfTheLecture) {
  for (const char* name : {"t_handle", "racket", "book", "phone", "football", "frisbee", "wing_nut", "explorer_1",
                           "earth", "toutatis"})
    EXPECT_NE(findCatalogueBody(name), nullptr) << name;
  EXPECT_EQ(findCatalogueBody("Earth"), nullptr);
  EXPECT_EQ(findCatalogueBody(""), nullptr);
}

TEST(Catalogue, ContainsOnlyPossibleBodiesWithSources) {
  std::set<std::string> names;
  for (const CatalogueBody& body : catalogue()) {
    EXPECT_TRUE(names.insert(body.name).second) << body.name;
    EXPECT_EQ(body.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_0123456789"), std::string::npos);
    const MassProperties whole = massProperties(body);
    EXPECT_NEAR(whole.mass_kg() / body.mass_kg, 1, 5e-16) << body.name;
    EXPECT_TRUE(PrincipalAxes(whole.inertia_B()).aligned()) << body.name << ": described in its principal axes";
    double parts_kg = 0;
    for (const SolidPart& part : body.parts) parts_kg += part.mass_kg;
    EXPECT_NEAR(parts_kg / body.mass_kg, 1, 5e-16) << body.name;
    EXPECT_FALSE(body.title.empty());
    EXPECT_NE(body.source.find("Assumed"), std::string::npos) << body.name;
    EXPECT_EQ(body.source.find("Published") == std::string::npos,
              body.name == "t_handle" || body.name == "racket");
  }
}

// Moments of the satellite as a uniform cylinder, m (3 r² + h²)/12 and m r²/2, evaluated apart from the code.
TEST(Catalogue, Explorer1HasTheMomentsOfACylinder) {
  const Vector3d expected(4.81758709666667, 4.81758709666667, 0.04034536);
  expectResidual("Explorer 1", (momentsOf("explorer_1") - expected).cwiseQuotient(expected).cwiseAbs().maxCoeff(),
                 2e-15);  // measured 9.2e-16
}

// A hull between similar ellipsoids has the moment m (b² + c²)/3 about a. The hull is drawn closed.
TEST(Catalogue, FootballHasTheMomentsOfAHull) {
  const double inch = 0.0254, b = 21.125 * inch / (2 * M_PI), c = 11.125 * inch / 2, m = 14.5 * 0.028349523125;
  const Vector3d expected = m / 3 * Vector3d(b * b + c * c, b * b + c * c, 2 * b * b);
  expectResidual("football", (momentsOf("football") - expected).cwiseQuotient(expected).cwiseAbs().maxCoeff(),
                 2e-15);  // measured 0
  EXPECT_TRUE(std::holds_alternative<Ellipsoid>(named("football").parts.at(0).solid));
}

// H = 0.0032737949 gives a period of 304.46 sidereal days (eq 29).
TEST(Catalogue, EarthHasThePublishedDynamicalFlattening) {
  const Vector3d I = momentsOf("earth");
  EXPECT_EQ(I[0], I[1]);
  EXPECT_NEAR(I[0] / (I[2] - I[0]), 304.46, .005);
  EXPECT_NEAR(named("earth").mass_kg, 5.9722e24, 1e20);
}

TEST(Catalogue, ToutatisHasThePublishedRatios) {
  const Vector3d I = momentsOf("toutatis");
  EXPECT_NEAR(I[0] / I[2], 3.0836, 1e-15);
  EXPECT_NEAR(I[1] / I[2], 3.235, 1e-15);
}

// The lecture flips the first five bodies about these axes.
TEST(Catalogue, FlippingBodiesSpinAboutTheMiddleAxis) {
  const auto isMiddle = [](const Vector3d& I, int axis) {
    return I[axis] > I.minCoeff() && I[axis] < I.maxCoeff();
  };
  EXPECT_TRUE(isMiddle(momentsOf("t_handle"), 1));  // the shaft
  EXPECT_TRUE(isMiddle(momentsOf("wing_nut"), 2));  // the hub
  EXPECT_TRUE(isMiddle(momentsOf("racket"), 1));    // across the handle, in the face
  EXPECT_TRUE(isMiddle(momentsOf("book"), 1));
  EXPECT_TRUE(isMiddle(momentsOf("phone"), 0));
  const Vector3d disc = momentsOf("frisbee"), ball = momentsOf("football");
  EXPECT_GT(disc[2], disc[0]);  // oblate
  EXPECT_LT(ball[2], ball[0]);  // prolate
}

}  // namespace
}  // namespace poinsot::physics
