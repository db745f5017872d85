// SPDX-License-Identifier: Apache-2.0
// Tests the interface for other programs: columns, order, digits, exit codes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>
#include <tuple>
#include <utility>

#include "support/development_examples.h"
#include "support/program_run.h"

namespace poinsot {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kHeader =
    "t,q_w,q_x,q_y,q_z,omega_B_x,omega_B_y,omega_B_z,omega_W_x,omega_W_y,omega_W_z,L_W_x,L_W_y,L_W_z,T";

/// Returns the rows as text, without the header. Fails the test if rows differ in length.
std::vector<std::vector<std::string>> rowsOf(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, kHeader);
  std::vector<std::vector<std::string>> rows;
  while (std::getline(lines, line)) {
    std::istringstream fields(line);
    auto& row = rows.emplace_back();
    for (std::string field; std::getline(fields, field, ',');) row.push_back(field);
    EXPECT_EQ(row.size(), 15u) << line;
  }
  return rows;
}

std::vector<std::string> timesOf(const std::string& csv) {
  std::vector<std::string> times;
  for (const auto& row : rowsOf(csv)) times.push_back(row.at(0));
  return times;
}

template <typename Vector>
std::string listed(const Vector& v) {
  std::ostringstream text;
  text.precision(17);
  for (int i = 0; i < v.size(); ++i) text << (i ? ", " : "[") << v[i];
  return text.str() + "]";
}

std::string sceneOf(const physics::Example& e) {
  const Eigen::Vector4d q(e.q0.w(), e.q0.x(), e.q0.y(), e.q0.z());
  return "[body]\nprincipal_moments = " + listed(e.I) + "\n[motion]\nomega_body = " + listed(e.omega0) +
         "\norientation = " + listed(q) + "\n";
}

/// Returns the angle between two unit quaternions of either sign, rad, in extended precision: 2 atan2(|vector|,
/// |scalar|) of conj(a) b.
double angle(const std::vector<std::string>& row, const Eigen::Quaterniond& expected) {
  using Q = Eigen::Quaternion<long double>;
  const Q a(std::stod(row[1]), std::stod(row[2]), std::stod(row[3]), std::stod(row[4]));
  const Q d = a.conjugate() * expected.cast<long double>();
  return static_cast<double>(2 * std::atan2(d.vec().norm(), std::abs(d.w())));
}

TEST(TrajectoryCommand, MatchesTheDevelopmentExamples) {
  const ScratchFolder folder;
  for (const physics::Example& e : physics::kExamples) {
    folder.put("e.toml", sceneOf(e));
    std::ostringstream at;
    at << "--at=" << e.t_s;
    const auto result = run(folder, {"trajectory", "e.toml", at.str()});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_THAT(result.err, IsEmpty());
    const auto row = rowsOf(result.out).at(0);
    EXPECT_LE(angle(row, e.q_WB), 4e-15) << e.name;  // measured: at most 3.1e-16
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(std::stod(row[5 + static_cast<std::size_t>(i)]), e.omega_B[i], 1e-15) << e.name;
    const double L = std::hypot(std::stod(row[11]), std::stod(row[12]), std::stod(row[13]));
    EXPECT_NEAR(L, e.L, 1e-15 * e.L);
    EXPECT_NEAR(2 * std::stod(row[14]) / L, e.planeHeight, 1e-15 * e.planeHeight);
  }
}

TEST(TrajectoryCommand, WritesOneRowPerTimeInTheOrderGiven) {
  const ScratchFolder folder;
  folder.put("a.toml", kGoodScene);
  EXPECT_EQ(timesOf(run(folder, {"trajectory", "a.toml", "--at", "-3.5,2"}).out),
            (std::vector<std::string>{"-3.5", "2"}));
  EXPECT_EQ(timesOf(run(folder, {"trajectory", "a.toml", "--at=-3.5"}).out), std::vector<std::string>{"-3.5"});
  EXPECT_EQ(timesOf(run(folder, {"trajectory", "--at", "-.5", "a.toml"}).out), std::vector<std::string>{"-0.5"});
  EXPECT_EQ(timesOf(run(folder, {"trajectory", "a.toml", "--at", "2,0,2, 90 ms ,1e9"}).out),
            (std::vector<std::string>{"2", "0", "2", "0.09", "1e+09"}));
  EXPECT_EQ(timesOf(run(folder, {"trajectory", "a.toml", "--at", "1", "--at", "0"}).out),
            (std::vector<std::string>{"1", "0"}));
  EXPECT_EQ(timesOf(run(folder, {"trajectory", "a.toml", "--at",
                                 "0.1000000000000000055511151231257827021181583404541015625"})
                        .out),
            std::vector<std::string>{"0.1"});
}

