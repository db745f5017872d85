// SPDX-License-Identifier: Apache-2.0
// Table and JSON of a report. tests/cli/info_command_test.cpp compares its numbers with worked values.
#include "describe/report.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>
#include <regex>

#include "describe/report_loop.h"
#include "request/scene_request.h"

namespace poinsot::describe {
namespace {

using nlohmann::json;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kSource = POINSOT_SOURCE_DIR;

Report reportOf(const std::string& text) {
  return sceneReport(request::loadRequested({"made.toml", text, {}, std::nullopt}));
}

std::string start(const std::string& moments, const std::string& omega) {
  return "[body]\nprincipal_moments = " + moments + "\n[motion]\nomega_body = " + omega + "\n";
}

Report oneFact(const std::string& key, const FactValue& value, const std::string& unit = "") {
  Section section{"Title", {}};
  section.add(key, "label", value, unit, "eq 7");
  return {"name", {section}};
}

TEST(Report, OmitsDetailsFromThePage) {
  Report report = oneFact("key", 2.5, "s");
  report.sections[0].addDetail("other", "detail", 3.5, "s", "eq 8");
  report.sections.push_back({"Details", {}});
  report.sections[1].addDetail("third", "another", 4.5, "s", "");
  EXPECT_EQ(reportTable(report, kUsualDigits, TableExtent::kPage),
            "name\n\nTitle\n  label  2.5 s  eq 7\n\n2 more with --all\n");
  EXPECT_EQ(reportTable(report),
            "name\n\nTitle\n  label    2.5 s  eq 7\n  detail   3.5 s  eq 8\n\nDetails\n  another  4.5 s\n");
  EXPECT_EQ(json::parse(reportJson(report)).at("third"), 4.5);
}

TEST(Report, ShowsFiveNumbersOfAList) {
  const std::vector<double> five{1, 2, 3, 4, 5}, seven{1, 2, 3, 4, 5, 6, 7};
  EXPECT_THAT(reportTable(oneFact("key", five, "s")), HasSubstr("(1, 2, 3, 4, 5) s"));
  EXPECT_THAT(reportTable(oneFact("key", seven, "s")), HasSubstr("(1, 2, 3, 4, ..., 7) s, 7 in all"));
  EXPECT_EQ(json::parse(reportJson(oneFact("key", seven, "s"))).at("key").size(), 7u);
}

// Textbooks give products of inertia either sign. A body without products needs no note about the sign.
TEST(Report, NamesTheSignOfProductsOfInertia) {
  const auto sourceFor = [](const std::string& inertia) {
    const Report report = reportOf("[body]\ninertia = " + inertia + "\n[motion]\nomega_body = [0.1, 0.2, 1]\n");
    return json::parse(reportJson(report)).at("from").at("inertia_tensor_B").get<std::string>();
  };
  EXPECT_EQ(sourceFor("[[2, 0.1, 0], [0.1, 3, 0], [0, 0, 4]]"), "eq 7, 13; off the diagonal -(sum of m x y)");
  EXPECT_EQ(sourceFor("[[2, 0, 0], [0, 3, 0], [0, 0, 4]]"), "eq 7, 13");
}

TEST(Report, FormatsOneFactAsATable) {
  EXPECT_EQ(reportTable(oneFact("key", 2.5, "s")), "name\n\nTitle\n  label  2.5 s  eq 7\n");
  EXPECT_THAT(reportTable(oneFact("key", std::numbers::pi / 6, "rad")), HasSubstr("0.523599 rad (30 deg)"));
  EXPECT_THAT(reportTable(oneFact("key", true)), HasSubstr("yes"));
  EXPECT_EQ(reportTable({"name", {{"Empty", {}}}}), "name\n");
}

TEST(Report, AlignsColumnsByTheirWidestText) {
  Report report = oneFact("key", Eigen::Matrix3d(Eigen::Vector3d(1, 22, 333).asDiagonal()), "kg m^2");
  report.sections[0].add("other", "a longer label", 2.5, "", "eq 8");
  report.sections[0].add("word", "word", std::string("none"), "", "");
  EXPECT_EQ(reportTable(report),
            "name\n\nTitle\n"
            "  label           1   0    0\n"
            "                  0  22    0\n"
            "                  0   0  333 kg m^2  eq 7\n"
            "  a longer label  2.5                eq 8\n"
            "  word            none\n");
}

TEST(Report, PrintsTheRequestedNumberOfDigits) {
  const Report third = oneFact("key", 1.0 / 3, "rad");  // 60/pi degrees are 19.098593171027440
  EXPECT_THAT(reportTable(third, 1), HasSubstr("0.3 rad (2e+01 deg)"));
  EXPECT_THAT(reportTable(third), HasSubstr("0.333333 rad (19.0986 deg)"));
  EXPECT_THAT(reportTable(third, kAllDigits), HasSubstr("0.33333333333333331 rad (19.098593171027"));
}

TEST(Report, PrintsRoundingErrorsAsZero) {
  const Eigen::Vector3d vector(-0.0, 1.2e-17, -4.5);
  EXPECT_THAT(reportTable(oneFact("L_W", vector)), HasSubstr("(0, 0, -4.5)"));
  EXPECT_THAT(reportTable(oneFact("moments", vector)), HasSubstr("(0, 1.2e-17, -4.5)"));  // not rounded
  EXPECT_THAT(reportTable(oneFact("L_W", Eigen::Vector3d(0, 1e-14, -4.5))),
              HasSubstr("1e-14"));  // larger than rounding
  EXPECT_THAT(reportTable(oneFact("orientation", std::vector<double>{0.6, 0.8, 0, 3e-19})),
              HasSubstr("(0.6, 0.8, 0, 0)"));
  EXPECT_THAT(reportTable(oneFact("x", -0.0)), Not(HasSubstr("-0")));
  Eigen::Matrix3d tensor = Eigen::Vector3d(1, 2, 3).asDiagonal();
  tensor(0, 1) = 4e-17;
  EXPECT_THAT(reportTable(oneFact("inertia_tensor_B", tensor)), Not(HasSubstr("e-17")));
}

TEST(Report, JsonKeepsEveryDigit) {
  const json said = json::parse(reportJson(oneFact("L_W", Eigen::Vector3d(-0.0, 1.2e-17, 1.0 / 3), "kg")));
  EXPECT_EQ(said["scene"], "name");
  EXPECT_EQ(said["L_W"][1].get<double>(), 1.2e-17);
  EXPECT_EQ(said["L_W"][2].get<double>(), 1.0 / 3);
  EXPECT_EQ(said["L_W"].dump().find('-'), said["L_W"].dump().find("-17"));  // -0 is written without a sign
  EXPECT_EQ(said["units"]["L_W"], "kg");
  EXPECT_EQ(said["from"]["L_W"], "eq 7");
  EXPECT_TRUE(json::parse(reportJson(oneFact("x", INFINITY)))["x"].is_null());
}

TEST(Report, ReportsFlipsOnlyNearTheMiddleAxis) {
  const auto flips = [](const std::string& moments, const std::string& omega) {
    return json::parse(reportJson(reportOf(start(moments, omega))));
  };
  // L = I omega leans from the middle axis by atan(2.5 0.1/2) at the start, where its third component is 0.
  const json racket = flips("[1, 2, 2.5]", "[0, 1, 0.1]");
  EXPECT_EQ(racket["body_flips"], true);
  EXPECT_NEAR(racket["least_angle_to_middle"].get<double>(), std::atan(2.5 * 0.1 / 2), 2e-16);
  EXPECT_NEAR(racket["largest_tilt"].get<double>(), std::atan(2 / (2.5 * 0.1)), 4e-16);
  EXPECT_EQ(flips("[1, 2, 2.5]", "[0, 0.1, 1]")["body_flips"], false);
  EXPECT_EQ(flips("[2, 2, 2.5]", "[0, 1, 0.1]")["body_flips"], false);  // symmetric: no middle axis
  const std::string words = reportTable(reportOf(start("[1, 2, 2.5]", "[0, 0.1, 1]")));
  EXPECT_THAT(words, Not(HasSubstr("from flip to flip")));
  EXPECT_THAT(words, ContainsRegex("half a period, 2K/lambda"));
}

// Worked by hand: I1 = 2, I3 = 1, omega = (0.5, 0, 1), so L = (1, 0, 1) and tan theta = 1.
TEST(Report, ComparesTheWobbleOfASymmetricTopWithItsSpin) {
  const json top = json::parse(reportJson(reportOf(start("[2, 2, 1]", "[0.5, 0, 1]"))));
  EXPECT_NEAR(top["omega_1"].get<double>(), 0.5, 1e-15);
  EXPECT_NEAR(top["precession_period"].get<double>(), 2 * std::numbers::pi / std::sqrt(0.5), 1e-14);
  EXPECT_NEAR(top["wobbles_per_turn"].get<double>(), std::sqrt(0.5), 1e-15);
  EXPECT_FALSE(top.contains("pole_distance"));  // the size is unknown
  // A disc wobbles twice a turn (Feynman's plate): I3 = 2 I1, at a small tilt.
  const json plate = json::parse(reportJson(reportOf(start("[1, 1, 2]", "[1e-4, 0, 1]"))));
  EXPECT_NEAR(plate["wobbles_per_turn"].get<double>(), 2, 1e-8);
}

// A radius of 6 356 752 m and an angle of 0.3 arcsec give 9.2 m.
TEST(Report, MeasuresThePoleDistanceInMetres) {
  const double arcsec = std::numbers::pi / 648000;
  const std::string text =
      fmt::format("[body]\ncatalogue = \"earth\"\n[motion]\nomega_body = [{:.17g}, 0, 7.292115e-5]\n",
                  7.292115e-5 * 0.3 * arcsec);
  const Report report = reportOf(text);
  EXPECT_NEAR(json::parse(reportJson(report))["pole_distance"].get<double>(), 6356752 * 0.3 * arcsec, 1e-3);
  EXPECT_THAT(reportTable(report), ContainsRegex("\\(omega, k\\) +1.45444e-06 rad \\(0.3 arcsec\\)"));
}

// Periods of the asteroid Apophis (P. Pravec et al., Icarus 233 (2014) 48, in the refined values of the issue).
TEST(Report, PrintsThePeriodsOfATumblingBody) {
  const std::string text =
      "[body]\nprincipal_moments = [0.61, 0.965, 1]\n[motion]\nP_phi = \"27.385 h\"\nP_psi = \"264.178 h\"\n"
      "mode = \"SAM\"\n";
  const json apophis = json::parse(reportJson(reportOf(text)));
  EXPECT_NEAR(apophis["P_phi"].get<double>() / 3600, 27.385, 1e-4);  // 0 off
  EXPECT_NEAR(apophis["P_psi"].get<double>() / 3600, 264.178, 1e-4);
  EXPECT_EQ(apophis["tumbling_mode"], "SAM");
}

// Worked by hand: I = (1, 2, 2.5), omega = (0, 1, 0.1), L² = 4.0625, the two extremes of the polhode have omega_2
// = 0 or omega_3 and omega_1 as they follow from T and L.
TEST(Report, BoundsTheEnergyAndOmega) {
  const json racket = json::parse(reportJson(reportOf(start("[1, 2, 2.5]", "[0, 1, 0.1]"))));
  const double square = 4 + 0.25 * 0.25, twoT = 2 + 2.5 * 0.01;
  EXPECT_NEAR(racket["T_bounds"][0].get<double>(), square / 5, 1e-15);
  EXPECT_NEAR(racket["T_bounds"][1].get<double>(), square / 2, 1e-15);
  const double third = (square - twoT) / (2.5 * 1.5),
               first = twoT - 2.5 * third;  // omega_3², omega_1² where omega_2 = 0
  const double ends[] = {std::sqrt(1.01), std::sqrt(first + third)};
  EXPECT_NEAR(racket["omega_range"][0].get<double>(), std::min(ends[0], ends[1]), 1e-14);
  EXPECT_NEAR(racket["omega_range"][1].get<double>(), std::max(ends[0], ends[1]), 1e-14);
  EXPECT_NEAR(racket["omega_L_range"][1].get<double>(),
              std::acos(twoT / std::sqrt(square) / std::max(ends[0], ends[1])), 1e-13);
}

// Worked by hand, with I1 = 2, I3 = 1, M g l = 3, k = z leaning 60 degrees, spin 5: the constants of a top
// released at rest.
TEST(Report, PrintsTheConstantsOfAHeavyTop) {
  const json top = json::parse(reportJson(
      reportOf("[body]\nprincipal_moments = [2, 2, 1]\n[motion]\nspin = 5\nspin_axis = \"3\"\nlean = \"60 deg\"\n"
               "[motion.gravity]\nmgr_body = [0, 0, 3]\n")));
  EXPECT_NEAR(top["top_energy"].get<double>(), 12.5 + 1.5, 1e-12);
  EXPECT_NEAR(top["top_L_z"].get<double>(), 2.5, 1e-12);
  EXPECT_NEAR(top["top_L_3"].get<double>(), 5, 1e-12);
  EXPECT_NEAR(top["top_reduced_energy"].get<double>(), 1.5, 1e-12);
}

TEST(Report, SaysHowALossOfEnergyEnds) {
  const auto losing = [](const std::string& duration) {
    return json::parse(
        reportJson(reportOf("[body]\nprincipal_moments = [1, 2, 2.5]\n[motion]\nomega_body = [2, 0.1, 0.1]\n"
                            "[motion.dissipation]\nalpha = 0.01\n[time]\nspeed = 1\nduration = " +
                            duration)));
  };
  const json whole = losing("200");
  EXPECT_NEAR(whole["separatrix_times"][0].get<double>() / whole["separatrix_time"].get<double>(), 1, 0.05);
  EXPECT_THAT(whole["final_direction"].get<std::string>(), ::testing::AnyOf("+e3", "-e3"));
  EXPECT_EQ(losing("1")["final_direction"], "not decided before the film ends");
}

TEST(Report, StatesThatStabilityAssumesFreeMotion) {
  const std::string free = start("[1, 2, 2.5]", "[0, 1, 0.1]");
  EXPECT_THAT(reportTable(reportOf(free)), Not(HasSubstr("if nothing acted")));
  EXPECT_THAT(reportTable(reportOf(free + "[motion.drag]\nrate = 0.1\n")),
              HasSubstr("if nothing acted on the body"));
}

TEST(Report, NamesTheSpinOfATopWhoseFilmRepeats) {
  const scene::Scene top =
      request::loadRequested(request::readSceneRequest(kSource + "/scenes/steady_top.toml", {}));
  const json said = json::parse(reportJson(sceneReport(top)));
  EXPECT_NEAR(said["loop_spin_before"].get<double>(), 50 * std::numbers::pi, 1e-12);  // 25 rev/s; 0 off
  EXPECT_NEAR(said["loop_spin"].get<double>(), 50 * std::numbers::pi, 1.5);           // 1 %
  EXPECT_THAT(loopText(top), HasSubstr("; spin from 157.08 to "));
}

std::string textOf(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void expectDocumented(const std::string& docs, const std::string& key, const std::string& where) {
  const std::regex numbered("^(axis|force)_[0-9]+");  // axis_1_rate stands for all three
  EXPECT_THAT(docs, HasSubstr("`" + std::regex_replace(key, numbered, "$1_1") + "`")) << where;
}

TEST(Report, KeysOfGalleryScenesAreDocumented) {
  const std::string docs = textOf(kSource + "/docs/reference_data.md");
  for (const auto& entry : std::filesystem::directory_iterator(kSource + "/scenes")) {
    if (entry.path().extension() != ".toml") continue;
    const Report report =
        sceneReport(request::loadRequested(request::readSceneRequest(entry.path().string(), {})));
    for (const Section& section : report.sections)
      for (const Fact& fact : section.facts) expectDocumented(docs, fact.key, entry.path());
  }
}

// Worked by hand. The first force acts 2 m from the centre of mass: r x F = (2, 0, 0) x (0, 0, 3) = (0, -6, 0).
// The centre of mass is at R = (0, 5, 0), and R x F = (15, 0, 0).
TEST(Report, SumsTheForcesAtPoints) {
  const json facts = json::parse(
      reportJson(reportOf("[body]\nprincipal_moments = [1, 2, 2.5]\nmass = 4\ncentre_of_mass = [1, 0, "
                          "0]\n[motion]\nomega_body = [0, 0, 0]\n"
                          "[motion.flight]\nposition = [0, 5, 0]\ngravity = [0, 0, 0]\n[time]\nduration = 2\n"
                          "[[motion.force]]\nat = [3, 0, 0]\nspace = [0, 0, 3]\n"
                          "[[motion.force]]\nat = [1, 1, 0]\nbody = [7, 0, 0]\nfrom = 1.5\n")));
  EXPECT_EQ(facts.at("force_1_point_B"), json::parse("[3, 0, 0]"));
  EXPECT_EQ(facts.at("force_1_W"), json::parse("[0, 0, 3]"));
  EXPECT_EQ(facts.at("force_2_B"), json::parse("[7, 0, 0]"));
  EXPECT_EQ(facts.at("force_1_torque_W"), json::parse("[0, -6, 0]"));
  EXPECT_EQ(facts.at("force_2_torque_B"), json::parse("[0, 0, -7]"));
  EXPECT_EQ(facts.at("force_2_from"), 1.5);
  EXPECT_FALSE(facts.contains("force_1_from") || facts.contains("force_2_to"));
  EXPECT_EQ(facts.at("forces_W"), json::parse("[0, 0, 3]"));
  EXPECT_EQ(facts.at("forces_torque_W"), json::parse("[0, -6, 0]"));
  EXPECT_EQ(facts.at("forces_torque_about_origin_W"), json::parse("[15, -6, 0]"));
  EXPECT_EQ(facts.at("force_W"), json::parse("[0, 0, 3]"));
  EXPECT_EQ(facts.at("torque_about_origin_W"), json::parse("[15, -6, 0]"));
  EXPECT_EQ(facts.at("from").at("forces_torque_W"), "eq 9");
  // Neither the energy nor the highest point of a parabola exists under such forces.
  EXPECT_FALSE(facts.contains("energy_drift") || facts.contains("rise_time") || facts.contains("plane_height"));
  EXPECT_FALSE(facts.contains("forces_at_start_W"));
}

// At the film's start, 2 s, only the second force acts.
TEST(Report, SumsTheForcesAtTheStartOfTheFilm) {
  const json facts = json::parse(reportJson(reportOf(
      "[body]\nprincipal_moments = [1, 1, 2]\n[motion]\nomega_body = [0, 0, 0]\n[time]\nstart = 2\nduration = 1\n"
      "[[motion.force]]\nat = [1, 0, 0]\nspace = [1, 0, 0]\nto = 1\n"
      "[[motion.force]]\nat = [0, 2, 0]\nspace = [0, 0, 3]\nfrom = 2\n")));
  EXPECT_EQ(facts.at("forces_W"), json::parse("[1, 0, 0]"));
  EXPECT_EQ(facts.at("forces_torque_W"), json::parse("[0, 0, 0]"));
  EXPECT_EQ(facts.at("forces_at_start_W"), json::parse("[0, 0, 3]"));
  EXPECT_EQ(facts.at("forces_torque_at_start_W"), json::parse("[6, 0, 0]"));
}

// The sources spell out all keys, also keys that no gallery scene has, such as the keys of a film that repeats.
TEST(Report, KeysOfAllSectionsAreDocumented) {
  const std::string docs = textOf(kSource + "/docs/reference_data.md");
  const std::regex added(R"re(add\("([A-Za-z0-9_]+)",)re");  // complete keys only
  int keys = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kSource + "/src/describe")) {
    if (!entry.path().filename().string().starts_with("report_")) continue;
    const std::string source = textOf(entry.path());
    for (std::sregex_iterator found(source.begin(), source.end(), added), end; found != end; ++found, ++keys)
      expectDocumented(docs, (*found)[1], entry.path());
  }
  EXPECT_GT(keys, 70);  // guards against a pattern that finds nothing
}

}  // namespace
}  // namespace poinsot::describe
