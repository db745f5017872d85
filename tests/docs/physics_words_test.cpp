// SPDX-License-Identifier: Apache-2.0
// Sentences about physics in scenes, catalogue and pages agree with the physics. Expected numbers come from hand
// formulas and from the numbers in the scenes.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "describe/report.h"
#include "docs/pages.h"
#include "physics/catalogue.h"
#include "physics/heavy_top.h"
#include "request/scene_request.h"
#include "scene/motion/make_motion.h"

namespace poinsot {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const std::filesystem::path kRoot = POINSOT_SOURCE_DIR;

std::filesystem::path pathOf(const std::string& name) { return kRoot / "scenes" / (name + ".toml"); }
std::string textOfScene(const std::string& name) { return textOf(pathOf(name)); }

scene::Scene sceneOf(const std::string& name) {
  return request::loadRequested(request::readSceneRequest(pathOf(name).string(), {}));
}

physics::HeavyTop topOf(const scene::Scene& scene) {
  const auto& axes = scene.body.axes;
  return physics::heavyTop(axes.moments(), axes.toP(scene.motion.forcing.gravity_B)).value();
}

std::string rowOf(const std::string& markdown, const std::string& beginning) {
  const auto from = markdown.find("\n| " + beginning);
  return from == std::string::npos ? "" : markdown.substr(from + 1, markdown.find('\n', from + 1) - from - 1);
}

// 2 pi/Omega_p in turns of the body is I1/(I3 - I1) (eq 29); with H = (C - A)/C that is (1 - H)/H.
TEST(PhysicsWords, GiveEachRigidEarthItsPeriod) {
  const Eigen::Vector3d I = sceneOf("chandler_wobble").body.axes.moments().values();
  const double ofScenes = I[0] / (I[2] - I[0]), H = 0.003273795;
  EXPECT_NEAR(ofScenes, (1 - H) / H, 1e-9);
  EXPECT_THAT(textOfScene("chandler_wobble"), HasSubstr(fmt::format("once in {:.2f} sidereal", ofScenes)));
  const std::string page = textOf(kRoot / "docs/physics.md");
  EXPECT_THAT(rowOf(page, "rigid, the lecture's ratio"), HasSubstr(fmt::format("| {:.2f} |", 1 / 0.0033)));
  EXPECT_THAT(rowOf(page, "rigid, I⊥ = A"), HasSubstr(fmt::format("| {:.2f} |", 8.0101 / (8.0365 - 8.0101))));
  EXPECT_THAT(rowOf(page, "rigid, `catalogue = \"earth\"`"), HasSubstr(fmt::format("| {:.2f} |", ofScenes)));
}

// Worked by hand in tests/physics/earth_test.cpp: 446.09 and 395.33 sidereal days. Solar days are longer by
// 86400/86164.0905.
TEST(PhysicsWords, GiveTheDeformableEarthItsPeriods) {
  const std::string page = textOf(kRoot / "docs/physics.md");
  const auto row = [](double sidereal) {
    return fmt::format("| {:.2f} | {:.2f} |", sidereal, sidereal * 86164.0905 / 86400);
  };
  EXPECT_THAT(rowOf(page, "elastic |"), HasSubstr(row(446.0914)));
  EXPECT_THAT(rowOf(page, "elastic, with a fluid core"), HasSubstr(row(395.3323)));
  EXPECT_THAT(rowOf(page, "observed |"), HasSubstr("| 434.19 | 433.0 ± 1.1 |"));
  EXPECT_NEAR(433.0 * 86400 / 86164.0905, 434.19, 5e-3);
}

// tan beta = omega_1/omega_3, tan theta = (A/C) tan beta, times half the polar axis.
TEST(PhysicsWords, GiveTheDistancesAtThePole) {
  const double beta = 1.145e-10 / 7.292115e-5, pole_m = 6378136.6 * (1 - 1 / 298.25642), H = 0.003273795;
  EXPECT_NEAR(beta * pole_m, 10, 0.05);
  EXPECT_NEAR(beta * H * pole_m, 0.033, 5e-4);
  for (const char* scene : {"chandler_wobble", "chandler_true"})
    EXPECT_THAT(textOfScene(scene), AllOf(HasSubstr(": 10 m'"), HasSubstr(": 3.3 cm'"))) << scene;
}

// Smith & Dahlen (1981): the fluid core shortens the period, and elasticity and oceans lengthen it. The Earth
// yields to its own centrifugal force.
TEST(PhysicsWords, NameTheCausesOfTheChandlerPeriod) {
  EXPECT_THAT(physics::findCatalogueBody("earth")->source,
              AllOf(HasSubstr("fluid core shortens"), HasSubstr("Smith & Dahlen"), HasSubstr("304.46")));
  EXPECT_THAT(textOfScene("chandler_wobble"), AllOf(HasSubstr("centrifugal force"), Not(HasSubstr("tides"))));
}

// The top is released at rest, except for its spin. The tip of its axis then has no speed at its highest point,
// which is a cusp and not a loop.
TEST(PhysicsWords, DescribeCuspsForATopReleasedAtRest) {
  const scene::Scene scene = sceneOf("heavy_top");
  const physics::HeavyTop top = topOf(scene);
  const auto motion = scene::makeMotion(scene, 0, 1);
  const auto tipSpeed = [&](double t_s) {
    const physics::RigidBodyState s = motion->at(t_s);
    const Eigen::Vector3d k_W = s.q_WB * scene.body.axes.toB(top.k_P);
    return s.omega_W.cross(k_W).norm();
  };
  const auto& axes = scene.body.axes;
  const Eigen::Vector3d up_P = axes.toP(scene::startOrientation(scene).conjugate() * Eigen::Vector3d::UnitZ());
  const double nod_s = top.nutation(axes.toP(scene.motion.omega_B), up_P).period_s;
  EXPECT_LE(tipSpeed(0) / tipSpeed(nod_s / 2), 1e-14);      // measured 1.4e-15
  EXPECT_LE(tipSpeed(nod_s) / tipSpeed(nod_s / 2), 2e-13);  // measured 2.5e-14
  EXPECT_THAT(textOfScene("heavy_top"), AllOf(HasSubstr("cusps"), Not(HasSubstr("loops"))));
}

// The top wakes where L3² theta²/(8 I1) = M g l theta²/2, that is, at omega_3 = 2 sqrt(I1 M g l)/I3.
TEST(PhysicsWords, GiveTheSpinAtWhichASleepingTopWakes) {
  const physics::HeavyTop top = topOf(sceneOf("sleeping_top"));
  const double spin = 2 * std::sqrt(top.across * top.weight) / top.along;
  EXPECT_THAT(
      textOfScene("sleeping_top"),
      AllOf(HasSubstr("energy"), HasSubstr(fmt::format("{:.1f} turns a second", spin / (2 * std::numbers::pi)))));
}

}  // namespace
}  // namespace poinsot
