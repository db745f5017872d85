// SPDX-License-Identifier: Apache-2.0
// The pace of a film and what it shows of a heavy top. Expected values: closed forms of steady precession (Landau
// & Lifshitz, Mechanics, section 35), and the integrated motion, whose axis is followed round the vertical.
#include "scene/motion/film_pace.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "scene/motion/make_motion.h"
#include "scene_testing.h"

namespace poinsot::scene {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

constexpr double kTurn = 2 * std::numbers::pi;

// A toy gyroscope (D. Giancoli, Physics, chapter on rotation): a disc of 170 g and 5.5 cm on an arm of 10.5 cm,
// with 45 turns a second, released level. By hand it precesses slowly at M g l/(I3 omega_3) = 2.40618 rad/s,
// 2.6113 s a turn.
const std::string kGyroscope =
    "[body]\nshape = 'disc'\nradius = '5.5 cm'\nmass = '170 g'\npivot = [0, 0, '-10.5 cm']\n"
    "[motion]\nspin = '45 rev/s'\nspin_axis = 3\norientation = [1, 1, 0, 0]\n[motion.gravity]\ng = 9.8\n";
constexpr double kGyroscopePeriod_s = 2.6113;

/// Returns a top of I1 = 2 and I3 = 1 kg m², M g l = 3 N m, that leans by `tilt_deg` and spins about its axis
/// alone.
std::string top(double tilt_deg, double spin, const std::string& more = "") {
  const double half = tilt_deg / 2 * std::numbers::pi / 180;
  return fmt::format(
             "[body]\nprincipal_moments = [2, 2, 1]\n[motion]\nomega_body = [0, 0, {}]\norientation = [{}, {}, 0, "
             "0]\n"
             "gravity.mgr_body = [0, 0, 3]\n",
             spin, std::cos(half), std::sin(half)) +
         more;
}

Scene sceneOf(const std::string& text) { return parseScene(text, "test.toml"); }

double periodOf(const std::string& text) { return precessionPeriod_s(sceneOf(text)).value_or(0); }

std::string doubts(const std::string& text) {
  std::string lines;
  for (const Doubt& doubt : sceneOf(text).doubts) lines += toString(doubt) + "\n";
  return lines;
}

/// Returns the turns of the body's z axis about the vertical in a time, from the integrated motion.
double turnsOf(const Scene& scene, double time_s) {
  constexpr int kSteps = 20000;
  const auto motion = makeMotion(scene, 0, time_s);
  double turned = 0;
  Vector3d before = motion->at(0).q_WB * Vector3d::UnitZ();
  for (int i = 1; i <= kSteps; ++i) {
    const Vector3d axis = motion->at(time_s * i / kSteps).q_WB * Vector3d::UnitZ();
    turned += std::atan2(before.x() * axis.y() - before.y() * axis.x(), before.head<2>().dot(axis.head<2>()));
    before = axis;
  }
  return turned / kTurn;
}

// A force of 1 N at 4 m turns a body of 400 kg m² at the rate sqrt(4/400) = 0.1 rad/s, and the pace is 2.1/0.1.
TEST(FilmPace, FollowsForcesOnABodyAtRest) {
  const std::string rest = "body.principal_moments=[400, 300, 200]\nmotion.omega_body=[0, 0, 0]\n";
  EXPECT_NEAR(automaticPace(sceneOf(rest + "[[motion.force]]\nat=[0, 4, 0]\nspace=[0, 0, 1]\n")), 21, 1e-12);
  EXPECT_EQ(automaticPace(sceneOf(rest + "[[motion.force]]\nat=[0, 4, 0]\nspace=[0, 0, 100]\n")), 1);
}

// I1 cos(60 deg) W² - I3 omega_3 W + M g l = 0 with W = 0.5 rad/s gives omega_3 = 6.5 rad/s, by hand.
TEST(PrecessionPeriod, MatchesSteadyPrecession) {
  const double W = 0.5, root = std::sqrt(0.75);
  const Scene scene =
      sceneOf(fmt::format("[body]\nprincipal_moments = [2, 2, 1]\n[motion]\nomega_body = [0, {}, 6.5]\n"
                          "orientation = [{}, 0.5, 0, 0]\ngravity.mgr_body = [0, 0, 3]\n",
                          W * root, root));
  ASSERT_TRUE(precessionPeriod_s(scene));
  EXPECT_NEAR(*precessionPeriod_s(scene) / (kTurn / W), 1, 1e-8);  // measured 2e-16; half the digits are promised
}

// Released at rest, the axis nods below the level and precesses a little less than 1 % slower than steadily.
TEST(PrecessionPeriod, MatchesTheTextbookForAGyroscope) {
  EXPECT_NEAR(periodOf(kGyroscope) / kGyroscopePeriod_s, 1, 0.01);  // measured 1.0086
}

// Twenty turns are counted along the integrated motion. They may end at any moment of a nod. Measured: 3e-5, 5e-4,
// 5e-4.
TEST(PrecessionPeriod, MatchesTheIntegratedMotion) {
  const std::pair<std::string, double> cases[] = {{kGyroscope, 1e-3}, {top(40, 12), 2e-3}, {top(120, 9), 2e-3}};
  for (const auto& [text, tolerance] : cases) {
    const Scene scene = sceneOf(text);
    const double period_s = precessionPeriod_s(scene).value();
    EXPECT_NEAR(std::abs(turnsOf(scene, 20 * period_s)) / 20, 1, tolerance) << text;
  }
}

TEST(PrecessionPeriod, IsEstimatedForATopThatIsNearlySymmetric) {
  const std::string start = "[motion]\nomega_body = [0, 0, 20]\norientation = [0.9, 0.4, 0, 0]\n";
  const std::string uneven = start + "gravity.mgr_body = [0, 0, 3]\n[body]\nprincipal_moments = [2, 2.4, 1]\n";
  const std::string oblique = start + "gravity.mgr_body = [0.3, 0, 3]\n[body]\nprincipal_moments = [2, 2, 1]\n";
  for (const std::string& text : {uneven, oblique}) {
    const Scene scene = sceneOf(text);
    const double period_s = precessionPeriod_s(scene).value();
    EXPECT_NEAR(std::abs(turnsOf(scene, 5 * period_s)) / 5, 1, 0.01) << text;  // measured 4e-4
  }
  EXPECT_EQ(periodOf(uneven + "[motion.drag]\nrate = 0.01\n"), periodOf(uneven));
}

TEST(PrecessionPeriod, IsAbsentWithoutVisiblePrecession) {
  EXPECT_EQ(periodOf(top(0.5, 40)), 0);    // sleeps
  EXPECT_EQ(periodOf(top(179.5, 40)), 0);  // hangs
  EXPECT_EQ(periodOf(top(40, 0)), 0);      // a pendulum
  EXPECT_EQ(periodOf(top(40, 9, "torque.body = [0, 0, 1]\n")), 0);
  EXPECT_EQ(periodOf("[body]\nprincipal_moments = [2, 2, 1]\n[motion]\nomega_body = [0, 1, 9]\n"), 0);
}

// A hanging box swings by its weight, for any moments across the vertical. It does not precess like a top.
TEST(PrecessionPeriod, IsAbsentForAHangingAsymmetricBody) {
  const std::string hung =
      "[body]\nprincipal_moments = [2, 2.8, 1]\n[motion]\nomega_body = [0.1, 0, 0.2]\norientation = [1, 0, 0, 0]\n"
      "gravity.mgr_body = [0, 0, -3]\n";
  EXPECT_EQ(periodOf(hung), 0);
}

// Small swings of a pendulum have sqrt(M g l/I) = sqrt(0.03/2.8) = 0.10 rad/s and sqrt(300/2.8) = 10.4 rad/s, for
// any release.
TEST(DefaultSpeed, FollowsTheSwingOfAHangingBody) {
  const auto paceOf = [](double weight, double spin) {
    return chosenSpeed(
        sceneOf(fmt::format("[body]\nprincipal_moments = [2, 2.8, 1]\n[motion]\n"
                            "omega_body = [{}, 0, 0]\norientation = [0.6, 0.8, 0, 0]\n"
                            "gravity.mgr_body = [0, 0, {}]\n",
                            spin, -weight)));
  };
  for (const double spin : {1e-9, 1e-3}) {
    EXPECT_NEAR(paceOf(0.03, spin), 2.1 / std::sqrt(0.03 / 2.8), 1e-12);  // measured 0
    EXPECT_NEAR(paceOf(300, spin), 2.1 / std::sqrt(300 / 2.8), 1e-14);    // measured 0
    EXPECT_EQ(paceOf(3, spin), 1);
  }
}

// The film shows 0.5 rad of precession per second, 0.8 turns in its ten seconds.
TEST(DefaultSpeed, ShowsHalfARadianOfPrecessionPerSecond) {
  const Scene scene = sceneOf(kGyroscope);
  EXPECT_NEAR(chosenSpeed(scene) / (0.5 * kGyroscopePeriod_s / kTurn), 1, 0.01);    // measured 1.0086
  EXPECT_NEAR(std::abs(turnsOf(scene, 10 * chosenSpeed(scene))), 5 / kTurn, 0.02);  // measured 0.7854
}

TEST(DefaultSpeed, FollowsTheSpinIfPrecessionIsFastOrAbsent) {
  EXPECT_EQ(chosenSpeed(sceneOf(top(40, 6))), 1);           // goes round in 11 s
  EXPECT_EQ(chosenSpeed(sceneOf(top(0.5, 40))), 2.1 / 40);  // sleeps
  EXPECT_EQ(chosenSpeed(sceneOf(top(40, 0))), 1);
  EXPECT_EQ(chosenSpeed(sceneOf(top(40, 12, "[time]\nspeed = 3\n"))), 3);
}

TEST(DefaultSpeed, FollowsTheSpinInFreeMotion) {
  const auto paceOf = [](double spin) {
    return chosenSpeed(
        sceneOf(fmt::format("body.principal_moments = [2, 2, 1]\nmotion.omega_body = [0, 0, {}]\n", spin)));
  };
  EXPECT_EQ(paceOf(0.5), 1);
  EXPECT_EQ(paceOf(6.5), 1);
  EXPECT_EQ(paceOf(0.25), 2.1 / 0.25);
  EXPECT_EQ(paceOf(8), 2.1 / 8);
}

// A film shows at most 5000 turns of the body. At 200 rad/s this top turns 200²/3 times in one precession of 2 pi
// I3 omega_3/(M g l), of which the film shows three eighths. At 400 rad/s the film would show less than a tenth,
// and follows the spin instead.
TEST(DefaultSpeed, ShowsAtMost5000TurnsOfAFastTop) {
  EXPECT_NEAR(chosenSpeed(sceneOf(top(40, 200))) * 200 / kTurn * 10, 5000, 1e-9);
  EXPECT_NEAR(chosenSpeed(sceneOf(top(40, 200, "[time]\nduration = 40\n"))) * 200 / kTurn * 40, 5000, 1e-9);
  EXPECT_EQ(chosenSpeed(sceneOf(top(40, 400))), 2.1 / 400);
}

// Tops at 180 and 400 rad/s precess once in 2 pi 180/3 = 376.99 s and 2 pi 400/3 = 837.76 s, in which the body
// turns 180²/3 and 400²/3 times.
TEST(SceneNotes, SuggestNoSpeedThatShowsTooManyTurns) {
  EXPECT_EQ(doubts(top(40, 200)), "");
  EXPECT_THAT(
      doubts(top(40, 180, "[time]\nspeed = 1\n")),
      HasSubstr("goes round once in 377 s; time.speed = 17.5 shows 0.46 of a turn in these 10 s of film\n"));
  EXPECT_EQ(doubts(top(40, 400)),
            "test.toml:1:1: note: time.speed: the film shows 6.3e-05 of a turn of the top's precession, which "
            "goes round once in 838 s; the body turns 5.3e+04 times in this period, but one film shows at most "
            "5000 turns; give a smaller spin\n");
}

// A fast top nods once in 2 pi I1/(I3 omega_3), by about 2 I1 M g l sin(theta)/(I3 omega_3)² (Landau & Lifshitz,
// section 35, problem 3): by a visible 1.4 deg at 22 rad/s, by 0.4 deg at 40 rad/s.
TEST(DefaultSpeed, ShowsVisibleNutationInAQuarterOfASecond) {
  EXPECT_NEAR(chosenSpeed(sceneOf(top(90, 22))) / (kTurn * 2 / 22 / 0.25), 1, 0.005);  // measured 0.9995
  EXPECT_NEAR(chosenSpeed(sceneOf(top(90, 40))) / (0.5 / (3.0 / 40)), 1, 0.005);       // measured 1.00003
}

TEST(SceneNotes, WarnAboutAFilmWithHardlyAnyPrecession) {
  const std::string brief = kGyroscope + "[time]\nspeed = 0.0074\n";
  EXPECT_EQ(doubts(kGyroscope), "");
  EXPECT_EQ(
      doubts(brief),
      "test.toml:13:9: note: time.speed: the film shows 0.028 of a turn of the top's precession, which goes round "
      "once in 2.63 s; time.speed = 0.263 shows a whole turn in these 10 s of film\n");
  EXPECT_THAT(doubts(kGyroscope + "[time]\nspeed = -0.0074\n"), HasSubstr("time.speed = -0.263 shows"));
  EXPECT_THAT(doubts(kGyroscope + "[time]\nduration = 0.5\n"),
              testing::AllOf(HasSubstr("test.toml:13:12: note: time.duration: the film shows 0.04 of a turn"),
                             HasSubstr("time.speed = 5.27 shows a whole turn in these 0.5 s of film")));
  // The first second has a mean pace of 0.505, the other 9 s have 0.01; at speed 0.1 that is 0.0595 s of motion.
  EXPECT_THAT(doubts(kGyroscope + "[time]\nspeed = 0.1\n[[timeline]]\nat = 0\nover = 1\nspeed = 0.01\n"),
              HasSubstr("time.speed: the film shows 0.023 of a turn"));
}

TEST(SceneNotes, AreAbsentIfAFilmShowsATenthOfAPrecession) {
  const double tenth = 0.1 * periodOf(kGyroscope) / 10;
  EXPECT_EQ(doubts(kGyroscope + fmt::format("[time]\nspeed = {}\n", 1.001 * tenth)), "");
  EXPECT_NE(doubts(kGyroscope + fmt::format("[time]\nspeed = {}\n", 0.999 * tenth)), "");
  EXPECT_EQ(doubts(kGyroscope + "[time]\nspeed = 0\n"), "");  // a film of one instant is intended
  EXPECT_EQ(doubts(top(0.5, 40)), "");
  EXPECT_EQ(
      doubts("[body]\nprincipal_moments = [2, 2, 1]\n[motion]\nomega_body = [0, 1e-6, 9]\n[time]\nspeed = 1e-3"),
      "");
}

}  // namespace
}  // namespace poinsot::scene
