// SPDX-License-Identifier: Apache-2.0
#include "reference/grade.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "physics/driven_motion.h"
#include "physics/free_motion.h"
#include "reference/grade_engines.h"
#include "reference/grade_text.h"
#include "reference/trajectory.h"

namespace poinsot::reference {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const Vector3d kMoments{2, 3, 4};
const EngineState kStart{Quaterniond(1, 0, 0, 0), Vector3d(.5, .25, 1)};

physics::FreeMotion truth() { return {physics::PrincipalMoments(kMoments), kStart.omega_B, kStart.q_WB}; }

TrajectoryTable table(const std::string& csv) { return parseTrajectoryTable(csv, "theirs.csv"); }

Grade gradeOf(const std::string& csv) { return grade(truth(), table(csv)); }

const ErrorSummary& errorsOf(const Grade& grade, std::string_view key) { return *grade.quantity(key).errors; }

std::string copy(const TrajectoryTimes& times) {
  std::string csv;
  writeTrajectory(truth(), ChosenColumns(0), times, TrajectoryFormat::kCsv, "s", [&](std::string_view text) { csv += text; });
  return csv;
}

TEST(Grade, FindsOnlyRoundingInACopy) {
  const Grade grade = gradeOf(copy(TrajectoryTimes({100, 1}, -2, 12)));
  EXPECT_EQ(grade.rows, 1201u);
  for (const GradedQuantity& quantity : grade.quantities) {
    ASSERT_TRUE(quantity.errors) << quantity.key;
    EXPECT_LE(quantity.errors->largest, 1e-15)
        << quantity.key;  // measured 2.2e-16: the log's quaternion is normalised
    EXPECT_EQ(quantity.errors->drift.kind, DriftKind::kRounding);
  }
  EXPECT_THAT(grade.notes, IsEmpty());
}

TEST(Grade, FindsTheEnergyGainOfExplicitEuler) {
  const Grade grade = gradeOf(engineCsv(explicitEuler, kMoments, kStart, 1e-3, 10000, 10));
  for (const char* key : {"T", "length_of_L", "omega_B", "attitude"}) {
    const ErrorSummary& errors = errorsOf(grade, key);
    EXPECT_EQ(errors.drift.kind, DriftKind::kDrift) << key;
    EXPECT_EQ(errors.drift.from_s, 0) << key;
    EXPECT_NEAR(errors.drift.order, 1, 0.25) << key;
    EXPECT_EQ(errors.largestAt_s, 10) << key;
  }
  // dT/dt = (h/2) sum I_i (domega_i/dt)^2 to first order in h, summed here along the true motion. Terms in h^2 and
  // the sum leave 1 %; measured 0.16 %.
  double gained = 0;
  for (int k = 0; k < 10000; ++k) {
    const Vector3d w = truth().at((k + 0.5) * 1e-3).omega_B;
    const Vector3d rate = kMoments.cwiseProduct(w).cross(w).cwiseQuotient(kMoments);
    gained += 1e-6 / 2 * kMoments.dot(rate.cwiseProduct(rate));
  }
  EXPECT_NEAR(errorsOf(grade, "T").final * truth().kineticEnergy(), gained, 0.01 * gained);
  EXPECT_EQ(errorsOf(grade, "T").signedFinal, errorsOf(grade, "T").final);
  EXPECT_EQ(errorsOf(grade, "T").trend, Trend::kGains);
}

/// Returns a log of omega alone, with the true omega times `factor(t)`.
std::string scaledOmega(const std::function<double(double)>& factor) {
  std::string csv = "t,omega_B_x,omega_B_y,omega_B_z\n";
  for (int k = 0; k <= 60; ++k) {
    const Vector3d omega = factor(0.5 * k) * truth().at(0.5 * k).omega_B;
    csv += fmt::format("{},{},{},{}\n", 0.5 * k, omega[0], omega[1], omega[2]);
  }
  return csv;
}

TEST(Grade, ReportsWhetherEnergyIsLostOrGained) {
  // If omega falls to 0.97 in 30 s, |L| falls by 3 % and T by 1 - 0.97^2 = 5.91 %. If omega grows to 1.03, they
  // grow by 3 % and 6.09 %.
  const Grade loses = gradeOf(scaledOmega([](double t) { return 1 - 1e-3 * t; }));
  EXPECT_NEAR(*errorsOf(loses, "T").signedFinal, -0.0591, 1e-14);  // measured 1e-16
  EXPECT_NEAR(*errorsOf(loses, "length_of_L").signedFinal, -0.03, 1e-14);
  const Grade gains = gradeOf(scaledOmega([](double t) { return 1 + 1e-3 * t; }));
  EXPECT_NEAR(*errorsOf(gains, "T").signedFinal, 0.0609, 1e-14);
  EXPECT_NEAR(errorsOf(gains, "T").final, 0.0609, 1e-14);
  EXPECT_EQ(errorsOf(gains, "T").trend, Trend::kGains);
  EXPECT_FALSE(errorsOf(gains, "omega_B").signedFinal);  // the error is a length and has no sign
  EXPECT_THAT(gradeTable(loses), HasSubstr("T                   5.91e-02 rel          30  -5.91e-02   3.44e-02   "
                                           "from t = 0, linear (loses)\n"));
  EXPECT_THAT(gradeTable(loses), HasSubstr("|L| -3.0e-02 (loses), T -5.9e-02 (loses).\n"));
  EXPECT_THAT(gradeTable(gains), HasSubstr("+6.09e-02"));
  const auto json = nlohmann::json::parse(gradeJson(loses, "theirs.csv", "s")).at("quantities");
  EXPECT_NEAR(json.at("T").at("signed_final").get<double>(), -0.0591, 1e-14);
  EXPECT_NEAR(json.at("T").at("final").get<double>(), 0.0591, 1e-14);
  EXPECT_EQ(json.at("T").at("trend"), "loses");
  EXPECT_FALSE(json.at("omega_B").contains("signed_final"));
}

TEST(Grade, ReportsNoTrendForABoundedOscillationOfEnergy) {
  const Grade grade = gradeOf(scaledOmega([](double t) { return 1 + 1e-3 * std::sin(2 * t); }));
  EXPECT_EQ(errorsOf(grade, "T").trend, Trend::kNone);
  EXPECT_THAT(gradeTable(grade), Not(HasSubstr("loses")));
  EXPECT_TRUE(nlohmann::json::parse(gradeJson(grade, "a", "s")).at("quantities").at("T").at("trend").is_null());
}

TEST(Grade, ComparesEnergyWithThatOfTheDrivenMotion) {
  // Drag multiplies omega by e^(-0.2) in 10 s. A log without drag ends with 1 - e^(-0.4) of T(0) too much.
  physics::Forcing drag;
  drag.dragRate_P.setConstant(0.02);
  const physics::DrivenMotion motion(physics::PrincipalMoments(kMoments), kStart.omega_B, kStart.q_WB, drag,
                                     {0, 10});
  const Grade kept = grade(motion, table(engineCsv(rungeKutta, kMoments, kStart, 1e-2, 1000, 10)));
  EXPECT_NEAR(*errorsOf(kept, "T").signedFinal, 1 - std::exp(-0.4), 1e-9);  // measured 1.6e-13
  EXPECT_EQ(errorsOf(kept, "T").trend, Trend::kGains);
}

TEST(Grade, FindsLinearDriftOfSemiImplicitEuler) {
  const Grade grade = gradeOf(engineCsv(semiImplicitEuler, kMoments, kStart, 1e-4, 100000, 100));
  const Drift& drift = errorsOf(grade, "attitude").drift;
  EXPECT_EQ(drift.kind, DriftKind::kDrift);
  EXPECT_EQ(drift.from_s, 0);
  EXPECT_NEAR(drift.order, 1, 0.25);
}

TEST(Grade, ErrorsShrinkWithTheOrderOfTheEngine) {
  const auto final = [](const EngineStep& step, double h) {
    const Grade grade = gradeOf(engineCsv(step, kMoments, kStart, h, static_cast<int>(10 / h), 10));
    return errorsOf(grade, "attitude").final;
  };
  EXPECT_NEAR(std::log2(final(explicitEuler, 1e-3) / final(explicitEuler, 5e-4)), 1, 0.05);  // measured 1.00
  EXPECT_NEAR(std::log2(final(rungeKutta, 1. / 32) / final(rungeKutta, 1. / 64)), 4, 0.1);   // measured 4.0
}

/// Returns a log that turns too far about an axis of space from t = 5 s on, by 1e-3 (t - 5)^order rad.
std::string wrongFrom5(int order) {
  std::string csv = "t,q_w,q_x,q_y,q_z\n";
  for (int k = 0; k <= 1000; ++k) {
    const double t_s = k * 0.01, angle = t_s > 5 ? 1e-3 * std::pow(t_s - 5, order) : 0;
    const Quaterniond q = Quaterniond(Eigen::AngleAxisd(angle, Vector3d(1, 2, 2) / 3)) * truth().at(t_s).q_WB;
    csv += fmt::format("{},{},{},{},{}\n", t_s, q.w(), q.x(), q.y(), q.z());
  }
  return csv;
}

TEST(Grade, FindsWhenAndHowAnEngineDrifts) {
  for (const int order : {1, 2}) {
    const ErrorSummary errors = errorsOf(gradeOf(wrongFrom5(order)), "attitude");
    EXPECT_EQ(errors.drift.kind, DriftKind::kDrift);
    EXPECT_NEAR(errors.drift.from_s, 5, 0.0101);
    EXPECT_NEAR(errors.drift.order, order, 0.1);
    EXPECT_NEAR(errors.final, 1e-3 * std::pow(5, order), 1e-14);
    EXPECT_EQ(errors.largest, errors.final);
    // Mean square over 10 s, of which 5 s are wrong: (1e-3)^2 5^(2p+1)/(2p+1)/10; 1001 rows sum it to 0.2 %.
    EXPECT_NEAR(errors.rms, 1e-3 * std::sqrt(std::pow(5, 2 * order + 1) / (2 * order + 1) / 10),
                0.002 * errors.rms);
  }
}

TEST(Grade, AcceptsQuaternionsOfEitherSignAndAnyLength) {
  const auto s = truth().at(3);
  const Eigen::Vector4d q = -2.5 * s.q_WB.coeffs();
  const Grade grade = gradeOf(fmt::format("t,q_w,q_x,q_y,q_z\n3,{},{},{},{}\n", q[3], q[0], q[1], q[2]));
  EXPECT_LE(errorsOf(grade, "attitude").largest, 1e-15);
  EXPECT_THAT(grade.notes, ElementsAre(HasSubstr("differ from 1 by up to 1.5; they are graded as normalised")));
}

TEST(Grade, ReportsAQuaternionOfLengthZero) {
  const Grade grade = gradeOf("t,q_w,q_x,q_y,q_z\n0,1,0,0,0\n2,0,0,0,0\n");
  EXPECT_EQ(errorsOf(grade, "attitude").largest, INFINITY);
  EXPECT_THAT(grade.notes, ElementsAre(HasSubstr("1 of 2 rows")));
}

TEST(Grade, LeavesOutQuantitiesWithoutColumns) {
  const Grade onlyQ = gradeOf("t,q_w,q_x,q_y,q_z\n0,1,0,0,0\n");
  for (const char* key : {"omega_B", "omega_W", "direction_of_L", "length_of_L", "T"})
    EXPECT_FALSE(onlyQ.quantity(key).errors) << key;
  EXPECT_LE(errorsOf(onlyQ, "attitude").largest, 1e-15);

  const Grade onlyOmega = gradeOf("t,omega_B_x,omega_B_y,omega_B_z\n0,0.5,0.25,1\n");
  EXPECT_FALSE(onlyOmega.quantity("attitude").errors);
  EXPECT_FALSE(onlyOmega.quantity("direction_of_L").errors);
  EXPECT_EQ(errorsOf(onlyOmega, "T").largest, 0);  // ½ omega·I omega has only exact doubles here
  EXPECT_EQ(onlyOmega.quantity("T").from, "omega_B");
}

TEST(Grade, GradesEnergyAndMomentumAsRelativeErrors) {
  // Worked by hand: T = 2.34375 and L = (1, .75, 4) at all times. Columns T and L are graded instead of computed
  // values.
  const Grade grade = gradeOf(
      "t,omega_B_x,omega_B_y,omega_B_z,T,L_W_x,L_W_y,L_W_z\n"
      "0,0.5,0.25,1,2.578125,2,1.5,8\n");
  EXPECT_NEAR(errorsOf(grade, "T").largest, 0.1, 1e-15);
  EXPECT_NEAR(errorsOf(grade, "length_of_L").largest, 1, 1e-15);
  EXPECT_LE(errorsOf(grade, "direction_of_L").largest, 1e-15);
  EXPECT_EQ(grade.quantity("T").from, "T");
}

TEST(Grade, OmegaInSpaceNeedsTheAttitudeForEnergy) {
  const auto s = truth().at(2);
  const std::string omega = fmt::format("{},{},{}", s.omega_W.x(), s.omega_W.y(), s.omega_W.z());
  const Grade alone = gradeOf("t,omega_W_x,omega_W_y,omega_W_z\n2," + omega + "\n");
  EXPECT_FALSE(alone.quantity("T").errors);
  EXPECT_LE(errorsOf(alone, "omega_W").largest, 1e-16);
  const Grade both = gradeOf(fmt::format("t,omega_W_x,omega_W_y,omega_W_z,q_w,q_x,q_y,q_z\n2,{},{},{},{},{}\n",
                                         omega, s.q_WB.w(), s.q_WB.x(), s.q_WB.y(), s.q_WB.z()));
  EXPECT_LE(errorsOf(both, "T").largest, 1e-15);
  EXPECT_LE(errorsOf(both, "direction_of_L").largest, 1e-15);
}

TEST(Grade, GradesRowsInTheOrderOfTime) {
  const Grade grade = gradeOf("t,omega_B_x,omega_B_y,omega_B_z\n-1,9,9,9\n0,0.5,0.25,1\n-0.5,0,0,0\n");
  EXPECT_EQ(grade.first_s, 0);
  EXPECT_EQ(grade.last_s, -1);
  EXPECT_GT(errorsOf(grade, "omega_B").final, 5);
}

TEST(Grade, GradesALogWithInfiniteAndMissingValues) {
  const Grade grade = gradeOf("t,omega_B_x,omega_B_y,omega_B_z\n0,0.5,0.25,1\n1,nan,inf,0\n2,1e200,0,0\n");
  EXPECT_THAT(grade.notes,
              ElementsAre(HasSubstr("1 of 3 rows have a value that is not a number, or a quaternion of "
                                    "length 0; the first is at t = 1 s")));
  EXPECT_EQ(errorsOf(grade, "omega_B").largest, INFINITY);
  EXPECT_EQ(errorsOf(grade, "omega_B").largestAt_s, 1);
  EXPECT_EQ(errorsOf(grade, "omega_B").rms, INFINITY);
  const auto json = nlohmann::json::parse(gradeJson(grade, "theirs.csv", "s"));
  EXPECT_TRUE(json.at("quantities").at("omega_B").at("largest").is_null());
  EXPECT_TRUE(json.at("quantities").at("attitude").is_null());
}

TEST(GradeText, TableAndJsonContainTheSameValues) {
  const Grade grade = gradeOf(wrongFrom5(1));
  const std::string text = gradeTable(grade);
  EXPECT_THAT(text, HasSubstr("1001 rows, t = 0 to 10 s\n"));
  EXPECT_THAT(
      text,
      HasSubstr("attitude            5.00e-03 rad          10   5.00e-03   2.04e-03   from t = 5, linear\n"));
  EXPECT_THAT(text, HasSubstr("T                     absent\n"));
  const auto json = nlohmann::json::parse(gradeJson(grade, "theirs.csv", "s"));
  EXPECT_EQ(json.at("rows"), 1001);
  const auto& attitude = json.at("quantities").at("attitude");
  EXPECT_EQ(attitude.at("unit"), "rad");
  EXPECT_EQ(attitude.at("final").get<double>(), errorsOf(grade, "attitude").final);
  EXPECT_EQ(attitude.at("drift").at("kind"), "drift");
  EXPECT_EQ(attitude.at("drift").at("growth"), "power");
  EXPECT_NEAR(attitude.at("drift").at("from_s").get<double>(), 5, 0.0101);
}

}  // namespace
}  // namespace poinsot::reference
