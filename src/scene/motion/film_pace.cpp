// SPDX-License-Identifier: Apache-2.0
#include "scene/motion/film_pace.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/motion/film_clock.h"
#include "scene/motion/heavy_top_start.h"
#include "scene/motion/make_motion.h"

namespace poinsot::scene {
namespace {

constexpr double kRevolution = 2 * std::numbers::pi;

// Above about a turn a second the eye loses the rolling; below a twelfth nothing seems to move.
constexpr double kCalmest = 0.5, kFastest = 6.5, kPleasant = 2.1;  // rad per film second
constexpr double kShortestNod_s = 0.25;               // film time; a shorter nutation gets too few frames
constexpr double kMostTurns = 5000;                   // turns of the body in one film; each must be integrated
constexpr double kLeastPrecession = 0.1;              // turns; a film that shows less seems to show no precession
constexpr double kSeen_rad = std::numbers::pi / 180;  // smallest visible angle of a cone or a nod

/// Returns the body's rate in rad/s: the larger of its spin at the start and the rate of small swings about
/// hanging, at least sqrt(M g l/I) with I the largest moment.
double rateOfMotion(const Scene& scene) {
  const double swing =
      std::sqrt(scene.motion.forcing.gravity_B.norm() / scene.body.axes.moments().values().maxCoeff());
  return std::max(scene.motion.omega_B.norm(), swing);
}

double paceOfMotion(double rate) {
  return rate == 0 || (rate >= kCalmest && rate <= kFastest) ? 1.0 : kPleasant / rate;
}

bool leans(const physics::Nutation& swing) {
  return swing.mostTilt_rad > kSeen_rad && swing.leastTilt_rad < std::numbers::pi - kSeen_rad;
}

/// Returns the period of the axis about the vertical; empty if the axis is not seen to go round.
std::optional<double> period_s(const physics::Nutation& swing) {
  const double turns = std::abs(swing.precession_rad) / kRevolution;
  if (!leans(swing) || !std::isfinite(swing.period_s) || !(turns > 0)) return std::nullopt;
  const double period_s = swing.period_s / turns;
  return std::isfinite(period_s) ? std::optional(period_s) : std::nullopt;
}

/// Returns the largest number of precession turns in one film, limited by kMostTurns of the body.
double mostShown(const Scene& scene, double round_s) {
  return kMostTurns * kRevolution / (scene.motion.omega_B.norm() * round_s);
}

/// Returns the least pace at which the precession is visible, as far as nutation and spin allow. Returns 0 if
/// there is no precession, or if the body spins too fast for one film to show it.
double paceOfPrecession(const Scene& scene) {
  const auto top = nearlyHeavyTopStart(scene);
  if (!top) return 0;
  const physics::Nutation swing = top->nutation();
  const auto round_s = period_s(swing);
  if (!round_s) return 0;
  double pace = kCalmest * *round_s / kRevolution;
  if (swing.mostTilt_rad - swing.leastTilt_rad > kSeen_rad) pace = std::min(pace, swing.period_s / kShortestNod_s);
  const double shown = mostShown(scene, *round_s);
  return shown < kLeastPrecession ? 0 : std::min(pace, shown * *round_s / scene.time.duration_s);
}

/// Returns advice for a film that shows too little of the precession.
/// @param played_s  motion time that the film shows at speed 1; negative for a film that runs backwards
std::string remedy(const Scene& scene, double round_s, double played_s) {
  const double shown = std::min(mostShown(scene, round_s), 1.0);
  if (shown < kLeastPrecession)
    return fmt::format(
        "the body turns {:.2g} times meanwhile, and one film shows at most {:g} of its turns; give a "
        "smaller spin",
        scene.motion.omega_B.norm() * round_s / kRevolution, kMostTurns);
  return fmt::format("time.speed = {:.3g} shows {} in these {:g} s of film", shown * round_s / played_s,
                     shown < 1 ? fmt::format("{:.2g} of a turn", shown) : "a whole turn", scene.time.duration_s);
}

const char* pathOfPace(const Scene& scene, const Findings& findings) {
  return !scene.time.speed && findings.has("time.duration") ? "time.duration" : "time.speed";
}

}  // namespace

double automaticPace(const Scene& scene) {
  return std::max(paceOfMotion(rateOfMotion(scene)), paceOfPrecession(scene));
}

std::optional<double> precessionPeriod_s(const Scene& scene) {
  const auto top = nearlyHeavyTopStart(scene);
  return top ? period_s(top->nutation()) : std::nullopt;
}

void doubtPrecession(const Scene& scene, Findings& findings) {
  const auto round_s = precessionPeriod_s(scene);
  const double speed = chosenSpeed(scene), film_s = scene.time.duration_s;
  const double played_s = FilmClock(0, speed, scene.timeline).played_s(film_s);
  if (!round_s || speed == 0 || !(played_s > 0)) return;  // a film of one instant is intentional
  const double turns = std::abs(speed) * played_s / *round_s;
  if (turns >= kLeastPrecession) return;
  findings.doubt(
      pathOfPace(scene, findings),
      fmt::format("the film shows {:.2g} of a turn of the top's precession, which goes round once in {:.3g} s; {}",
                  turns, *round_s, remedy(scene, *round_s, std::copysign(played_s, speed))));
}

}  // namespace poinsot::scene
