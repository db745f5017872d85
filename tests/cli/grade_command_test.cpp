// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/program_run.h"

namespace poinsot {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class GradeCommand : public testing::Test {
 protected:
  GradeCommand() {
    folder_.put("a.toml", kGoodScene);
    EXPECT_EQ(grade({}, "trajectory", {"--rate", "20", "-D", "time.speed=1", "-o", "copy.csv"}).exitCode, 0);
  }

  RunResult grade(const std::vector<std::string>& files, const std::string& command = "grade",
                  const std::vector<std::string>& options = {}) const {
    std::vector<std::string> words{command, "a.toml"};
    words.insert(words.end(), files.begin(), files.end());
    words.insert(words.end(), options.begin(), options.end());
    return run(folder_, words);
  }

  ScratchFolder folder_;
};

TEST_F(GradeCommand, FindsNoErrorInACopy) {
  const auto result = grade({"copy.csv"}, "grade", {"--max-attitude-error", "1e-15"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.out, StartsWith("81 rows, t = 0 to 4 s\n"));
  EXPECT_THAT(result.out, HasSubstr("none: rounding"));
}

TEST_F(GradeCommand, ReportsErrorsIfTheSceneHasAnotherBody) {
  const auto result = grade({"copy.csv"}, "grade", {"-D", "body.principal_moments=[1, 2, 2.999999]"});
  EXPECT_EQ(result.exitCode, 0);  // the exit code is 0 for any grade
  EXPECT_THAT(result.out, HasSubstr("from t = 0"));
  const auto limited = grade({"copy.csv"}, "grade",
                             {"-D", "body.principal_moments=[1, 2, 2.9]", "--max-attitude-error", "0.1 deg"});
  EXPECT_EQ(limited.exitCode, 1);
  EXPECT_THAT(limited.out, StartsWith("81 rows"));
  EXPECT_THAT(limited.err, AllOf(StartsWith("poinsot: copy.csv: the attitude is off by "),
                                 HasSubstr(" s, --max-attitude-error allows 0.00175 rad\n")));
}

// `grade` refuses the same times as `trajectory --at`, and names their place for any column order and row.
TEST_F(GradeCommand, ReportsLineAndColumnOfTimesTooFarFromTheStart) {
  const std::string head = "q_w,q_x,t,q_y,q_z\n1,0,0,0,0\n\n# a comment\n";
  for (const std::string t : {"1e300", "1e308", "-1e300", "-1e308", "1e291"}) {
    folder_.put("far.csv", head + "1,0, " + t + ",0,0\n1,0,3,0,0\n");
    const auto result = grade({"far.csv"});
    EXPECT_EQ(result.exitCode, 2) << t;
    EXPECT_THAT(result.err,
                testing::MatchesRegex("poinsot: error: far\\.csv:5:6: t = .* s: too far from the start; .*\n"));
  }
  for (const std::string t : {"4.9e-324", "-1e-310", "1e280"}) {
    folder_.put("far.csv", head + "1,0," + t + ",0,0\n");
    EXPECT_EQ(grade({"far.csv"}).exitCode, 0) << t;
  }
  for (const std::string t : {"nan", "inf", "-inf"}) {
    folder_.put("far.csv", head + "1,0," + t + ",0,0\n");
    EXPECT_THAT(grade({"far.csv"}).err, HasSubstr("far.csv:5:5: t: " + t + " is not a finite number")) << t;
  }
}

TEST_F(GradeCommand, NotesTimesThatAreNotInSeconds) {
  folder_.put("ms.csv", "t,omega_B_x,omega_B_y,omega_B_z\n0,0.1,10,0\n2000,5,-8,3\n4000,-5,8,-3\n");
  const char* note =
      "Note: the log's times go to 4000 s, the film's motion to 4 s; t must be the motion time in seconds.";
  EXPECT_THAT(grade({"ms.csv"}, "grade", {"-D", "time.speed=1"}).out, HasSubstr(note));
  // A correct long run gives no note.
  EXPECT_EQ(grade({"copy.csv"}, "grade", {"-D", "time.speed=0.001"}).out.find("the log's times"),
            std::string::npos);
}

/// Returns the table with each time multiplied by `perSecond` and then shifted by `shift_s`, so that the first row
/// is no longer the start.
std::string withTimes(const std::string& csv, double shift_s, double perSecond = 1) {
  std::string moved = csv.substr(0, csv.find('\n') + 1);
  std::istringstream lines(csv.substr(moved.size()));
  for (std::string line; std::getline(lines, line);) {
    std::ostringstream t;
    t << std::setprecision(17) << perSecond * std::stod(line) + shift_s;
    moved += t.str() + line.substr(line.find(',')) + "\n";
  }
  return moved;
}

TEST_F(GradeCommand, ReportsTheOffsetOfAClock) {
  folder_.put("late.csv", withTimes(bytesOf(folder_ / "copy.csv"), -0.25));
  EXPECT_THAT(
      grade({"late.csv"}).out,
      HasSubstr("\nNote: fits if t is 0.25 s later (t + 0.25; the first row is the motion at 0 s): attitude "));
  folder_.put("epoch.csv", withTimes(bytesOf(folder_ / "copy.csv"), 1.7e9));
  const auto epoch = grade({"epoch.csv"});
  EXPECT_THAT(epoch.out, HasSubstr("\nNote: fits if t is 1700000000 s earlier (a clock's time: t - 1700000000; "));
  EXPECT_EQ(epoch.out.find("the log's times"), std::string::npos);  // only one note names the cause
}

// At the time of the clock, the body is exactly at rest, so errors have no reference value.
TEST_F(GradeCommand, ReportsTheOffsetOfAClockForABodyAtRest) {
  const std::string drag = "motion.drag.rate=[0.01,0.02,0.03]";
  EXPECT_EQ(grade({}, "trajectory", {"--rate", "20", "-D", "time.speed=1", "-o", "drag.csv", "-D", drag}).exitCode,
            0);
  folder_.put("epoch.csv", withTimes(bytesOf(folder_ / "drag.csv"), 1.7e9));
  const auto epoch = grade({"epoch.csv"}, "grade", {"-D", drag});
  EXPECT_THAT(epoch.out, HasSubstr("\nNote: fits if t is 1700000000 s earlier (a clock's time: "));
  EXPECT_THAT(epoch.out, testing::ContainsRegex("\n\\|L\\| +2.00e[+]01 kg m.2/s "));
  EXPECT_THAT(epoch.out, testing::ContainsRegex("\nT +1.00e[+]02 J "));
}

/// Fixture with a log of the scene under a torque, which is integrated.
class GradeCommandUnderTorque : public GradeCommand {
 protected:
  GradeCommandUnderTorque() {
    EXPECT_EQ(
        grade({}, "trajectory",
              {"--rate", "20", "-D", "time.speed=1", "-o", "torque.csv", "-D", "motion.torque.body=[0.01,0,0]"})
            .exitCode,
        0);
  }

  RunResult refused(const std::string& csv, const std::string& torque = "[0.01,0,0]") const {
    folder_.put("epoch.csv", csv);
    const auto result = grade({"epoch.csv"}, "grade", {"-D", "motion.torque.body=" + torque});
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_EQ(result.out, "");
    return result;
  }
};

TEST_F(GradeCommandUnderTorque, GradesALogThatStartsTooLateFromItsFirstRow) {
  EXPECT_THAT(refused(withTimes(bytesOf(folder_ / "torque.csv"), 1.7e9)).err,
              HasSubstr("; the log's t starts at 1700000000 s: fits if t is 1700000000 s earlier ("));
}

TEST_F(GradeCommandUnderTorque, ReportsNoFitIfALateLogHasErrors) {
  const auto result = refused(withTimes(bytesOf(folder_ / "torque.csv"), 1.7e9), "[1,0,0]");
  EXPECT_THAT(result.err, HasSubstr("; the log's t starts at 1700000000 s: graded from its first row: attitude "));
  EXPECT_EQ(result.err.find("fits"), std::string::npos);
}

TEST_F(GradeCommandUnderTorque, ReportsTimesAsWrittenIfTheLogIsTooLong) {
  EXPECT_THAT(refused(withTimes(bytesOf(folder_ / "torque.csv"), 1.7e18, 1e9)).err, HasSubstr("1.7e+18"));
}

TEST_F(GradeCommand, PrintsJson) {
  const auto result = grade({"copy.csv"}, "grade", {"--json"});
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json.at("file"), "copy.csv");
  EXPECT_EQ(json.at("scene"), "a");
  for (const char* key : {"attitude", "omega_B", "omega_W", "direction_of_L", "length_of_L", "T"})
    EXPECT_LE(json.at("quantities").at(key).at("largest").get<double>(), 1e-15) << key;
}

TEST_F(GradeCommand, ReportsLineOfMistakesInTheCsv) {
  folder_.put("bad.csv", "t,omega_B_x,omega_B_y,omega_B_z\n0,1,2,three\n");
  const auto bad = grade({"bad.csv"});
  EXPECT_EQ(bad.exitCode, 4);
  EXPECT_EQ(bad.err, "poinsot: error: bad.csv:2:7: omega_B_z: 'three' is not a number\n");
  EXPECT_EQ(grade({"missing.csv"}).exitCode, 4);
  EXPECT_EQ(grade({}).exitCode, 2);
}

TEST_F(GradeCommand, RejectsInvalidLimitsAndLogsWithoutAttitude) {
  for (const char* limit : {"-1", "nan", "soon", "1 m", ""})
    EXPECT_EQ(grade({"copy.csv"}, "grade", {"--max-attitude-error", limit}).exitCode, 2) << limit;
  folder_.put("spin.csv", "t,omega_B_x,omega_B_y,omega_B_z\n0,0.1,10,0\n");
  const auto result = grade({"spin.csv"}, "grade", {"--max-attitude-error", "1"});
  EXPECT_EQ(result.exitCode, 4);
  EXPECT_THAT(result.err, HasSubstr("spin.csv: --max-attitude-error needs the columns q_w, q_x, q_y, q_z"));
}

}  // namespace
}  // namespace poinsot