TEST(TrajectoryCommand, ComputesBackwardsForNegativeTimes) {
  // If the state at -3.5 s is the start, the state 3.5 s later is the start of the scene.
  const ScratchFolder folder;
  folder.put("a.toml", kGoodScene);
  const auto before = rowsOf(run(folder, {"trajectory", "a.toml", "--at", "-3.5,0"}).out);
  const auto& b = before[0];
  const auto after =
      rowsOf(run(folder, {"trajectory", "a.toml", "--at=3.5", "-D",
                          "motion.omega_body=[" + b[5] + "," + b[6] + "," + b[7] + "]", "-D",
                          "motion.orientation=[" + b[1] + "," + b[2] + "," + b[3] + "," + b[4] + "]"})
                 .out);
  for (std::size_t i = 1; i < 15; ++i)
    EXPECT_NEAR(std::stod(after[0][i]), std::stod(before[1][i]), 1e-12)
        << i;  // the body turns by 35 rad; measured 2e-14 for values up to 20
}

TEST(TrajectoryCommand, CoversTheWholeFilmWithOptionRate) {
  const ScratchFolder folder;
  folder.put("a.toml", kGoodScene);  // 4 s of film
  const auto out =
      run(folder, {"trajectory", "a.toml", "--rate", "4", "-D", "time.speed=0.5", "-D", "time.start=\"-1 s\""});
  EXPECT_EQ(timesOf(out.out),
            (std::vector<std::string>{"-1", "-0.75", "-0.5", "-0.25", "0", "0.25", "0.5", "0.75", "1"}));
}

TEST(TrajectoryCommand, WritesTheSameToFilesAndStandardOutput) {
  const ScratchFolder folder;
  folder.put("a.toml", kGoodScene);
  const auto out = run(folder, {"trajectory", "a.toml", "--at", "0,1", "-o", "-"});
  EXPECT_EQ(run(folder, {"trajectory", "a.toml", "--at", "0,1"}).out, out.out);
  const auto file = run(folder, {"trajectory", "a.toml", "--at", "0,1", "-o", "a.csv"});
  EXPECT_EQ(file.exitCode, 0);
  EXPECT_THAT(file.out, IsEmpty());
  EXPECT_EQ(bytesOf(folder / "a.csv"), out.out);
  EXPECT_EQ(run(folder, {"trajectory", "a.toml", "--at", "0", "-o", "a.csv"}).exitCode, 0);  // replaces its own
  EXPECT_EQ(namesIn(folder.path()), (std::vector<std::string>{"a.csv", "a.toml"}));
}

TEST(TrajectoryCommand, WritesTheSameNumbersToJson) {
  const ScratchFolder folder;
  folder.put("a.toml", kGoodScene);
  const auto rows = rowsOf(run(folder, {"trajectory", "a.toml", "--at", "0.3,-7"}).out);
  ASSERT_EQ(run(folder, {"trajectory", "a.toml", "--at", "0.3,-7", "-o", "a.json"}).exitCode, 0);
  const auto json = nlohmann::json::parse(bytesOf(folder / "a.json"));
  EXPECT_EQ(json.at("scene"), "a");
  std::string header;
  for (const std::string name : json.at("columns")) {
    header += (header.empty() ? "" : ",") + name;
    EXPECT_TRUE(json.at("units").contains(name));
  }
  EXPECT_EQ(header, kHeader);
  EXPECT_EQ(json.at("units").at("L_W_x"), "kg m^2/s");
  ASSERT_EQ(json.at("rows").size(), 2u);
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 15; ++j)
      EXPECT_EQ(json.at("rows")[i][j].get<double>(), std::stod(rows[i][j])) << i << " " << j;
}

