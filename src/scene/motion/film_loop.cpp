// SPDX-License-Identifier: Apache-2.0
#include "scene/motion/film_loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "physics/closed_motion.h"
#include "physics/double_double.h"
#include "scene/limits.h"
#include "scene/motion/make_motion.h"

namespace poinsot::scene {
namespace {

void checkCanRepeat(const Scene& scene, double speed) {
  if (!scene.motion.forcing.none())
    throw core::sceneError(
        "something acts on the body, so its motion never repeats exactly: only free motion can be made to repeat");
  if (std::ranges::any_of(scene.views,
                          [&](const View& view) { return movesAlong(scene.motion, view.camera, view.show); }))
    throw core::sceneError(
        "a thrown body does not return to its starting point; with show.flight = false the picture follows the "
        "centre of mass and can repeat");
  if (speed == 0) throw core::sceneError("nothing moves at speed 0: there is no period");
}

double framesOf(const Time& time, double period_s, double speed, const Limits& limits) {
  const double film_s = period_s / std::abs(speed), frames = std::max(1.0, std::round(film_s * time.fps.value()));
  if (frames > static_cast<double>(limits[Limit::kFrames]) ||
      film_s > static_cast<double>(limits[Limit::kDuration]))
    throw core::sceneError(
        fmt::format("the motion repeats after {:.4g} s at the earliest, which is {:.4g} s of film or {} frames, "
                    "more than a film may have; use a time.speed of {:.2g} or more",
                    period_s, film_s, frames, std::abs(speed) * film_s / time.duration_s));
  return frames;
}

/// Returns a duration with exactly this number of frames. Frame k is shown if k/fps < duration
/// (core/frame_clock.h). Therefore the result must not be rounded up.
double durationOf(double frames, const core::Rational& fps) {
  const double seconds = frames * static_cast<double>(fps.den);
  const double duration_s = seconds / static_cast<double>(fps.num);
  const auto product = physics::twoProduct(duration_s, static_cast<double>(fps.num));
  const bool isExact = product.hi == seconds && product.lo == 0;
  return isExact ? duration_s : std::nextafter(duration_s, 0.0);
}

}  // namespace

void closeLoop(Scene& scene, const Limits& limits) {
  const double speed = chosenSpeed(scene);
  checkCanRepeat(scene, speed);
  const Eigen::Vector3d drawn_P = drawnOmega_P(scene);
  const auto closed =
      physics::nearestClosedStart(scene.body.axes.moments(), drawn_P, std::abs(speed) * scene.time.duration_s);
  Loop loop;
  loop.durationAsked_s = scene.time.duration_s;
  loop.speedAsked = speed;
  loop.period_s = closed.period_s;
  loop.polhodePeriods = closed.polhodePeriods;
  loop.turns = closed.turns;
  loop.turned_rad = closed.turned_rad;
  loop.change = drawn_P.isZero(0) ? 0 : closed.change / drawn_P.norm();
  loop.mismatch_rad = closed.mismatch_rad;
  const double frames = framesOf(scene.time, closed.period_s, speed, limits);
  scene.time.duration_s = durationOf(frames, scene.time.fps);
  scene.time.speed = std::copysign(closed.period_s / (frames / scene.time.fps.value()), speed);
  scene.motion.omega_B = scene.body.axes.toB(undrawnOmega_P(scene, closed.omega0_P));
  scene.time.loop = loop;
}

}  // namespace poinsot::scene
