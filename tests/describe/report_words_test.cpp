// SPDX-License-Identifier: Apache-2.0
// Words and sections of `info` and `info --alt` must fit the body. Expected numbers are worked by hand from the
// lecture's equations.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "describe/alt_text.h"
#include "describe/report.h"
#include "request/scene_request.h"

namespace poinsot::describe {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

scene::Scene sceneOf(const std::string& text) {
  return request::loadRequested({"made.toml", text, {}, std::nullopt});
}

std::string body(const std::string& moments, const std::string& motion) {
  return "[body]\nprincipal_moments = " + moments + "\n[motion]\n" + motion + "\n";
}

/// Everything that `info` prints about a scene: table, JSON and alternative text.
struct Printed {
  explicit Printed(const std::string& text) : scene(sceneOf(text)) {
    const Report report = sceneReport(scene);
    table = reportTable(report);
    facts = json::parse(reportJson(report));
    words = altText(scene);
  }

  std::string all() const { return table + facts.dump() + words; }

  scene::Scene scene;
  std::string table, words;
  json facts;
};

auto namesTheEarth() { return ::testing::AnyOf(HasSubstr("Earth"), HasSubstr("handler"), HasSubstr("433 d")); }

// An asteroid's polhode period may be days, too. Small swings about the axis of largest moment take 2 pi over
// w sqrt((I3 - I1)(I3 - I2)/(I1 I2)) (Landau & Lifshitz, section 37); at 1e-4 rad the rest is of order 1e-8.
TEST(ReportWords, OmitTheChandlerPeriodForAnAsymmetricBody) {
  const Printed slow(body("[2, 3, 4]", "omega_body = [1e-9, 0, 1e-5]"));
  EXPECT_THAT(slow.all(), AllOf(Not(HasSubstr("Symmetric top")), Not(namesTheEarth())));
  EXPECT_FALSE(slow.facts.contains("tilt"));
  const double days = 2 * std::numbers::pi / (1e-5 * std::sqrt(2. * 1 / (2 * 3))) / 86400;
  EXPECT_NEAR(slow.facts["polhode_period_days"].get<double>() / days, 1, 1e-7);  // measured 6e-9
}

// One turn a day, as of a geostationary satellite; and the Earth's flattening at another spin.
TEST(ReportWords, OmitTheChandlerPeriodForATopUnlikeTheEarth) {
  for (const char* start : {"omega_body = [1e-7, 0, 7.292115e-5]", "omega_body = [1e-9, 0, 2e-6]"})
    EXPECT_THAT(Printed(body("[1, 1, 1.3]", start)).all(), Not(namesTheEarth())) << start;
  const Printed faster(body("[1, 1, 1.0033]", "omega_body = [1e-7, 0, 9e-5]"));
  EXPECT_THAT(faster.all(), Not(namesTheEarth()));
  // eq 29: 2 pi/(0.0033 9e-5) s. Measured 3e-14, from the rounding of 1.0033.
  const double days = 2 * std::numbers::pi / (0.0033 * 9e-5) / 86400;
  EXPECT_NEAR(faster.facts["polhode_period_days"].get<double>() / days, 1, 1e-12);
}

// H = (C - A)/C = 0.003273795 (IERS Conventions 2010), eq 29: (1 - H)/H = 304.4559 sidereal days of 2 pi/omega_3.
// The other numbers by hand in tests/physics/earth_test.cpp; k_s falls with omega_3², here by 2.3e-7 of its value.
TEST(ReportWords, GiveTheChandlerPeriodsOfTheEarth) {
  const Printed earth("[body]\ncatalogue = \"earth\"\n[motion]\nomega_body = [1.145e-10, 0, 7.2921158553e-5]\n");
  EXPECT_NEAR(earth.facts["chandler_period_sidereal_days"], 304.4559, 1e-4);
  EXPECT_NEAR(earth.facts["chandler_elastic_sidereal_days"], 446.0914, 2e-4);
  EXPECT_NEAR(earth.facts["chandler_fluid_core_sidereal_days"], 395.3322, 2e-4);
  EXPECT_NEAR(earth.facts["secular_love_number"], 0.9385729, 4e-7);
  EXPECT_NEAR(earth.facts["chandler_observed_solar_days"], 433, 1e-12);
  EXPECT_THAT(earth.table, AllOf(HasSubstr("computed: rigid/(1 - k/k_s); 446.09 sidereal d"),
                                 HasSubstr("computed: elastic A_m/A; 395.33 sidereal d"),
                                 HasSubstr("quoted, +- 1.1 d: Wilson & Vicente (1990)")));
}

// Without the unit of the moments, k_s is unknown.
TEST(ReportWords, OmitTheDeformableEarthForMomentsInOtherUnits) {
  const Printed top(body("[1, 1, 1.0033]", "omega_body = [1.145e-10, 0, 7.292115e-5]"));
  EXPECT_TRUE(top.facts.contains("chandler_observed_solar_days"));
  for (const char* key : {"chandler_elastic_solar_days", "chandler_fluid_core_solar_days", "secular_love_number"})
    EXPECT_FALSE(top.facts.contains(key)) << key;
}

// 6356752 m times the angles: 1.145e-10/7.292115e-5 and, between omega and L, H times as much.
TEST(ReportWords, GiveTheDistancesAtThePoleOfTheEarth) {
  const Printed earth("[body]\ncatalogue = \"earth\"\n[motion]\nomega_body = [1.145e-10, 0, 7.292115e-5]\n");
  EXPECT_NEAR(earth.facts["pole_distance"], 9.9813, 1e-4);
  EXPECT_NEAR(earth.facts["pole_distance_of_L"], 9.9813 * 0.003273795, 1e-6);
}

// The body turns about L at L/I1 = 2/1.5 (eq 20), so that the circle closes after 2 pi/(L/I1).
TEST(ReportWords, CallTheHerpolhodeOfASymmetricTopACircle) {
  const Printed top(body("[1.5, 1.5, 0.9]", "omega_body = [0.563491015654266, 0, 2.01401730452589]"));
  EXPECT_EQ(top.facts["herpolhode_closes"], true);
  EXPECT_EQ(top.facts["closure_turns"], 1);
  EXPECT_NEAR(top.facts["closure_time"], 1.5 * std::numbers::pi, 1e-14);  // measured 8.9e-16
  for (const char* key : {"flip_interval", "least_angle_to_middle", "largest_tilt", "radial_period",
                          "angle_per_radial_period", "closure_radial_periods"})
    EXPECT_FALSE(top.facts.contains(key)) << key;
  EXPECT_THAT(top.table, AllOf(Not(HasSubstr("middle axis")), Not(HasSubstr("omega_mid"))));
}

TEST(ReportWords, CallASpinNormalToTheSymmetryAxisSteady) {
  for (const char* moments : {"[1.5, 1.5, 0.9]", "[1.5, 1.5, 2.4]"}) {
    const Printed across(body(moments, "omega_body = [1.2, 1.6, 0]"));
    EXPECT_THAT(across.words, AllOf(HasSubstr("It spins steadily at 2 rad/s"), Not(HasSubstr("wobble"))));
    EXPECT_EQ(across.facts["rolling"], "none");
    EXPECT_EQ(across.facts["regime"], "steady");
  }
}

TEST(ReportWords, CallASpinAboutTheMiddleAxisUnstable) {
  const Printed middle(body("[1, 2, 2.5]", "spin = 2\nspin_axis = \"middle\""));
  // eq 24 to 26, linearised: growth at 2 sqrt((2.5 - 2)(2 - 1)/(1 2.5)) = 0.894/s, by a factor e in 1.118 s.
  EXPECT_THAT(middle.words, HasSubstr("the middle axis e2, is unstable"));
  EXPECT_THAT(middle.words, HasSubstr("grows by a factor of e every 1.12 s"));
  EXPECT_THAT(middle.table, HasSubstr("steady, but unstable: the middle axis"));
  for (const char* axis : {"smallest", "largest"})
    EXPECT_THAT(Printed(body("[1, 2, 2.5]", "spin = 2\nspin_axis = \"" + std::string(axis) + "\"")).all(),
                Not(HasSubstr("unstable: the")));
}

/// Returns a tensor with these moments, turned by q, as a scene file writes its rows.
std::string turnedTensor(const Eigen::Vector3d& moments, const Eigen::Quaterniond& q) {
  const Eigen::Matrix3d R = q.normalized().toRotationMatrix();
  Eigen::Matrix3d I = R * moments.asDiagonal() * R.transpose();
  I = 0.5 * (I + I.transpose().eval());
  json rows = json::array();
  for (int i = 0; i < 3; ++i) rows.push_back({I(i, 0), I(i, 1), I(i, 2)});
  return rows.dump();
}

void expectSteady(const std::string& text) {
  const Printed spin(text);
  EXPECT_EQ(spin.facts["regime"], "steady") << text;
  EXPECT_EQ(spin.facts["flips"], 0) << text;
  EXPECT_THAT(spin.words, AllOf(HasSubstr("It spins steadily"), Not(HasSubstr("Every")))) << text;
}

// A spin along a principal axis is steady for ever by definition, however the body is described.
TEST(ReportWords, CallAPrincipalAxisSpinSteadyInAnyBodyAxes) {
  const Eigen::Quaterniond turns[] = {
      {1, 0.3, -0.2, 0.7}, {0.1, 1, 0.4, -0.3}, {1, 1e-3, 2e-3, -1e-3}, {1, 0, 0, 1e-9}};
  for (const char* axis : {"smallest", "middle", "largest"}) {
    const std::string spin = "[motion]\nspin = -6.1\nspin_axis = \"" + std::string(axis) + "\"\n";
    for (const Eigen::Quaterniond& q : turns)
      expectSteady("[body]\ninertia = " + turnedTensor({1, 2, 2.7}, q) + "\n" + spin);
    for (const char* pivot : {"[0.1, 0.02, -0.03]", "[0, 1e-3, 0.4]"})
      expectSteady("[body]\nshape = \"box\"\nsize = [0.3, 0.2, 0.05]\nmass = 1\npivot = " + std::string(pivot) +
                   "\n" + spin);
  }
}

// The film runs from -7.5 to 2.5 s or from 0 to 10 s at 3 rad/s; 7.5 s are 3.58 turns.
TEST(ReportWords, NameTheTimeSpanOfTheCountedTurns) {
  const std::string start = body("[1, 2, 3]", "omega_body = [0, 0, 3]") + "[time]\nduration = 10\nspeed = 1\n";
  const Printed before(start + "start = -7.5\n"), after(start);
  EXPECT_THAT(before.table, HasSubstr("turns from time 0 to the first frame"));
  EXPECT_THAT(after.table, HasSubstr("turns from time 0 to the end"));
  EXPECT_NEAR(before.facts["turns"], 7.5 * 3 / (2 * std::numbers::pi), 4e-15);  // measured 0 and 0
  EXPECT_NEAR(after.facts["turns"], 10 * 3 / (2 * std::numbers::pi), 4e-15);
  EXPECT_EQ(before.facts["from"]["turns"], "|omega| t/(2 pi), omega at time 0");
}

// Four points of 1 kg at 1 m on x and y have 2, 2, 4 kg m². About a pivot 2 m below they have 2 + 4 2² = 18 about
// x and y.
TEST(ReportWords, SayThatMomentsAreAboutThePivot) {
  const std::string points =
      "[[body.point_mass]]\nmass = 1\nposition = [1, 0, 0]\n[[body.point_mass]]\nmass = 1\nposition = [-1, 0, 0]\n"
      "[[body.point_mass]]\nmass = 1\nposition = [0, 1, 0]\n[[body.point_mass]]\nmass = 1\nposition = [0, -1, 0]\n"
      "[motion]\nomega_body = [0, 0, 1]\n";
  EXPECT_THAT(
      Printed("body.pivot = [0, 0, -2]\n" + points).words,
      HasSubstr("Its principal moments of inertia about that point are 18 kg m² about e1 and e2 and 4 kg m²"));
  EXPECT_THAT(Printed(points).words, HasSubstr("Its principal moments of inertia are 2 kg m² about e1 and e2"));
}

TEST(ReportWords, DefineTheDirectionOfTheSymmetryAxis) {
  const Printed retrograde(body("[1.5, 1.5, 0.9]", "omega_body = [0.5, 0, -3.2]"));
  EXPECT_EQ(retrograde.facts["spin_rate"], 3.2);
  EXPECT_EQ(retrograde.facts["symmetry_axis_B"], json({0.0, 0.0, -1.0}));
  EXPECT_THAT(retrograde.table, HasSubstr("the end with omega_3 >= 0"));
}

}  // namespace
}  // namespace poinsot::describe