TEST(TrajectoryCommand, AppendsTheRotationRateForADissipatingBodyOnly) {
  const ScratchFolder folder;
  folder.put("a.toml", kGoodScene);
  const auto lossy =
      run(folder, {"trajectory", "a.toml", "--at", "0", "-D", "motion.dissipation.alpha=0.001"}).out;
  EXPECT_THAT(lossy, testing::StartsWith(kHeader + ",rate_B_x,rate_B_y,rate_B_z,rate_W_x,rate_W_y,rate_W_z\n"));
  const auto none = run(folder, {"trajectory", "a.toml", "--at", "0", "-D", "motion.dissipation.alpha=0"}).out;
  EXPECT_EQ(none, run(folder, {"trajectory", "a.toml", "--at", "0"}).out);
}

TEST(TrajectoryCommand, NotesTimesWithAnUncertainAttitude) {
  // 3 omega_3^2 = omega_1^2 puts L on the separatrix, up to rounding. `info` counts the remaining digits.
  const ScratchFolder folder;
  folder.put("s.toml",
             "[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [1.7320508075688772, 2, 1]\n");
  EXPECT_THAT(run(folder, {"trajectory", "s.toml", "--at", "10"}).err, IsEmpty());  // info: 8.3 digits
  EXPECT_THAT(
      run(folder, {"trajectory", "s.toml", "--at", "0,100"}).err,
      testing::AllOf(HasSubstr("note: at t = 100 s the attitude is uncertain by 3.1 rad"),  // info: 0 digits
                     HasSubstr("close to the separatrix, and no digit of the attitude is meaningful")));
}

// omega (1, 1, 1) is far from the separatrix: L² - 2 T I2 = D = 2, and L² = 14. By run_condition.h, with dD/D = 13
// and a polhode period of 6.4227 s, the uncertainty is 2^-52 (sqrt(3) + 13 · 2/6.4227) t = 0.064 rad.
TEST(TrajectoryCommand, NamesTheSeparatrixAsTheCauseOnlyIfClose) {
  const ScratchFolder folder;
  folder.put("s.toml", "[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [1, 1, 1]\n");
  EXPECT_THAT(run(folder, {"trajectory", "s.toml", "--at", "5e13"}).err,
              testing::AllOf(HasSubstr("note: at t = 5e+13 s the attitude is uncertain by 0.064 rad"),
                             HasSubstr("the run amplifies the rounding")));
}

// omega = 2 rad/s, so the phase is 2 t. The rounding error of omega, 2^-52 of the phase, is a radian at 4.5e15
// rad.
TEST(TrajectoryCommand, NotesTurnsTooLargeForAnExactAttitude) {
  const ScratchFolder folder;
  folder.put("s.toml", "[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [0, 0, 2]\n");
  const auto noteAt = [&](const char* t) { return run(folder, {"trajectory", "s.toml", "--at", t}).err; };
  EXPECT_THAT(noteAt("4e13"), IsEmpty());
  EXPECT_THAT(noteAt("1e15"), testing::AllOf(HasSubstr("note: at t = 1e+15 s the body has turned by 2e+15 rad"),
                                             HasSubstr("beyond 1e+14 rad the attitude is no longer exact")));
  EXPECT_THAT(noteAt("-3e15"), testing::AllOf(HasSubstr("note: at t = 3e+15 s the body has turned by 6e+15 rad"),
                                              HasSubstr("beyond 4.5e+15 rad the attitude is meaningless")));
}

