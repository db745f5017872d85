// SPDX-License-Identifier: Apache-2.0
// Films that repeat: the effect of time.loop on a scene, followed by the motion itself. That the start is the
// nearest one is tested in tests/physics/closed_motion_test.cpp.
#include "scene/motion/film_loop.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "scene/motion/film_clock.h"
#include "scene/motion/make_motion.h"
#include "scene_testing.h"

namespace poinsot::scene {
namespace {

using ::testing::HasSubstr;

const std::string kLoop = "[time]\nloop = true\n";

struct Body {
  const char* name;
  const char* text;
};

const Body kBodies[] = {
    {"asymmetric", "[body]\nprincipal_moments = [1, 2, 2.5]\n[motion]\nomega_body = [0.4, 1.5, 0.8]\n"},
    {"turned axes",
     "[body]\ninertia = [[2, 0.3, 0], [0.3, 3, 0.1], [0, 0.1, 4]]\n[motion]\nomega_body = [1, 2, 0.5]\n"},
    {"prolate", "[body]\nprincipal_moments = [2, 2, 1]\n[motion]\nomega_body = [0.8, 0.3, 2]\n"},
    {"oblate", "[body]\nprincipal_moments = [1, 1, 1.9]\n[motion]\nomega_body = [0.1, 0, 5]\n"},
    {"steady", "[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [0, 0, 2.2]\n"},
    {"flipping", "[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [0.01, 3, 0]\n"}};

TEST(FilmLoop, RestoresTheAttitudeAfterAllFrames) {
  for (const Body& body : kBodies) {
    SCOPED_TRACE(body.name);
    const Scene plain = parseScene(body.text, "a.toml"), loop = parseScene(body.text + kLoop, "a.toml");
    ASSERT_TRUE(loop.time.loop);
    const double frames = loop.time.duration_s * loop.time.fps.value();
    EXPECT_NEAR(frames, std::round(frames), 1e-9);
    const double period_s = std::round(frames) / loop.time.fps.value() * *loop.time.speed;
    const auto motion = makeMotion(loop, 0, period_s);
    const auto first = motion->at(0), last = motion->at(period_s);
    EXPECT_LT(first.q_WB.angularDistance(last.q_WB), 1e-12);  // measured 1.0e-14
    EXPECT_LT((first.omega_B - last.omega_B).norm(), 1e-12 * first.omega_B.norm());
    const auto L = [](const Scene& scene) {
      return scene.body.axes.moments().angularMomentum(scene.body.axes.toP(scene.motion.omega_B)).norm();
    };
    EXPECT_NEAR(L(loop) / L(plain), 1, 1e-14);
  }
}

TEST(FilmLoop, RecordsTheChangesOfRotationAndDuration) {
  const std::string text = kBodies[0].text;
  const Scene plain = parseScene(text, "a.toml"), loop = parseScene(text + kLoop, "a.toml");
  const Loop& changed = *loop.time.loop;
  const Eigen::Vector3d before = plain.motion.omega_B, after = loop.motion.omega_B;
  EXPECT_NEAR(changed.change, (after - before).norm() / before.norm(), 1e-12);
  EXPECT_NEAR(changed.turned_rad, std::acos(after.dot(before) / after.norm() / before.norm()), 1e-9);
  EXPECT_EQ(changed.speedAsked, chosenSpeed(plain));
  EXPECT_EQ(changed.durationAsked_s, plain.time.duration_s);
  EXPECT_NEAR(loop.time.duration_s * *loop.time.speed, changed.period_s, 1e-9 * changed.period_s);
  EXPECT_NEAR(*loop.time.speed / changed.speedAsked, 1, 0.01);  // changed by less than half a frame of the film
}

TEST(FilmLoop, RejectsMotionsThatDoNotRepeat) {
  const std::string free = kBodies[0].text;
  EXPECT_THAT(messagesOf(free + "[motion.drag]\nrate = 0.1\n" + kLoop, {}),
              HasSubstr("time.loop: something acts on the body, so its motion never repeats exactly"));
  const std::string exaggerated = kBodies[2].text + kLoop + "[show]\nexaggerate_angles = 2\n";
  EXPECT_EQ(messagesOf(exaggerated, {}), "");
  EXPECT_THAT(messagesOf(exaggerated + "[[readout]]\nquantity = 'omega'\n", {}),
              HasSubstr("plots and read-outs show the true motion, which does not"));
  EXPECT_THAT(messagesOf(free + kLoop + "speed = 0\n", {}), HasSubstr("time.loop: nothing moves at speed 0"));
  EXPECT_THAT(
      messagesOf("[body]\nprincipal_moments = [1, 2, 2.25]\n[motion]\nomega_body = [0.75, 0.5, 1]\n" + kLoop, {}),
      HasSubstr("separatrix"));
  EXPECT_THAT(messagesOf(free + kLoop + "[[timeline]]\nat = 2\nspeed = 0.5\n", {}),
              HasSubstr("time.loop: the film begins with timeline speed 1 and ends with 0.5"));
}

std::string topWith(const std::string& start) {
  return "[body]\nprincipal_moments = [2, 2, 1]\n[motion]\ngravity.mgr_body = [0, 0, 3]\nspin_axis = \"3\"\n" +
         start + "\n" + kLoop + "speed = 1\n";
}

// Oracle: the integrated motion. The attitude returns, and the lean stays. Measured: 5e-13, the integrator's
// error.
TEST(FilmLoop, RepeatsTheSteadyPrecessionOfATop) {
  for (const char* start :
       {"lean = 1\nspin = 9\nprecession = \"slow\"", "lean = 1\nspin = 9\nprecession = \"fast\"",
        "lean = 2\nspin = -4\nprecession = \"slow\"", "lean = \"90 deg\"\nspin = 30\nprecession = \"slow\"",
        "lean = 0.5\nprecession = 1.2"}) {
    SCOPED_TRACE(start);
    std::string text = topWith(start);
    if (text.find("spin =") == std::string::npos) text.erase(text.find("spin_axis"), 16);
    const Scene scene = parseScene(text, "a.toml");
    ASSERT_TRUE(scene.time.loop);
    const double period_s = scene.time.loop->period_s;
    const auto motion = makeMotion(scene, 0, period_s);
    const auto first = motion->at(0), last = motion->at(period_s);
    EXPECT_LT(first.q_WB.angularDistance(last.q_WB), 5e-12);
    EXPECT_LT((first.omega_B - last.omega_B).norm(), 5e-12 * first.omega_B.norm());
    EXPECT_LT(std::abs(scene.time.loop->change), 0.1);
    const auto k = [](const auto& state) { return Eigen::Vector3d(state.q_WB * Eigen::Vector3d::UnitZ()).z(); };
    for (const double part : {0.1, 0.37, 0.8}) EXPECT_NEAR(k(motion->at(part * period_s)), k(first), 1e-12);
    EXPECT_NEAR(scene.time.duration_s * *scene.time.speed, period_s, 1e-9 * period_s);
  }
}

TEST(FilmLoop, TellsThatANoddingTopDoesNotRepeat) {
  EXPECT_THAT(messagesOf(topWith("lean = 1\nspin = 9\nnutation = \"cusps\"")),
              HasSubstr("time.loop: a top repeats only in steady precession, and the axis of this one nods"));
}

// The motion time of a film is the integral of the speed, here summed over short steps. Measured: 3e-7, the error
// of the sum.
TEST(FilmLoop, KeepsSlowMotionAndDuration) {
  const std::string slow =
      kLoop + "duration = 12\n[[timeline]]\nat = 3\nspeed = 0.2\n[[timeline]]\nat = 6\nspeed = 1\n";
  const Scene scene = parseScene(kBodies[0].text + slow, "a.toml");
  EXPECT_EQ(scene.time.duration_s, 12);
  const FilmClock clock(0, *scene.time.speed, scene.timeline);
  constexpr int kSteps = 120000;
  double motion_s = 0;
  for (int i = 0; i < kSteps; ++i)
    motion_s += clock.pace((i + 0.5) * 12 / kSteps) * *scene.time.speed * 12 / kSteps;
  EXPECT_NEAR(motion_s / scene.time.loop->period_s, 1, 3e-6);
  const auto motion = makeMotion(scene, 0, 100);
  EXPECT_LT(motion->at(0).q_WB.angularDistance(motion->at(clock.motionTime_s(12)).q_WB), 1e-12);
}

}  // namespace
}  // namespace poinsot::scene
