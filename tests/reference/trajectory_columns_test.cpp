// SPDX-License-Identifier: Apache-2.0
// Compares named columns of a trajectory with closed formulas: symmetric top, torque-free motion, flight.
#include "reference/trajectory_columns.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/error.h"
#include "reference/trajectory.h"
#include "scene/motion/make_motion.h"
#include "scene/scene_file.h"

namespace poinsot::reference {
namespace {

using Eigen::Vector3d;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kPi = std::numbers::pi;

std::string sceneText(const std::string& moments, const std::string& omega, const std::string& more = "") {
  return "[body]\nprincipal_moments = " + moments + "\n[motion]\nomega_body = " + omega + "\n" + more;
}

scene::Scene sceneOf(const std::string& text) { return scene::parseScene(text, "s.toml"); }

/// Values of named columns at one time.
std::map<std::string, double> valuesAt(const scene::Scene& scene, double t_s,
                                       const std::vector<std::string>& names) {
  const ChosenColumns chosen(scene, names, "--quantities");
  const auto motion = scene::makeMotion(scene, std::min(0.0, t_s), std::max(0.0, t_s));
  std::vector<double> values;
  chosen.evaluate(*motion, motion->at(t_s), values);
  EXPECT_EQ(values.size(), chosen.columns().size());
  std::map<std::string, double> named;
  for (std::size_t i = 0; i < values.size(); ++i) named[std::string(chosen.columns()[i].name)] = values[i];
  return named;
}

/// Returns the difference of two angles, between -pi and pi.
double turned(double from, double to) { return std::remainder(to - from, 2 * kPi); }

// Free symmetric top (eq 19 to 37): theta is constant, tan theta = I1 w_perp/(I3 w_3). phi grows by L/I1 a second,
// psi by (1 - I3/I1) w_3. The angle between omega and L follows from the two cones.
TEST(ChosenColumns, MatchTheFormulasOfAFreeSymmetricTop) {
  const double I1 = 2, I3 = 3, w1 = 0.4, w3 = 5;
  const scene::Scene scene = sceneOf(sceneText("[2, 2, 3]", "[0.4, 0, 5]"));
  const std::vector<std::string> names{"theta",       "phi", "psi", "phi_rate", "psi_rate",
                                       "theta_omega", "E",   "T",   "V"};
  const double L = std::hypot(I1 * w1, I3 * w3), theta = std::atan2(I1 * w1, I3 * w3);
  const double energy = 0.5 * (I1 * w1 * w1 + I3 * w3 * w3), psiRate = (1 - I3 / I1) * w3;
  const auto start = valuesAt(scene, 0, names);
  for (const double t_s : {0.0, 0.3, -1.7, 40.0, 1000.0}) {
    const auto now = valuesAt(scene, t_s, names);
    EXPECT_EQ(now.at("t"), t_s);
    EXPECT_NEAR(now.at("theta"), theta, 1e-15) << t_s;  // measured: at most 2e-16
    EXPECT_NEAR(now.at("theta_omega"), std::atan2(w1, w3) - theta, 1e-14);
    EXPECT_NEAR(turned(start.at("phi") + L / I1 * t_s, now.at("phi")), 0, 1e-11) << t_s;
    EXPECT_NEAR(turned(start.at("psi") + psiRate * t_s, now.at("psi")), 0, 1e-11) << t_s;
    EXPECT_NEAR(now.at("phi_rate"), L / I1, 1e-11);  // measured 1.1e-12: rounding, divided by sin^2 theta = 0.003
    EXPECT_NEAR(now.at("psi_rate"), psiRate, 1e-11);
    EXPECT_NEAR(now.at("E"), energy, 1e-13);
    EXPECT_EQ(now.at("E"), now.at("T"));
    EXPECT_EQ(now.at("V"), 0);
  }
}

// A free body keeps L and T. The rest follows from them and from the columns without a choice.
TEST(ChosenColumns, AgreeWithTheUsualColumnsOfAFreeBody) {
  const scene::Scene scene = sceneOf(sceneText("[1, 2, 2.5]", "[0.1, 3, 0.2]"));
  for (const double t_s : {-2.0, 0.0, 0.7, 30.0}) {
    const auto row = valuesAt(
        scene, t_s, {"omega_B_x", "omega_B_y", "omega_B_z", "omega_W_x", "omega_W_y", "omega_W_z", "L_W_x",
                     "L_W_y",     "L_W_z",     "omega_1",   "omega_2",   "omega_3",   "omega_x",   "omega_y",
                     "omega_z",   "omega",     "L_1",       "L_2",       "L_3",       "L_x",       "L_y",
                     "L_z",       "L",         "T",         "E",         "h",         "rho",       "q_w"});
    const Vector3d omega_B(row.at("omega_B_x"), row.at("omega_B_y"), row.at("omega_B_z"));
    const Vector3d L_W(row.at("L_W_x"), row.at("L_W_y"), row.at("L_W_z"));
    const Vector3d moments(1, 2, 2.5), L_B = moments.cwiseProduct(omega_B);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(row.at(fmt::format("omega_{}", i + 1)), omega_B[i], 1e-15);
      EXPECT_NEAR(row.at(fmt::format("L_{}", i + 1)), L_B[i], 1e-15);
      const char axis = "xyz"[i];
      EXPECT_EQ(row.at(fmt::format("omega_{}", axis)), row.at(fmt::format("omega_W_{}", axis)));
      EXPECT_EQ(row.at(fmt::format("L_{}", axis)), L_W[i]);
    }
    const double T = 0.5 * (1 * 0.01 + 2 * 9 + 2.5 * 0.04), L = std::hypot(0.1, 6.0, 0.5);
    EXPECT_NEAR(row.at("omega"), omega_B.norm(), 1e-15);
    EXPECT_NEAR(row.at("L"), L, 1e-14);
    EXPECT_NEAR(row.at("T"), T, 1e-14);
    EXPECT_EQ(row.at("E"), row.at("T"));
    EXPECT_NEAR(row.at("h"), 2 * T / L, 1e-14);  // eq 40
    EXPECT_NEAR(row.at("rho"), std::sqrt(omega_B.squaredNorm() - row.at("h") * row.at("h")), 1e-13);
  }
}

// Heavy top: E = T + M g l cos(theta) is constant, with the angle to the vertical.
TEST(ChosenColumns, MatchTheEnergyOfAHeavyTop) {
  const scene::Scene scene = sceneOf(sceneText(
      "[1, 1, 0.4]", "[0.2, 0, 30]",
      "orientation = [0.984807753012208, 0.17364817766693, 0, 0]\n[motion.gravity]\nmgr_body = [0, 0, 2]\n"));
  const auto start = valuesAt(scene, 0, {"E"});
  for (const double t_s : {0.0, 0.4, 1.3}) {
    const auto row = valuesAt(scene, t_s, {"E", "T", "V", "theta_vertical"});
    EXPECT_NEAR(row.at("V"), 2 * std::cos(row.at("theta_vertical")), 1e-12);
    EXPECT_NEAR(row.at("E"), row.at("T") + row.at("V"), 1e-12);
    EXPECT_NEAR(row.at("E"), start.at("E"), 1e-9);
  }
}

const std::string kThrown =
    "[body]\nprincipal_moments = [1, 2, 2.5]\nmass = 3\n[motion]\nomega_body = [0.1, 3, 0.2]\n"
    "[motion.flight]\nposition = [1, 2, 3]\nvelocity = [4, -5, 6]\n";

// Parabola: R = R0 + V0 t + g t^2/2, V = V0 + g t, with 9.80665 m/s^2 downwards (eq 1 to 10).
TEST(ChosenColumns, MatchTheParabolaOfAFlight) {
  const scene::Scene scene = sceneOf(kThrown);
  std::vector<std::string> names{"T_cm", "T_total", "T", "E", "V"};
  for (const char* vector : {"R", "V", "P", "L_orbital", "L_total", "L"})
    for (const char axis : {'x', 'y', 'z'}) names.push_back(fmt::format("{}_{}", vector, axis));
  for (const double t_s : {-1.0, 0.0, 0.8, 25.0}) {
    const auto row = valuesAt(scene, t_s, names);
    const auto vector = [&row](const std::string& name) {
      return Vector3d(row.at(name + "_x"), row.at(name + "_y"), row.at(name + "_z"));
    };
    const double m = 3;
    const Vector3d g(0, 0, -9.80665), V = Vector3d(4, -5, 6) + g * t_s;
    const Vector3d R = Vector3d(1, 2, 3) + Vector3d(4, -5, 6) * t_s + 0.5 * g * t_s * t_s;
    const double scale = 1 + R.norm() + V.norm();
    EXPECT_LT((vector("R") - R).norm(), 1e-14 * scale);
    EXPECT_LT((vector("V") - V).norm(), 1e-14 * scale);
    EXPECT_LT((vector("P") - m * V).norm(), 1e-14 * m * scale);
    EXPECT_LT((vector("L_orbital") - R.cross(m * V)).norm(), 1e-14 * m * scale * scale);
    EXPECT_LT((vector("L_total") - R.cross(m * V) - vector("L")).norm(), 1e-14 * m * scale * scale);
    EXPECT_NEAR(row.at("T_cm"), 0.5 * m * V.squaredNorm(), 1e-14 * m * scale * scale);
    EXPECT_NEAR(row.at("T_total"), row.at("T_cm") + row.at("T"), 1e-14 * m * scale * scale);
    EXPECT_NEAR(row.at("V"), m * 9.80665 * R.z(), 1e-14 * m * 10 * scale);
    EXPECT_NEAR(row.at("E"), row.at("T_total") + row.at("V"), 1e-14 * m * 10 * scale * scale);
  }
}

// A force of (0, 6, 0) N at the centre of mass of 3 kg from 1 s to 3 s: V_y grows by 2 m/s² while it acts.
TEST(ChosenColumns, FollowTheForcesOnAThrownBody) {
  const scene::Scene scene =
      sceneOf(kThrown + "[[motion.force]]\nat = [0, 0, 0]\nspace = [0, 6, 0]\nfrom = 1\nto = 3\n");
  ChosenColumns chosen(scene, {"V_y", "R_y", "P_y"}, "--quantities");
  const auto motion = scene::makeMotion(scene, -1, 6);
  chosen.follow(*motion);
  for (const double t_s : {-1.0, 0.5, 2.0, 5.0}) {
    const double in = std::clamp(t_s - 1, 0.0, 2.0), after = std::max(t_s - 3, 0.0);
    std::vector<double> row;
    chosen.evaluate(*motion, motion->at(t_s), row);
    EXPECT_NEAR(row.at(1), -5 + 2 * in, 1e-14);
    EXPECT_NEAR(row.at(2), 2 - 5 * t_s + in * in + 2 * in * after, 1e-13);
    EXPECT_NEAR(row.at(3), 3 * (-5 + 2 * in), 1e-13);
  }
}

// A symmetric body that is thrown by a point has every quantity.
TEST(ChosenColumns, HaveEveryQuantityOfPlots) {
  const scene::Scene scene = sceneOf(
      "[body]\nshape = 'cylinder'\nradius = 1\nheight = 3\nmass = 3\n[motion]\nomega_body = [0.1, 3, 0.2]\n"
      "[motion.flight]\npoint = [0, 1, 0]\nvelocity = [4, -5, 6]\n");
  for (const scene::StateQuantity& quantity : scene::stateQuantities()) {
    const ChosenColumns chosen(scene, {std::string(quantity.name)}, "--quantities");
    const bool time = quantity.name == "t";
    EXPECT_EQ(chosen.header(), time ? "t" : "t," + std::string(quantity.name));
    EXPECT_FALSE(chosen.columns().back().unit.empty()) << quantity.name;
  }
  const ChosenColumns some(scene, {"P_x", "phi", "L_total_z", "q_w", "E", "R_y", "V_x"}, "--quantities");
  const char* const units[] = {"s", "kg m/s", "rad", "kg m^2/s", "1", "J", "m", "m/s"};
  for (std::size_t i = 0; i < std::size(units); ++i) EXPECT_EQ(some.columns()[i].unit, units[i]);
}

// The body spins about k itself, so that there is no line of nodes.
TEST(ChosenColumns, WriteValuesThatDoNotExistAsNanAndNull) {
  const scene::Scene scene = sceneOf(sceneText("[2, 2, 3]", "[0, 0, 5]"));
  const ChosenColumns chosen(scene, {"phi", "theta"}, "--quantities");
  const auto text = [&](TrajectoryFormat format) {
    std::string all;
    writeTrajectory(*scene::makeMotion(scene, 0, 1), chosen, TrajectoryTimes({0}), format, "s",
                    [&](std::string_view piece) { all += piece; });
    return all;
  };
  EXPECT_EQ(text(TrajectoryFormat::kCsv), "t,phi,theta\n0,nan,0\n");
  const auto json = nlohmann::json::parse(text(TrajectoryFormat::kJson));
  EXPECT_EQ(json.at("rows").dump(), "[[0,null,0]]");
  EXPECT_EQ(json.at("columns").dump(), R"(["t","phi","theta"])");
  EXPECT_EQ(json.at("units").dump(), R"({"phi":"rad","t":"s","theta":"rad"})");
}

std::string refusedWith(const scene::Scene& scene, const std::vector<std::string>& names) {
  try {
    const ChosenColumns chosen(scene, names, "--quantities");
  } catch (const core::Error& error) {
    EXPECT_EQ(error.kind(), core::ErrorKind::kUsage);
    return error.message();
  }
  return "";
}

TEST(ChosenColumns, RejectUnknownRepeatedAndImpossibleNames) {
  const scene::Scene free = sceneOf(sceneText("[1, 2, 2.5]", "[0.1, 3, 0.2]"));
  EXPECT_THAT(refusedWith(free, {"tetha"}),
              HasSubstr("--quantities: no quantity has the name 'tetha'; did you mean theta? The names are t, "));
  EXPECT_THAT(refusedWith(free, {"tetha"}), HasSubstr(", T_total, "));
  EXPECT_THAT(refusedWith(free, {"omega_B"}), HasSubstr("did you mean"));
  EXPECT_THAT(refusedWith(free, {"zzzzzzzz"}), Not(HasSubstr("did you mean")));
  EXPECT_THAT(refusedWith(free, {"theta", ""}), HasSubstr("no quantity has the name ''"));
  EXPECT_THAT(refusedWith(free, {"theta", "phi", "theta"}), HasSubstr("theta is given twice"));
  EXPECT_THAT(refusedWith(free, {"R_x"}), HasSubstr("R_x exists only for a thrown body; give [motion.flight]"));
  const scene::Scene noMass =
      sceneOf(sceneText("[1, 2, 2.5]", "[0.1, 3, 0.2]", "[motion.flight]\nvelocity = [1, 0, 1]\n"));
  EXPECT_EQ(refusedWith(noMass, {"R_x", "V_z"}), "");
  EXPECT_THAT(refusedWith(noMass, {"P_x"}), HasSubstr("P_x needs a body with a mass"));
  EXPECT_THAT(refusedWith(noMass, {"L_K_mixed_1_x"}), HasSubstr("thrown by a point; give motion.flight.point"));
  EXPECT_THAT(
      refusedWith(sceneOf(sceneText("[2, 2, 1]", "[0.1, 3, 0.2]", "[motion.drag]\nrate = 0.1\n")), {"Omega_p"}),
      HasSubstr("Omega_p exists only for a body on which nothing acts"));
  EXPECT_THAT(refusedWith(free, {"Omega_p"}),
              HasSubstr("Omega_p exists only for a symmetric body; give two equal"));
}

TEST(NamesIn, SplitAtCommasAndDropBlanks) {
  EXPECT_EQ(namesIn("theta, phi ,E"), (std::vector<std::string>{"theta", "phi", "E"}));
  EXPECT_EQ(namesIn("theta,"), (std::vector<std::string>{"theta", ""}));
}

}  // namespace
}  // namespace poinsot::reference
