// SPDX-License-Identifier: Apache-2.0
// Grading of logs that hold the exact motion in another convention, and of wrong engines, which fit none.
#include "reference/grade_convention.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>
#include <utility>

#include "core/error.h"
#include "reference/grade_logs.h"
#include "reference/grade_text.h"

namespace poinsot::reference {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using physics::RigidBodyState;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

LogRow asItIs(const RigidBodyState& s) { return {s.t_s, s.q_WB, s.omega_B}; }

Quaterniond conjugated(const Quaterniond& q) { return q.conjugate(); }

TEST(GradeConvention, AddsNoNoteToALogThatFits) {
  EXPECT_THAT(gradeOfLog(logOf(asItIs)).notes, IsEmpty());
  EXPECT_FALSE(gradeOfLog(logOf(asItIs)).fit);
}

TEST(GradeConvention, NamesOrderAndConjugationOfQuaternions) {
  for (const Holds holds : {Holds::kAttitude, Holds::kBoth}) {
    const auto cause = [&](Quaterniond (*change)(const Quaterniond&), const std::string& condition) {
      expectCause(logOf(
                      [&](const auto& s) {
                        return LogRow{s.t_s, change(s.q_WB), s.omega_B};
                      },
                      holds),
                  condition);
    };
    cause(scalarLast, "q_w, q_x, q_y, q_z hold x, y, z, w");
    cause(conjugated, "q is conjugated");
    const Grade both = gradeOfLog(logOf(
        [](const auto& s) {
          return LogRow{s.t_s, scalarLast(s.q_WB.conjugate()), s.omega_B};
        },
        holds));
    EXPECT_THAT(both.notes, ElementsAre(AllOf(HasSubstr("hold x, y, z, w"), HasSubstr("and q is conjugated"))));
  }
}

TEST(GradeConvention, NamesUnitsAndFrameOfOmega) {
  for (const Holds holds : {Holds::kOmega, Holds::kBoth}) {
    const auto scaled = [&](double perSi) {
      return logOf([=](const auto& s) { return LogRow{s.t_s, s.q_WB, perSi * s.omega_B}; }, holds);
    };
    expectCause(scaled(180 / EIGEN_PI), "omega is in deg/s");
    expectCause(scaled(30 / EIGEN_PI), "omega is in rpm");
    expectCause(scaled(.5 / EIGEN_PI), "omega is in rev/s");
    expectCause(logOf(
                    [](const auto& s) {
                      return LogRow{s.t_s, s.q_WB, s.omega_W};
                    },
                    holds),
                "omega is along the axes of the other frame");
  }
}

LogWriter later(double by_s) {
  return [by_s](const RigidBodyState& s) { return LogRow{s.t_s - by_s, s.q_WB, s.omega_B}; };
}

TEST(GradeConvention, NamesAShiftOfTime) {
  for (const Holds holds : {Holds::kAttitude, Holds::kOmega, Holds::kBoth}) {
    expectCause(logOf(later(0.5), holds), "t is 0.5 s later");
    expectCause(logOf(later(0.01), holds), "t is 0.01 s later");
    expectCause(logOf(later(-2.25), holds), "t is 2.25 s earlier");
  }
  const Grade epoch = gradeOfLog(logOf(later(-1.7e9)));
  EXPECT_THAT(epoch.notes,
              ElementsAre(StartsWith("fits if t is 1700000000 s earlier (a clock's time: t - 1700000000; "
                                     "the first row is the motion at 0 s): attitude ")));
  EXPECT_LE(largestLeft(epoch), 1.4e-7);  // half the spacing of doubles at 1.7e9, times |omega|; measured 1.1e-7
}

TEST(GradeConvention, NamesUnitsOfTime) {
  const auto scaled = [](double perSecond) {
    return logOf([=](const auto& s) { return LogRow{s.t_s * perSecond, s.q_WB, s.omega_B}; });
  };
  expectCause(scaled(1e3), "t is in ms");
  expectCause(scaled(1e9), "t is in ns");
  for (const auto& [unit, perSecond] : {std::pair{"ms", 1e3}, {"us", 1e6}, {"ns", 1e9}}) {
    const Grade both = gradeOfLog(logOf([scale = perSecond](const auto& s) {
      return LogRow{(s.t_s + 1.7e9) * scale, s.q_WB, s.omega_B};
    }));
    EXPECT_THAT(both.notes, ElementsAre(AllOf(HasSubstr(std::string("t is in ") + unit),
                                              HasSubstr("and t is 1700000000 s earlier"))));
  }
}

TEST(GradeConvention, FindsATimeShiftInLogsOfFewDigits) {
  const Grade grade = gradeOfLog(logOf(*loggedMotion(), later(0.5), Holds::kBoth, 5));
  EXPECT_THAT(grade.notes, ElementsAre(HasSubstr("fits if t is 0.5 s later"),
                                       HasSubstr("lengths of quaternions differ from 1")));
}

TEST(GradeConvention, NamesTwoCausesTogether) {
  const auto notes = [](const LogWriter& writer, Holds holds = Holds::kBoth) {
    const Grade grade = gradeOfLog(logOf(writer, holds));
    EXPECT_LE(largestLeft(grade), 7e-15);  // measured 7.6e-16
    return grade.notes;
  };
  const double deg = 180 / EIGEN_PI;
  EXPECT_THAT(notes([&](const auto& s) {
                return LogRow{s.t_s - 0.5, s.q_WB, deg * s.omega_B};
              }),
              ElementsAre(AllOf(HasSubstr("omega is in deg/s"), HasSubstr("t is 0.5 s later"))));
  EXPECT_THAT(notes(
                  [&](const auto& s) {
                    return LogRow{s.t_s - 0.5, s.q_WB, deg * s.omega_B};
                  },
                  Holds::kOmega),
              ElementsAre(AllOf(HasSubstr("omega is in deg/s"), HasSubstr("t is 0.5 s later"))));
  EXPECT_THAT(notes(
                  [&](const auto& s) {
                    return LogRow{s.t_s - 0.5, scalarLast(s.q_WB), s.omega_B};
                  },
                  Holds::kAttitude),
              ElementsAre(AllOf(HasSubstr("hold x, y, z, w"), HasSubstr("t is 0.5 s later"))));
  EXPECT_THAT(notes([&](const auto& s) {
                return LogRow{s.t_s, s.q_WB.conjugate(), deg * s.omega_B};
              }),
              ElementsAre(AllOf(HasSubstr("q is conjugated"), HasSubstr("omega is in deg/s"))));
}

std::unique_ptr<const physics::Motion> top(const physics::TimeSpan& span) {
  physics::Forcing forcing;
  forcing.gravity_B = {0, 0, 5};
  return std::make_unique<physics::DrivenMotion>(physics::PrincipalMoments({2, 2, 1}), Vector3d(0.1, 0, 12),
                                                 Quaterniond(.9, .3, 0, 0), forcing, span);
}

Grade gradeOf(const std::string& csv, const MotionMaker& maker) {
  const TrajectoryTable table = parseTrajectoryTable(csv, "theirs.csv");
  return grade(*maker(spanOf(table)), table, maker);
}

TEST(GradeConvention, FindsTheTimeShiftOfADrivenMotion) {
  const auto motion = top({0, 31});
  const TrajectoryTable table = parseTrajectoryTable(logOf(*motion, later(0.7)), "theirs.csv");
  const Grade shifted = grade(*top(spanOf(table)), table, top);
  EXPECT_THAT(shifted.notes, ElementsAre(HasSubstr("t is 0.7 s later")));
  EXPECT_LE(largestLeft(shifted), 1e-11);                           // two integrations to 1e-12; measured 3.2e-14
  EXPECT_THAT(grade(*top(spanOf(table)), table).notes, IsEmpty());  // without a maker no other time span is known
}

TEST(GradeConvention, FitsAHugeTimeShiftFromTheFirstRow) {
  const auto motion = top({0, 31});
  const TrajectoryTable table = parseTrajectoryTable(logOf(*motion, later(-1.7e9)), "theirs.csv");
  EXPECT_THAT(fitNote(gradeFromZero(top, table)), StartsWith("fits if t is 1700000000 s earlier"));
  EXPECT_EQ(firstRowNote(gradeFromZero(top, table)), fitNote(gradeFromZero(top, table)));
}

TEST(GradeConvention, FindsNoFitForAWrongLogWithAHugeTimeShift) {
  const auto motion = top({0, 31});
  const LogWriter wrong = [](const auto& s) { return LogRow{s.t_s + 1.7e9, {0, 1, 0, 0}, -s.omega_B}; };
  const TrajectoryTable table = parseTrajectoryTable(logOf(*motion, wrong), "theirs.csv");
  EXPECT_THAT(firstRowNote(gradeFromZero(top, table)), StartsWith("graded from its first row: attitude "));
}

TEST(GradeConvention, IgnoresInvalidRowsBeforeTheMotionStarts) {
  const MotionMaker forwards = [](const physics::TimeSpan& span) {
    if (span.from_s < 0) throw core::Error(core::ErrorKind::kLimit, "no past");
    return top(span);
  };
  std::string csv = logOf(*top({0, 31}), later(-100));
  csv.insert(csv.find('\n'), "\n99,nan,nan,nan,nan,nan,nan,nan");  // one second before motion time 0
  const Grade late = gradeOf(csv, forwards);
  EXPECT_THAT(late.notes, ElementsAre(StartsWith("fits if t is 100 s earlier"), StartsWith("1 of 101 rows")));
  EXPECT_LE(largestLeft(late), 1.6e-12);  // two integrations to 1e-12; measured 1.6e-13
}

TEST(GradeConvention, BlamesNoConventionForAWrongMotion) {
  for (const double h : {0.3, 0.1, 0.03, 0.01})
    for (const auto& [name, step] : {std::pair<const char*, EngineStep>{"Euler", explicitEuler},
                                     {"semi-implicit Euler", semiImplicitEuler},
                                     {"Runge-Kutta", rungeKutta}}) {
      const int steps = static_cast<int>(60 / h);
      EXPECT_FALSE(gradeOfLog(engineCsv(step, kLoggedMoments, kLoggedStart, h, steps, 1)).fit) << name << ' ' << h;
    }
  EXPECT_THAT(gradeOfLog(engineCsv(rungeKutta, {2, 3, 4.1}, kLoggedStart, 1e-2, 6000, 10)).notes, IsEmpty());
  const LogWriter damped = [](const auto& s) { return LogRow{s.t_s, s.q_WB, (1 - 5e-3 * s.t_s) * s.omega_B}; };
  EXPECT_THAT(gradeOfLog(logOf(damped)).notes, IsEmpty());
  EXPECT_THAT(gradeOfLog(logOf(damped, Holds::kOmega)).notes, IsEmpty());
}

TEST(GradeConvention, BlamesNoConventionForNoise) {
  std::mt19937 bits(3);
  std::normal_distribution<double> normal;
  const auto noise = [&] { return Vector3d(normal(bits), normal(bits), normal(bits)); };
  const LogWriter noisy = [&](const auto& s) {
    return LogRow{s.t_s, Quaterniond(Eigen::AngleAxisd(normal(bits), noise().normalized())), noise()};
  };
  EXPECT_THAT(gradeOfLog(logOf(noisy)).notes, IsEmpty());
  const LogWriter faint = [&](const auto& s) { return LogRow{s.t_s, s.q_WB, s.omega_B + 0.05 * noise()}; };
  EXPECT_THAT(gradeOfLog(logOf(faint)).notes, IsEmpty());
}

/// The body loses energy. The engine logs as omega the rate at which its attitude turns.
TEST(GradeConvention, AcceptsTheTurningRateAsOmegaWithDissipation) {
  physics::Forcing forcing;
  forcing.dissipation = 0.03;
  const physics::DrivenMotion motion(physics::PrincipalMoments(kLoggedMoments), kLoggedStart.omega_B,
                                     kLoggedStart.q_WB, forcing, {0, 30});
  const auto rate = [&](const RigidBodyState& s) {
    const Vector3d m = kLoggedMoments.cwiseProduct(s.omega_B);
    return Vector3d(s.omega_B + forcing.dissipation * m.cross(s.omega_B));
  };
  const std::string consistent = logOf(motion, [&](const auto& s) { return LogRow{s.t_s, s.q_WB, rate(s)}; });
  const Grade engine = grade(motion, parseTrajectoryTable(consistent, "theirs.csv"));
  EXPECT_GT(engine.quantity("omega_B").errors->largest, 1e-2);
  EXPECT_THAT(engine.notes, ElementsAre(StartsWith("fits if omega is the rate at which the attitude turns (")));
  EXPECT_LE(largestLeft(engine), 1e-14);  // measured 3e-16

  std::string named = consistent;
  named.replace(named.find("omega_B_x"), 29, "rate_B_x,rate_B_y,rate_B_z");
  const std::size_t end = named.find('\n');
  EXPECT_EQ(named.substr(0, end), "t,q_w,q_x,q_y,q_z,rate_B_x,rate_B_y,rate_B_z");
  const Grade byName = grade(motion, parseTrajectoryTable(named, "theirs.csv"));
  EXPECT_LE(byName.quantity("rate_B").errors->largest, 1e-15);
  EXPECT_THAT(byName.notes, IsEmpty());
}

TEST(GradeText, EndsEachNoteWithOnePunctuationMark) {
  Grade grade = gradeOfLog(logOf(asItIs));
  grade.notes = {"is it so?", "it is so"};
  EXPECT_THAT(gradeTable(grade), HasSubstr("Note: is it so?\nNote: it is so.\n"));
}

TEST(GradeText, JsonContainsTheCausesAndTheFittedGrade) {
  const auto json = nlohmann::json::parse(gradeJson(gradeOfLog(logOf(later(0.5))), "theirs.csv", "s"));
  EXPECT_EQ(json.at("fits").at("causes")[0].at("if"), "t is 0.5 s later");
  const auto& fitted = json.at("fits").at("quantities");
  EXPECT_LE(fitted.at("attitude").at("largest").get<double>(), 2e-15);               // measured 2.3e-16
  EXPECT_GT(json.at("quantities").at("attitude").at("largest").get<double>(), 0.1);  // error before the fit
  EXPECT_TRUE(nlohmann::json::parse(gradeJson(gradeOfLog(logOf(asItIs)), "a", "s")).at("fits").is_null());
}

}  // namespace
}  // namespace poinsot::reference
