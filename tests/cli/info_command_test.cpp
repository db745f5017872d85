// SPDX-License-Identifier: Apache-2.0
// Compares the numbers of `info` with values computed beforehand to 50 digits or by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "support/development_examples.h"
#include "support/program_run.h"

namespace poinsot {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;

constexpr double kDegree = std::numbers::pi / 180;

class InfoCommand : public testing::Test {
 protected:
  nlohmann::json info(const std::string& moments, const std::string& omega, const std::string& more = "") const {
    folder_.put("s.toml",
                "[body]\nprincipal_moments = " + moments + "\n[motion]\nomega_body = " + omega + "\n" + more);
    const auto result = run(folder_, {"info", "s.toml", "--json"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return nlohmann::json::parse(result.out);
  }

  ScratchFolder folder_;
};

void expectNear(const nlohmann::json& json, const char* key, double expected, double relative = 1e-15) {
  if (std::isinf(expected))
    EXPECT_TRUE(json.at(key).is_null()) << key;
  else
    EXPECT_NEAR(json.at(key).get<double>(), expected, relative * std::abs(expected)) << key;
}

std::string listed(const Eigen::Vector3d& v) {
  nlohmann::json list{v[0], v[1], v[2]};
  return list.dump();
}

// A page has at most 60 lines. It omits details only, and --all has every quantity of the JSON.
TEST_F(InfoCommand, PrintsAPageForEverySceneOfTheGallery) {
  for (const auto& entry : std::filesystem::directory_iterator(POINSOT_SOURCE_DIR "/scenes")) {
    if (entry.path().extension() != ".toml") continue;
    SCOPED_TRACE(entry.path());
    const auto page = run(folder_, {"info", entry.path().string()});
    const auto all = run(folder_, {"info", entry.path().string(), "--all"});
    ASSERT_EQ(page.exitCode, 0) << page.err;
    const auto lines = std::ranges::count(page.out, '\n');
    EXPECT_LE(lines, 60);
    const std::size_t end = page.out.find(" more with --all\n");
    ASSERT_NE(end, std::string::npos);
    const int omitted = std::stoi(page.out.substr(page.out.rfind('\n', end) + 1));
    EXPECT_GE(std::ranges::count(all.out, '\n'), lines - 2 + omitted);  // without a blank line and the last line
    EXPECT_THAT(page.out, HasSubstr("principal moments"));
    EXPECT_THAT(all.out, HasSubstr("principal axis e2"));
    EXPECT_THAT(all.out, HasSubstr("orientation q"));
  }
}

TEST_F(InfoCommand, MatchesTheDevelopmentExamples) {
  const std::map<physics::PolhodeRegime, std::string> words{
      {physics::PolhodeRegime::kAboutLargest, "about_largest"},
      {physics::PolhodeRegime::kAboutSmallest, "about_smallest"},
      {physics::PolhodeRegime::kSeparatrix, "separatrix"}};
  for (const physics::Example& e : physics::kExamples) {
    SCOPED_TRACE(e.name);
    const auto json = info(listed(e.I), listed(e.omega0));
    EXPECT_EQ(json.at("regime"), words.at(e.regime));
    expectNear(json, "L", e.L);
    expectNear(json, "plane_height", e.planeHeight);
    expectNear(json, "polhode_period", e.polhodePeriod);
    const bool symmetric = e.I[0] == e.I[1] || e.I[1] == e.I[2];  // no middle axis; the herpolhode is a circle
    EXPECT_EQ(json.contains("flip_interval"), !symmetric);
    EXPECT_EQ(json.contains("angle_per_radial_period"), !symmetric);
    if (!symmetric) {
      expectNear(json, "flip_interval", e.polhodePeriod / 2);
      expectNear(json, "angle_per_radial_period", e.anglePerRadialPeriod);
    }
    expectNear(json, "herpolhode_smallest_radius", e.smallestRadius);
    expectNear(json, "herpolhode_largest_radius", e.largestRadius);
  }
}

TEST_F(InfoCommand, ReportsEllipsoidAndInertiaTensor) {
  const auto json = info("[2, 3, 4]", "[0.5, 0.25, 1]");
  const double expected[] = {1.530931089239486, 1.25, 1.082531754730548};  // sqrt(4.6875/I_i)
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(json.at("ellipsoid_semi_axes")[i].get<double>(), expected[i], 1e-15);
  EXPECT_EQ(json.at("inertia_tensor_B"), nlohmann::json::parse("[[2,0,0],[0,3,0],[0,0,4]]"));
  EXPECT_EQ(json.at("T"), 2.34375);
  EXPECT_EQ(json.at("units").at("plane_height"), "rad/s");
  EXPECT_EQ(json.at("from").at("plane_height"), "eq 40");
}

TEST_F(InfoCommand, DetectsClosedHerpolhodes) {
  const auto about3 = info("[1.25, 2, 2.75]", "[1.577034598253537625, 0, 1.5]");
  EXPECT_EQ(about3.at("herpolhode_closes"), true);
  EXPECT_EQ(about3.at("closure_radial_periods"), 5);
  EXPECT_EQ(about3.at("closure_turns"), 8);
  expectNear(about3, "closure_time", 18.44647312604001);
  const auto about1 = info("[1.25, 2, 2.75]", "[1.5, 0, 0.422945230106353779731]");
  EXPECT_EQ(about1.at("closure_radial_periods"), 4);
  EXPECT_EQ(about1.at("closure_turns"), 3);
  EXPECT_EQ(info("[2, 3, 4]", "[0.5, 0.25, 1]").at("herpolhode_closes"), false);
}

TEST_F(InfoCommand, ReportsPrecessionOfAProlateTop) {
  // I1 = 1.5, I3 = 0.9, L = 2, theta = 25 deg: omega_1 = L sin theta/I1, omega_3 = L cos theta/I3 to 15 digits.
  const auto json = info("[1.5, 1.5, 0.9]", "[0.563491015654266, 0, 2.01401730452589]");
  expectNear(json, "tilt", 25 * kDegree, 5e-15);
  expectNear(json, "precession_rate", 4.0 / 3, 5e-15);
  expectNear(json, "hand_finch_spin", 0.805606921810356, 5e-15);
  expectNear(json, "body_precession_rate", -0.805606921810356, 5e-15);
  expectNear(json, "body_cone_half_angle", 15.6308012665084 * kDegree, 5e-15);
  expectNear(json, "space_cone_half_angle", 9.36919873349163 * kDegree, 5e-15);
  EXPECT_EQ(json.at("rolling"), "outside");
  EXPECT_FALSE(json.contains("chandler_period_solar_days"));
}

TEST_F(InfoCommand, ReportsChandlersPeriod) {
  // I3/I1 - 1 = 0.0033 gives 1/0.0033 sidereal days of 86164.0905 s; omega_3 = 2 pi/86164.0905 s.
  const auto json = info("[1, 1, 1.0033]", listed({1e-10, 0, 2 * std::numbers::pi / 86164.0905}));
  expectNear(json, "chandler_period_sidereal_days", 303.030303, 1e-8);
  expectNear(json, "chandler_period_solar_days", 302.2028988, 1e-8);
}

TEST_F(InfoCommand, ReportsFlipIntervalOfATHandle) {
  const std::pair<const char*, double> cases[] = {
      {"0.1", 3.31061953}, {"0.01", 4.69446708}, {"0.001", 6.07814236}, {"0.0001", 7.46181502}};
  for (const auto& [disturbance, interval_s] : cases) {
    const auto json = info("[0.279722222222222, 0.513333333333333, 0.773055555555556]",
                           std::string("[") + disturbance + ", \"1 rev/s\", 0]");
    expectNear(json, "flip_interval", interval_s, 5e-9);  // the source gives as many digits
    EXPECT_EQ(json.at("axis_2_stability"), "unstable");
    EXPECT_NEAR(json.at("axis_2_rate").get<double>(), 3.3282, 1e-3);
    EXPECT_EQ(json.at("axis_1_stability"), "stable");
  }
}

TEST_F(InfoCommand, ReportsPrecessionAndNutationOfAHeavyTop) {
  // Released with spin only at 30 deg from the vertical: q = (cos 15 deg, sin 15 deg, 0, 0).
  const auto json = info("[1.40625, 1.40625, 0.65625]", "[0, 0, 9.15625]",
                         "orientation = [0.9659258262890683, 0.25881904510252074, 0, "
                         "0]\n[motion.gravity]\nmgr_body = [0, 0, 2.84375]\n");
  expectNear(json, "sleeping_spin", 6.09449400220044, 5e-15);
  expectNear(json, "slow_precession_rate", 0.530251265914263, 5e-15);
  expectNear(json, "fast_precession_rate", 4.40368790953541, 5e-15);
  expectNear(json, "nutation_least_tilt", 30 * kDegree, 5e-15);
  expectNear(json, "nutation_largest_tilt", 38.840183490757 * kDegree, 5e-14);
  expectNear(json, "nutation_period", 1.83064120697989845, 5e-15);
  expectNear(json, "precession_per_nutation", 0.958047879275758037, 5e-14);
  EXPECT_LE(json.at("estimated_attitude_error").get<double>(), 1e-12);  // the default tolerance
  EXPECT_LE(json.at("energy_drift").get<double>(), 1e-11);
  EXPECT_EQ(json.at("order"), 6);
  EXPECT_FALSE(json.contains("polhode_period"));  // only free motion has a polhode
}

TEST_F(InfoCommand, ReportsFinalSpinOfExplorer1) {
  // Computed by hand: 750 rpm I3/Ip and T0 I3/Ip; omega across the axis is negligible.
  const auto json = info("[4.81758709666667, 4.81758709666667, 0.04034536]", "[1e-9, 0, \"750 rpm\"]",
                         "[motion.dissipation]\nalpha = 0.0014\n");
  expectNear(json, "final_spin_rpm", 6.28094923721, 1e-11);  // the source gives as many digits
  expectNear(json, "final_T_part", 0.00837459898295, 1e-11);
  EXPECT_FALSE(info("[1, 2, 3]", "[0, 0, 1]", "[motion.dissipation]\nalpha = 0.1\n").contains("final_T"));
}

TEST_F(InfoCommand, ReportsDragTimes) {
  const auto json = info("[1, 2, 3]", "[0, 0, 1]", "[motion.drag]\nrate = [0.5, 0.25, 0]\n");
  EXPECT_EQ(json.at("drag_times"), nlohmann::json::parse("[2, 4, null]"));
}

TEST_F(InfoCommand, ReportsFewerMeaningfulDigitsForLongerTimes) {
  const auto turns = [&](const char* speed) {
    return info("[2, 3, 4]", "[0.5, 0.25, 1]", std::string("[time]\nduration = 10\nspeed = ") + speed + "\n");
  };
  const auto brief = turns("1"), lengthy = turns("1e5");
  // |omega| = sqrt(1.3125) rad/s gives the turns in 1e6 s.
  expectNear(lengthy, "turns", std::sqrt(1.3125) * 1e6 / (2 * std::numbers::pi), 1e-14);
  EXPECT_NEAR(brief.at("meaningful_digits").get<double>() - lengthy.at("meaningful_digits").get<double>(), 5, 0.5);
}

// Sums over the three masses by hand, in y: R x M V, R x (omega x M c), M c x V and I_K omega.
TEST_F(InfoCommand, ReportsTheTermsOfTheReferencePoint) {
  const auto result = run(folder_, {"info", POINSOT_SOURCE_DIR "/scenes/thrown_particles.toml", "--json"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  const auto expectAlongY = [&](const char* key, double expected) {
    EXPECT_NEAR(json.at(key)[0].get<double>(), 0, 1e-15) << key;
    EXPECT_NEAR(json.at(key)[1].get<double>(), expected, 2e-15) << key;
    EXPECT_NEAR(json.at(key)[2].get<double>(), 0, 1e-15) << key;
  };
  expectAlongY("L_K_translation_W", 3.4);
  expectAlongY("L_K_mixed_1_W", -0.72);
  expectAlongY("L_K_mixed_2_W", -0.4);
  expectAlongY("L_K_rotation_W", 0.8);
  expectAlongY("L_K_sum_W", 3.08);
  expectAlongY("L_particles_W", 3.08);
  expectAlongY("L_total_W", 3.08);
  EXPECT_EQ(json.at("mixed_terms_vanish"), false);
  const auto centre = run(folder_, {"info", POINSOT_SOURCE_DIR "/scenes/thrown_particles.toml", "-D",
                                    "motion.flight.point=[0.2, 0, 0.1]", "--json"});
  EXPECT_EQ(nlohmann::json::parse(centre.out).at("mixed_terms_vanish"), true);
}

// A cube of 2 m and 6 kg is held 1 m below its centre, and turns at 2 rad/s about x: I_cm is 4 kg m^2, the centre
// moves at 2 m/s, and M a^2 is 6 kg m^2.
TEST_F(InfoCommand, ReportsBothTensorsAndBothPartsOfTAboutAPivot) {
  folder_.put(
      "s.toml",
      "[body]\nshape = 'cube'\nedge = 2\nmass = 6\npivot = [0, 0, -1]\n[motion]\nomega_body = [2, 0, 0]\n");
  const auto json = nlohmann::json::parse(run(folder_, {"info", "s.toml", "--json"}).out);
  EXPECT_EQ(json.at("inertia_centre_B"), nlohmann::json::parse("[[4,0,0],[0,4,0],[0,0,4]]"));
  EXPECT_EQ(json.at("inertia_displacement_B"), nlohmann::json::parse("[[6,0,0],[0,6,0],[0,0,0]]"));
  EXPECT_EQ(json.at("displacement_B"), nlohmann::json::parse("[0,0,-1]"));
  EXPECT_EQ(json.at("T"), 20);
  EXPECT_EQ(json.at("T_translation"), 12);
  EXPECT_EQ(json.at("T_about_centre"), 8);
  EXPECT_EQ(json.at("from").at("T"), "eq 11, 12");
}

TEST_F(InfoCommand, ReportsTheTensorAlongOwnAxesAndBack) {
  folder_.put("s.toml",
              "[body]\ninertia = [[2, 1, 0], [1, 2, 0], [0, 0, 3]]\nown_axes.rotation = [1, 0, 0, 1]\n[motion]\n"
              "omega_body = [0, 0, 1]\n");
  const auto json = nlohmann::json::parse(run(folder_, {"info", "s.toml", "--json"}).out);
  EXPECT_EQ(json.at("U_own"), nlohmann::json::parse("[[0,1,0],[-1,0,0],[0,0,1]]"));
  EXPECT_EQ(json.at("inertia_own_A"), nlohmann::json::parse("[[2,-1,0],[-1,2,0],[0,0,3]]"));
  EXPECT_EQ(json.at("inertia_own_B"), nlohmann::json::parse("[[2,1,0],[1,2,0],[0,0,3]]"));
  EXPECT_NEAR(std::abs(json.at("U_principal")[0][0].get<double>()), std::sqrt(0.5), 1e-15);
}

TEST_F(InfoCommand, PrintsATable) {
  folder_.put("a.toml", kGoodScene);
  const auto result = run(folder_, {"info", "a.toml"});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_THAT(result.out,
              ContainsRegex("kinetic energy of rotation T +100.005 J +eq 12\n"));  // (0.1^2 + 2 10^2)/2
  EXPECT_THAT(result.out, ContainsRegex("height of the invariable plane .* rad/s +eq 40\n"));
  EXPECT_THAT(result.out, ContainsRegex("principal moments about e1, e2, e3 +\\(1, 2, 3\\) kg m\\^2 +eq 17\n"));
  EXPECT_THAT(result.out, HasSubstr("spin about e2"));
}

TEST_F(InfoCommand, ReportsASphereAsSteady) {
  const auto sphere = info("[2, 2, 2]", "[0, 0, 3]");
  EXPECT_EQ(sphere.at("regime"), "steady");
  EXPECT_EQ(sphere.at("hand_finch_spin"), 0);  // eq 21: the strange spin of a sphere
  EXPECT_EQ(sphere.at("axis_3_stability"), "neutral");
  EXPECT_FALSE(sphere.contains("polhode_period"));
}

double largestOf(const nlohmann::json& value) {
  double largest = value.is_number() ? std::abs(value.get<double>()) : 0;
  if (value.is_array())
    for (const auto& element : value) largest = std::max(largest, largestOf(element));
  return largest;
}

/// Expects numbers to agree to `tolerance` and all other values to be equal.
void expectSame(const nlohmann::json& expected, const nlohmann::json& got, double tolerance,
                const std::string& key) {
  if (expected.is_number()) {
    EXPECT_NEAR(got.get<double>(), expected.get<double>(), tolerance) << key;
  } else if (expected.is_array()) {
    ASSERT_EQ(got.size(), expected.size()) << key;
    for (std::size_t i = 0; i < expected.size(); ++i) expectSame(expected[i], got[i], tolerance, key);
  } else {
    EXPECT_EQ(got, expected) << key;
  }
}

// A cylinder of 2 kg, 0.5 m in radius and 1.5 m high, given as a shape and by its mass and moments: M r²/2 = 0.25
// and M (3 r² + h²)/12 = 0.5 kg m². It hangs inclined under gravity, is thrown, and moves freely.
TEST_F(InfoCommand, ReportsTheSameForASolidAndForItsMassAndMoments) {
  const std::string motions[] = {
      "pivot = [0, 0, -1]\n[motion]\nomega_body = [0.5, 0, 20]\norientation = [0.9, 0.4, 0, 0]\n"
      "[motion.gravity]\ng = 8\n",
      "[motion]\nomega_body = [0.5, 0, 3]\n[motion.flight]\nvelocity = [1, 2, 3]\nposition = [4, 5, 6]\n",
      "[motion]\nomega_body = [0.5, 0, 3]\n"};
  for (const std::string& motion : motions) {
    folder_.put("s.toml", "[body]\nmass = 2\nshape = 'cylinder'\nradius = 0.5\nheight = 1.5\n" + motion);
    const auto solid = nlohmann::json::parse(run(folder_, {"info", "s.toml", "--json"}).out);
    for (const char* moments :
         {"principal_moments = [0.5, 0.5, 0.25]\n", "inertia = [[0.5, 0, 0], [0, 0.5, 0], [0, 0, 0.25]]\n"}) {
      folder_.put("s.toml", "[body]\nmass = 2\n" + std::string(moments) + motion);
      const auto measured = nlohmann::json::parse(run(folder_, {"info", "s.toml", "--json"}).out);
      ASSERT_EQ(measured.size(), solid.size());
      for (const auto& [key, value] : solid.items())
        expectSame(value, measured.at(key), 1e-13 * largestOf(value), key);  // measured: equal
    }
  }
}

// Computed by hand for 16642 kg at 1 m/s: P = 16642 kg m/s, M V²/2 = 8321 J, the weight M g = 16642 · 9.80665 N. T
// = ω·I·ω/2 of the tensor is in deg²/s², or 76.6885 J in SI units.
TEST_F(InfoCommand, ReportsMomentumAndEnergyOfAFlight) {
  folder_.put(
      "s.toml",
      "[body]\nmass = 16642\ninertia = [[36502.7, 27.1, -233.2], [27.1, 38372.4, -1152.4], [-233.2, -1152.4, "
      "36514.9]]\n[motion]\nomega_body = ['1 deg/s', '2 deg/s', '3 deg/s']\n[motion.flight]\nvelocity = [1, 0, "
      "0]\n");
  const auto result = run(folder_, {"info", "s.toml", "--json"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  const double T =
      (36502.7 + 4 * 38372.4 + 9 * 36514.9 + 2 * (2 * 27.1 - 3 * 233.2 - 6 * 1152.4)) / 2 * kDegree * kDegree;
  EXPECT_EQ(json.at("mass"), 16642);
  EXPECT_EQ(json.at("P_W"), nlohmann::json::parse("[16642, 0, 0]"));
  EXPECT_NEAR(json.at("force_W")[2].get<double>(), -16642 * 9.80665, 3e-11);  // measured: equal; 3e-11 is an ulp
  expectNear(json, "T_translation", 8321);
  expectNear(json, "T", T, 1e-14);
  expectNear(json, "T_total", 8321 + T, 1e-14);
}

// A toy gyroscope given by mass, moments and arm: M = 0.17 kg, I3 = 2.5e-4, I1 = 1.25e-4 kg m² about its centre,
// arm 0.1 m, level, 280 rad/s. Slow precession M g l/(I3 omega_3) = 0.17 · 9.8 · 0.1/0.07 = 2.38 rad/s, by hand.
TEST_F(InfoCommand, ReportsPrecessionOfAGyroscope) {
  folder_.put("s.toml",
              "[body]\nprincipal_moments = [1.25e-4, 1.25e-4, 2.5e-4]\nmass = '170 g'\npivot = [0, 0, '-10 cm']\n"
              "[motion]\nomega_body = [0, 0, 280]\norientation = [1, 1, 0, 0]\n[motion.gravity]\ng = 9.8\n");
  const auto json = nlohmann::json::parse(run(folder_, {"info", "s.toml", "--json"}).out);
  expectNear(json, "weight_moment", 0.1666, 1e-14);
  expectNear(json, "slow_precession_rate", 2.38, 1e-14);
  // The mean precession includes the nutation, which slows it by less than 1 %.
  expectNear(json, "precession_period", 2 * std::numbers::pi / 2.38, 0.01);
  const double film_s = json.at("motion_to");
  expectNear(json, "precession_turns", film_s / json.at("precession_period").get<double>(), 1e-14);
  expectNear(json, "precession_turns", 5 / (2 * std::numbers::pi), 1e-12);  // half a radian in each of 10 s
  EXPECT_EQ(json.at("from").at("pace"), "chosen: time.speed is not given");
}

TEST_F(InfoCommand, ExitsWith4IfOutputIsLost) {
  folder_.put("a.toml", kGoodScene);
  EXPECT_EQ(run(folder_, {"info", "a.toml"}, Stdout::kFull).exitCode, 4);
  EXPECT_EQ(run(folder_, {"info", "no.toml"}).exitCode, 2);
}

}  // namespace
}  // namespace poinsot