// Free symmetric top with I = (2, 2, 3) and omega = (0.4, 0, 5): tan(theta) = I1 w_perp/(I3 w_3), and
// E = (I1 w_perp^2 + I3 w_3^2)/2.
TEST(TrajectoryCommand, WritesTheNamedQuantitiesInTheirOrder) {
  const ScratchFolder folder;
  folder.put("top.toml", "[body]\nprincipal_moments = [2, 2, 3]\n[motion]\nomega_body = [0.4, 0, 5]\n");
  const std::vector<std::string> words{"trajectory",   "top.toml", "--at",         "0,2.5",
                                       "--quantities", "theta, E", "--quantities", "omega_W_z"};
  const auto result = run(folder, words);
  ASSERT_EQ(result.exitCode, 0) << result.err;
  std::istringstream lines(result.out);
  std::string header, first, second, none;
  std::getline(lines, header);
  std::getline(lines, first);
  std::getline(lines, second);
  EXPECT_EQ(header, "t,theta,E,omega_W_z");
  double t = 0, theta = 0, energy = 0;
  ASSERT_EQ(std::sscanf(second.c_str(), "%lf,%lf,%lf,", &t, &theta, &energy), 3) << second;
  EXPECT_EQ(t, 2.5);
  EXPECT_NEAR(theta, std::atan2(0.8, 15.0), 1e-15);
  EXPECT_NEAR(energy, 0.5 * (2 * 0.16 + 3 * 25), 1e-13);
  EXPECT_FALSE(std::getline(lines, none));
  // A second run replaces the file of the first one, because it has the same columns.
  for (int i = 0; i < 2; ++i)
    EXPECT_EQ(
        run(folder, {"trajectory", "top.toml", "--at", "0", "--quantities", "theta", "-o", "a.csv"}).exitCode, 0);
  EXPECT_EQ(run(folder, {"trajectory", "top.toml", "--at", "0", "--quantities", "phi", "-o", "a.csv"}).exitCode,
            4);
  EXPECT_EQ(run(folder, {"trajectory", "top.toml", "--at", "0", "--quantities", "phi", "-o", "a.json"}).exitCode,
            0);
  EXPECT_EQ(nlohmann::json::parse(bytesOf(folder / "a.json")).at("units").at("phi"), "rad");
}

