// SPDX-License-Identifier: Apache-2.0
#include "scene/motion/film_loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "physics/closed_motion.h"
#include "physics/double_double.h"
#include "scene/limits.h"
#include "scene/motion/film_clock.h"
#include "scene/motion/heavy_top_start.h"
#include "scene/motion/make_motion.h"
#include "scene/motion/place_timeline.h"

namespace poinsot::scene {
namespace {

void checkCanRepeat(const Scene& scene, double speed) {
  if (std::ranges::any_of(scene.views,
                          [&](const View& view) { return movesAlong(scene.motion, view.camera, view.show); }))
    throw core::sceneError(
        "a thrown body does not return to its starting point; with show.flight = false the picture follows the "
        "centre of mass and can repeat");
  if (scene.motion.rolling)
    throw core::sceneError(
        "the loop of a rolling cone is not computed; leave out the loop, and choose time.duration so that the "
        "film "
        "ends where it begins");
  if (scene.show.exaggerateAngles != 1 && !(scene.plots.empty() && scene.readouts.empty()))
    throw core::sceneError(
        "the motion with exaggerated angles repeats, but plots and read-outs show the true motion, which does "
        "not; "
        "leave out time.loop, show.exaggerate_angles, or the plots and read-outs");
  if (speed == 0) throw core::sceneError("nothing moves at speed 0: there is no period");
}

void checkPaces(const FilmClock& clock, double duration_s) {
  constexpr double kSame = 1e-9;
  const double first = clock.pace(0), last = clock.pace(duration_s);
  if (std::abs(first - last) > kSame)
    throw core::sceneError(fmt::format(
        "the film begins with timeline speed {:g} and ends with {:g}; at the end, return to the speed of the "
        "beginning",
        first, last));
}

/// Returns the angle between the attitudes at the two ends of a period.
double mismatch_rad(const Scene& scene, double period_s) {
  const auto motion = makeMotion(scene, 0, period_s);
  return motion->at(0).q_WB.angularDistance(motion->at(period_s).q_WB);
}

physics::ClosedStart closedTop(const Scene& scene, double wanted_s) {
  const auto start = heavyTopStart(scene);
  if (!start)
    throw core::sceneError(
        "something acts on the body, so its motion never repeats exactly: only free motion and the steady "
        "precession of "
        "a top can be made to repeat");
  if (start->uneven > 0 || start->top.nutationKind(start->omega_P, start->up_P) != physics::NutationKind::kSteady)
    throw core::sceneError(
        "a top repeats only in steady precession, and the axis of this one nods; give motion.precession");
  const physics::Nutation swing = start->nutation();
  const auto closed =
      start->top.nearestClosedPrecession(start->tilt_rad(), swing.precession_rad / swing.period_s, wanted_s);
  const Eigen::Vector3d omega_P = start->top.omegaPrecessing(start->up_P, closed.spin, closed.precession);
  const double turned_rad = std::atan2(omega_P.cross(start->omega_P).norm(), omega_P.dot(start->omega_P));
  Scene changed = scene;
  changed.motion.omega_B = scene.body.axes.toB(omega_P);
  return {omega_P,
          closed.period_s,
          0,
          closed.turns,
          (omega_P - start->omega_P).norm(),
          turned_rad,
          mismatch_rad(changed, closed.period_s)};
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

/// Fits duration and speed to a period. A film whose timeline changes the speed keeps its duration, because the
/// times of the timeline refer to it.
void fitFilm(Scene& scene, const FilmClock& clock, double period_s, const Limits& limits) {
  Time& time = scene.time;
  const double frames = clock.changes() ? std::max(1.0, std::round(time.duration_s * time.fps.value()))
                                        : framesOf(time, period_s, clock.speed(), limits);
  time.duration_s = durationOf(frames, time.fps);
  const double played_s = clock.played_s(frames / time.fps.value());
  time.speed = std::copysign(period_s / played_s, clock.speed());
}

/// Places the timeline in the fitted film. Entries at events move with the speed, and the speed follows from the
/// timeline, so both are repeated until nothing changes.
void fitEvents(Scene& scene, double period_s, const Limits& limits) {
  constexpr int kMostRounds = 50;
  for (int round = 0; round < kMostRounds; ++round) {
    for (const MomentProblem& problem : placeTimeline(scene))
      throw core::sceneError(fmt::format("timeline[{}]: {}", problem.place, problem.message));
    const std::optional<double> before = scene.time.speed;
    fitFilm(scene, FilmClock(0, *before, scene.timeline), period_s, limits);
    if (scene.time.speed == before) return;
  }
}

}  // namespace

void closeLoop(Scene& scene, const Limits& limits) {
  const double speed = chosenSpeed(scene);
  checkCanRepeat(scene, speed);
  const FilmClock clock(0, speed, scene.timeline);
  if (clock.changes()) checkPaces(clock, scene.time.duration_s);
  const Eigen::Vector3d drawn_P = drawnOmega_P(scene);
  const double wanted_s = std::abs(clock.motionTime_s(scene.time.duration_s));
  const auto closed = scene.motion.forcing.none()
                          ? physics::nearestClosedStart(scene.body.axes.moments(), drawn_P, wanted_s)
                          : closedTop(scene, wanted_s);
  Loop loop;
  loop.durationAsked_s = scene.time.duration_s;
  loop.speedAsked = speed;
  loop.period_s = closed.period_s;
  loop.polhodePeriods = closed.polhodePeriods;
  loop.turns = closed.turns;
  loop.turned_rad = closed.turned_rad;
  loop.change = drawn_P.isZero(0) ? 0 : closed.change / drawn_P.norm();
  loop.mismatch_rad = closed.mismatch_rad;
  if (const auto top = heavyTopStart(scene)) loop.spinAsked = top->spin();
  scene.motion.omega_B = scene.body.axes.toB(undrawnOmega_P(scene, closed.omega0_P));
  fitFilm(scene, clock, closed.period_s, limits);
  fitEvents(scene, closed.period_s, limits);
  scene.time.loop = loop;
}

}  // namespace poinsot::scene
