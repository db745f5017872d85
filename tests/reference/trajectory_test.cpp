// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/error.h"
#include "core/number.h"
#include "physics/driven_motion.h"
#include "physics/free_motion.h"
#include "reference/trajectory.h"
#include "reference/trajectory_target.h"
#include "reference/trajectory_times.h"
#include "support/scratch_folder.h"

namespace poinsot::reference {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(TrajectoryNumber, ReadsTheNearestDouble) {
  EXPECT_EQ(core::parseNumber("-3.5"), -3.5);
  EXPECT_EQ(core::parseNumber("+1e9"), 1e9);
  // Half way between 1 and its upper neighbour 1 + 2^-52 a tie rounds to even (1). One more digit rounds up.
  EXPECT_EQ(core::parseNumber("1.00000000000000011102230246251565404236316680908203125"), 1.0);
  EXPECT_EQ(core::parseNumber("1.000000000000000111022302462515654042363166809082031250000000000000000001"),
            1 + 0x1p-52);
  EXPECT_EQ(core::parseNumber("1e-400"), 0.0);
  EXPECT_EQ(core::parseNumber("-1e400"), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(core::parseNumber("4.9406564584124654e-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_TRUE(std::isnan(*core::parseNumber("nan")));
  for (const char* word : {"", "+", "-", "+-1", "1 ", " 1", "1x", "0x10", "1,5", "--1", "e5"})
    EXPECT_FALSE(core::parseNumber(word)) << word;
}

TEST(TrajectoryNumber, RoundTripsDoubles) {
  for (const double value : {0.1, -1.0 / 3, 1e22, 5e-324, -2.2250738585072014e-308, 1.7976931348623157e308}) {
    std::string text;
    core::appendNumber(text, value);
    EXPECT_EQ(core::parseNumber(text), value) << text;
  }
  std::string text = "a,";
  core::appendNumber(text, 0.1);
  core::appendNumber(text, -0.0);
  EXPECT_EQ(text, "a,0.10");
}

std::vector<double> all(const TrajectoryTimes& times) {
  std::vector<double> t_s;
  for (std::int64_t k = 0; k < times.count(); ++k) t_s.push_back(times[k]);
  return t_s;
}

TEST(TrajectoryTimes, KeepListedTimesInOrder) {
  const TrajectoryTimes times({2, -3.5, 2, 1e9});
  EXPECT_THAT(all(times), ElementsAre(2, -3.5, 2, 1e9));
  EXPECT_EQ(times.earliest_s(), -3.5);
  EXPECT_EQ(times.latest_s(), 1e9);
}

TEST(TrajectoryTimes, IncludeBothEndsOfAnExactSpan) {
  EXPECT_THAT(all(TrajectoryTimes({2, 1}, 10, 1.5)), ElementsAre(10, 10.5, 11, 11.5));
  EXPECT_THAT(all(TrajectoryTimes({2, 1}, 10, 1.4)), ElementsAre(10, 10.5, 11));
  EXPECT_THAT(all(TrajectoryTimes({2, 1}, 10, -1)), ElementsAre(10, 9.5, 9));
  EXPECT_THAT(all(TrajectoryTimes({1, 3}, 0, 0)), ElementsAre(0));
  const TrajectoryTimes back({2, 1}, 10, -1);
  EXPECT_EQ(back.earliest_s(), 9);
  EXPECT_EQ(back.latest_s(), 10);
}

TEST(TrajectoryTimes, AccumulateNoRounding) {
  const TrajectoryTimes times({30000, 1001}, 0, 1001);
  EXPECT_EQ(times.count(), 30001);
  EXPECT_EQ(times[30000], 1001.0);
  EXPECT_EQ(times[1], 1001.0 / 30000);
}

TEST(TrajectoryTimes, IncludeTheEndOfARoundedSpan) {
  // 0.7 * 0.1 rounds to 0.06999999999999999; 0.07 s at 100 Hz must still give eight rows.
  EXPECT_EQ(TrajectoryTimes({100, 1}, 0, 0.7 * 0.1).count(), 8);
}

core::ErrorKind kindOf(const std::function<void()>& call) {
  try {
    call();
  } catch (const core::Error& error) {
    return error.kind();
  }
  ADD_FAILURE() << "nothing thrown";
  return core::ErrorKind::kIo;
}

TEST(TrajectoryTimes, RejectEmptyInfiniteAndTooManyTimes) {
  EXPECT_EQ(kindOf([] { TrajectoryTimes({}); }), core::ErrorKind::kUsage);
  EXPECT_EQ(kindOf([] { TrajectoryTimes({0, NAN}); }), core::ErrorKind::kUsage);
  EXPECT_EQ(kindOf([] { TrajectoryTimes({HUGE_VAL}); }), core::ErrorKind::kUsage);
  EXPECT_EQ(kindOf([] { TrajectoryTimes({1000000000, 1}, 0, 1e10); }), core::ErrorKind::kLimit);
}

physics::FreeMotion asymmetric() {
  return {physics::PrincipalMoments({2, 3, 4}), {.5, .25, 1}, Eigen::Quaterniond(1, 0, 0, 0)};
}

std::string csv(const TrajectoryTimes& times, std::size_t* pieces = nullptr, std::size_t* longest = nullptr) {
  std::string text;
  writeTrajectory(asymmetric(), ChosenColumns(0), times, TrajectoryFormat::kCsv, "s", [&](std::string_view piece) {
    text += piece;
    if (pieces) ++*pieces;
    if (longest) *longest = std::max(*longest, piece.size());
  });
  return text;
}

TEST(TrajectoryText, RoundTripsDoubles) {
  std::istringstream lines(csv(TrajectoryTimes({-3.5, 1e6})));
  std::string line, field;
  std::getline(lines, line);
  EXPECT_EQ(line,
            "t,q_w,q_x,q_y,q_z,omega_B_x,omega_B_y,omega_B_z,omega_W_x,omega_W_y,omega_W_z,"
            "L_W_x,L_W_y,L_W_z,T");
  for (const double t_s : {-3.5, 1e6}) {
    const auto s = asymmetric().at(t_s);
    const double expected[] = {t_s,           s.q_WB.w(),    s.q_WB.x(),    s.q_WB.y(),    s.q_WB.z(),
                               s.omega_B.x(), s.omega_B.y(), s.omega_B.z(), s.omega_W.x(), s.omega_W.y(),
                               s.omega_W.z(), s.L_W.x(),     s.L_W.y(),     s.L_W.z(),     s.kineticEnergy};
    ASSERT_TRUE(std::getline(lines, line));
    std::istringstream fields(line);
    for (const double value : expected) {
      ASSERT_TRUE(std::getline(fields, field, ','));
      EXPECT_EQ(std::stod(field), value);
    }
    EXPECT_FALSE(std::getline(fields, field, ','));
  }
  EXPECT_FALSE(std::getline(lines, line));
}

/// A body that loses energy, and an independent integration with Runge-Kutta steps of order 4: m' = m x r,
/// q' = q r/2, r = omega + alpha m x omega.
struct Dissipating {
  Eigen::Vector3d I{2, 3, 4}, omega0{.5, .25, 1};
  double alpha = 0.03;

  physics::DrivenMotion motion(double to_s) const {
    physics::Forcing forcing;
    forcing.dissipation = alpha;
    return {physics::PrincipalMoments(I), omega0, Eigen::Quaterniond(1, 0, 0, 0), forcing, {0, to_s}};
  }
  Eigen::Vector3d rate(const Eigen::Vector3d& m) const {
    const Eigen::Vector3d omega = m.cwiseQuotient(I);
    return omega + alpha * m.cross(omega);
  }
  using State = Eigen::Matrix<double, 7, 1>;  // x, y, z, w of q, then m
  State derivative(const State& s) const {
    const Eigen::Vector3d m = s.tail<3>(), r = rate(m);
    const Eigen::Quaterniond q(s[3], s[0], s[1], s[2]);
    State d;
    d << (q * Eigen::Quaterniond(0, r[0], r[1], r[2])).coeffs() / 2, m.cross(r);
    return d;
  }
  State integrated(double to_s, int steps) const {
    State s;
    s << 0, 0, 0, 1, I.cwiseProduct(omega0);
    const double h = to_s / steps;
    for (int k = 0; k < steps; ++k) {
      const State a = derivative(s), b = derivative(s + h / 2 * a), c = derivative(s + h / 2 * b),
                  d = derivative(s + h * c);
      s += h / 6 * (a + 2 * b + 2 * c + d);
    }
    return s;
  }
};

std::vector<std::vector<std::string>> fieldsOf(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    auto& row = rows.emplace_back();
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');) row.push_back(field);
  }
  return rows;
}

TEST(TrajectoryText, AppendsTheRateOfTurningWithDissipation) {
  const Dissipating body;
  std::string text;
  writeTrajectory(body.motion(5), ChosenColumns(body.alpha), TrajectoryTimes({5}), TrajectoryFormat::kCsv, "s",
                  [&](std::string_view piece) { text += piece; });
  EXPECT_THAT(text,
              StartsWith(ChosenColumns(0).header() + ",rate_B_x,rate_B_y,rate_B_z,rate_W_x,rate_W_y,rate_W_z\n"));
  const auto row = fieldsOf(text).at(1);
  ASSERT_EQ(row.size(), 21u);
  const Dissipating::State end = body.integrated(5, 20000);
  const Eigen::Quaterniond q(end[3], end[0], end[1], end[2]);
  const Eigen::Vector3d rate_B = body.rate(end.tail<3>()), rate_W = q * rate_B;
  const double sign = q.w() < 0 ? -1 : 1;
  const double expected[] = {sign * q.w(), sign * q.x(), sign * q.y(), sign * q.z()};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(std::stod(row[1 + i]), expected[i], 1e-12);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    EXPECT_NEAR(std::stod(row[15 + i]), rate_B[at], 1e-12);  // measured 1.5e-14
    EXPECT_NEAR(std::stod(row[18 + i]), rate_W[at], 1e-12);
  }
  EXPECT_GT(std::abs(std::stod(row[15]) - std::stod(row[5])), 1e-3);  // rate and omega differ
}

TEST(TrajectoryText, JsonIncludesTheRateOfTurningWithDissipation) {
  std::string text;
  writeTrajectory(Dissipating().motion(1), ChosenColumns(Dissipating().alpha), TrajectoryTimes({0, 1}),
                  TrajectoryFormat::kJson, "s", [&](std::string_view piece) { text += piece; });
  const auto json = nlohmann::json::parse(text);
  ASSERT_EQ(json.at("columns").size(), 21u);
  EXPECT_EQ(json.at("columns")[15], "rate_B_x");
  EXPECT_EQ(json.at("units").at("rate_W_z"), "rad/s");
  EXPECT_EQ(json.at("rows")[1].size(), 21u);
}

TEST(TrajectoryText, IsWrittenInPiecesOfBoundedSize) {
  std::size_t pieces = 0, longest = 0;
  const std::string text = csv(TrajectoryTimes({5000, 1}, 0, 1), &pieces, &longest);
  EXPECT_GT(text.size(), 1u << 20);
  EXPECT_GT(pieces, 15u);
  EXPECT_LT(longest, 70000u);
}

TEST(TrajectoryText, RejectsTimesTooLargeForAPhase) {
  EXPECT_EQ(kindOf([] { csv(TrajectoryTimes({1e308})); }), core::ErrorKind::kLimit);
}

TEST(TrajectoryTarget, TakesItsFormatFromTheFileName) {
  EXPECT_TRUE(parseTrajectoryTarget("-").isStream());
  EXPECT_EQ(parseTrajectoryTarget("-").format, TrajectoryFormat::kCsv);
  EXPECT_EQ(parseTrajectoryTarget("a/b.csv").path, "a/b.csv");
  EXPECT_EQ(parseTrajectoryTarget("b.json").format, TrajectoryFormat::kJson);
  for (const char* name : {"", "b", "b.txt", "b.csv.gz"})
    EXPECT_EQ(kindOf([&] { parseTrajectoryTarget(name); }), core::ErrorKind::kUsage) << name;
}

TEST(TrajectoryTarget, ReplacesOnlyTrajectories) {
  const ScratchFolder folder;
  const auto target = [&](const std::string& name) { return parseTrajectoryTarget((folder / name).string()); };
  folder.put("own.csv", ChosenColumns(0).header() + "\n0\n");
  folder.put("own.json", trajectoryMark(TrajectoryFormat::kJson) + ",}");
  folder.put("empty.csv", "");
  folder.put("data.csv", "t,x\n0,1\n");
  folder.put("same.csv", "t,theta\n0,1\n");
  folder.put("more.csv", "t,theta,phi\n0,1,2\n");
  const auto isOwn = [&](const std::string& name) {
    return trajectoryKind(target(name).format, "t,theta").isOwn(folder / name);
  };
  for (const char* name : {"own.csv", "own.json", "empty.csv", "same.csv"}) EXPECT_TRUE(isOwn(name)) << name;
  for (const char* name : {"data.csv", "missing.csv", "more.csv"}) EXPECT_FALSE(isOwn(name)) << name;
}

}  // namespace
}  // namespace poinsot::reference