// A body with I = (1, 2, 2.5) and omega_2 = 0 at the start. Half its polhode takes 2K/lambda, with lambda and k^2
// of Landau & Lifshitz, Mechanics, section 37, for L^2 = 25.04 and 2T = 10.04.
TEST(TrajectoryCommand, ListsEventsWithTheirFilmTimes) {
  const double square = 25.04, twoT = 10.04;
  const double lambda = std::sqrt(0.5 * (square - twoT) / 5), k2 = (twoT * 2.5 - square) / (0.5 * (square - twoT));
  double a = 1, b = std::sqrt(1 - k2);
  for (int i = 0; i < 30; ++i) std::tie(a, b) = std::pair((a + b) / 2, std::sqrt(a * b));
  const double interval = std::numbers::pi / a / lambda;
  const ScratchFolder folder;
  folder.put("s.toml",
             "[body]\nprincipal_moments = [1, 2, 2.5]\n[motion]\nomega_body = [0.2, 0, 2]\n"
             "[time]\nstart = 1\nspeed = -0.5\nduration = 30\n");
  const auto result = run(folder, {"trajectory", "s.toml", "--events", "-o", "e.json"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const auto json = nlohmann::json::parse(bytesOf(folder / "e.json"));
  EXPECT_EQ(json.at("format"), "poinsot events 1");
  const auto events = json.at("events");
  ASSERT_EQ(events.size(), static_cast<std::size_t>(14 / interval) + 1);
  for (std::size_t i = 0; i < events.size(); ++i) {
    const double t_s = -static_cast<double>(i) * interval;
    EXPECT_EQ(events[i].at("event"), "reversal");
    EXPECT_NEAR(events[i].at("t").get<double>(), t_s, 1e-13);
    EXPECT_NEAR(events[i].at("film_from").get<double>(), (1 - t_s) / 0.5, 1e-12);
    EXPECT_EQ(events[i].at("film_to"), events[i].at("film_from"));
  }
  // With --at, the span is that of the times. The film does not show positive times after 1 s.
  const auto later = run(folder, {"trajectory", "s.toml", "--events", "--at=8,2"});
  ASSERT_EQ(later.exitCode, 0) << later.err;
  std::istringstream lines(later.out);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "t,film_from,film_to,event");
  int count = 0;
  for (; std::getline(lines, line); ++count) EXPECT_THAT(line, HasSubstr(",nan,nan,reversal"));
  EXPECT_EQ(count, static_cast<int>(8 / interval) - static_cast<int>(2 / interval));
  const auto info = nlohmann::json::parse(run(folder, {"info", "s.toml", "--json"}).out);
  ASSERT_EQ(info.at("reversal_times").size(), events.size());
  EXPECT_EQ(info.at("reversal_film_times")[1], events[1].at("film_from"));
  for (const char* other : {"--rate=10", "--quantities=theta"})
    EXPECT_EQ(run(folder, {"trajectory", "s.toml", "--events", other}).exitCode, 2) << other;
}

// The highest point of a flight with V_z = 4.903325 m/s under 9.80665 m/s^2 is at 0.5 s. At the speed 0.1, this is
// 5 s of film.
TEST(TrajectoryCommand, ListsTheHighestPointOfAFlight) {
  const ScratchFolder folder;
  folder.put("s.toml",
             "[body]\nprincipal_moments = [2, 2, 3]\n[motion]\nomega_body = [0.2, 0, 2]\n"
             "[motion.flight]\nvelocity = [1, 0, 4.903325]\n[time]\nspeed = 0.1\nduration = 8\n");
  const auto shown = run(folder, {"trajectory", "s.toml", "--events"});
  ASSERT_EQ(shown.exitCode, 0) << shown.err;
  EXPECT_EQ(shown.out, "t,film_from,film_to,event\n0.5,5,5,highest_point\n");
  const auto missed = run(folder, {"trajectory", "s.toml", "--events", "-D", "time.duration=4"});
  EXPECT_EQ(missed.out, "t,film_from,film_to,event\n");
}

struct BadRequest {
  std::vector<std::string> words;
  int exitCode;
  std::string says;
};

TEST(TrajectoryCommand, RejectsInvalidTimesRatesAndOutputs) {
  const ScratchFolder folder;
  folder.put("a.toml", kGoodScene);
  folder.put("theirs.csv", "precious\n");
  const BadRequest cases[] = {
      {{}, 2, "--at T1,T2,... or --rate HZ"},
      {{"--at", "1", "--rate", "2"}, 2, "give either --at"},
      {{"--at", "1,,2"}, 2, "--at '': expected a time"},
      {{"--at", "soon"}, 2, "--at 'soon'"},
      {{"--at", "nan"}, 2, "nan is not a motion time"},
      {{"--at", "1e400"}, 2, "inf is not a motion time"},
      {{"--at", "1e308"}, 2, "t = 1e+308 s: too far from the start"},
      {{"--at", "0,-1e300"}, 2, "t = -1e+300 s: too far from the start"},
      {{"--at", ""}, 2, "--at: is empty"},
      {{"--at", "1", "--quantities", "tetha"}, 2, "'tetha'; did you mean theta? The names are t, omega_1, "},
      {{"--at", "1", "--quantities", "theta,,E"}, 2, "no quantity has the name ''"},
      {{"--at", "1", "--quantities", ""}, 2, "--quantities: is empty"},
      {{"--at", "1", "--quantities", "R_x"}, 2, "R_x exists only for a thrown body"},
      {{"--rate", "0"}, 2, "--rate '0'"},
      {{"--rate", "-5"}, 2, "--rate '-5'"},
      {{"--at", "1", "-o", "a.txt"}, 2, "output 'a.txt': must be NAME.csv, NAME.json or -"},
      {{"--at", "1", "-o", "no/a.csv"}, 4, "no such folder"},
      {{"--at", "1", "-o", "theirs.csv"}, 4, "exists and was not written by poinsot"},
      {{"--at", "1", "-D", "body.principal_moments=[1,2,9]"}, 2, "I3 must not exceed I1 + I2"},
  };
  for (const BadRequest& bad : cases) {
    std::vector<std::string> words{"trajectory", "a.toml"};
    words.insert(words.end(), bad.words.begin(), bad.words.end());
    const auto result = run(folder, words);
    EXPECT_EQ(result.exitCode, bad.exitCode) << bad.says << "\n" << result.err;
    EXPECT_THAT(result.err, HasSubstr(bad.says));
    EXPECT_THAT(result.err, testing::Not(HasSubstr("logic")));
  }
  EXPECT_EQ(bytesOf(folder / "theirs.csv"), "precious\n");
  EXPECT_EQ(namesIn(folder.path()), (std::vector<std::string>{"a.toml", "theirs.csv"}));
}

TEST(TrajectoryCommand, ReportsOutputThatCannotBeWritten) {
  const ScratchFolder folder;
  folder.put("a.toml", kGoodScene);
  const std::vector<std::string> words{"trajectory", "a.toml", "--rate", "1000"};  // more than a pipe holds
  EXPECT_EQ(run(folder, words, Stdout::kFull).exitCode, 4);
  EXPECT_EQ(run(folder, words, Stdout::kClosed).exitCode, 4);
  EXPECT_EQ(run(folder, words, Stdout::kBrokenPipe).exitCode, 141);
}

}  // namespace
}  // namespace poinsot
