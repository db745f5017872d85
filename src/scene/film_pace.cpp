// SPDX-License-Identifier: Apache-2.0
#include "scene/film_pace.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/film_clock.h"
#include "scene/heavy_top_start.h"
#include "scene/make_motion.h"

namespace poinsot::scene {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

// Above about a turn a second the eye loses the rolling, below a twelfth nothing seems to move.
constexpr double kCalmest = 0.5, kFastest = 6.5, kPleasant = 2.1;  // rad per film second
constexpr double kShortestNod_s = 0.25;   // of film: eight frames, so that a nutation is not chopped up
constexpr double kMostTurns = 5000;       // of the body in a film: each of them has to be integrated
constexpr double kLeastPrecession = 0.1;  // of a turn: a film that shows less of it shows none
constexpr double kSeen_rad = std::numbers::pi / 180;  // least angle of a cone, or a nod, that is seen

/// At which the body itself turns as the eye likes it.
double paceOfSpin(double spin) {
  return spin == 0 || (spin >= kCalmest && spin <= kFastest) ? 1.0 : kPleasant / spin;
}

bool leans(const physics::Nutation& swing) {
  return swing.mostTilt_rad > kSeen_rad && swing.leastTilt_rad < std::numbers::pi - kSeen_rad;
}

/// Of the axis of a top about the vertical; empty where it is not seen to go round.
std::optional<double> period_s(const physics::Nutation& swing) {
  const double turns = std::abs(swing.precession_rad) / kTurn;
  if (!leans(swing) || !std::isfinite(swing.period_s) || !(turns > 0)) return std::nullopt;
  const double period_s = swing.period_s / turns;
  return std::isfinite(period_s) ? std::optional(period_s) : std::nullopt;
}

/// The least pace at which the precession is seen to move, as far as nutation and spin allow; 0 where there is
/// none, and where the body turns so fast that no film could show it.
double paceOfPrecession(const Scene& scene) {
  const auto top = nearlyHeavyTopStart(scene);
  if (!top) return 0;
  const physics::Nutation swing = top->nutation();
  const auto round_s = period_s(swing);
  if (!round_s) return 0;
  double pace = kCalmest * *round_s / kTurn;
  if (swing.mostTilt_rad - swing.leastTilt_rad > kSeen_rad) pace = std::min(pace, swing.period_s / kShortestNod_s);
  const double film_s = scene.time.duration_s, most = kMostTurns * kTurn / (scene.motion.omega_B.norm() * film_s);
  return most * film_s < kLeastPrecession * *round_s ? 0 : std::min(pace, most);
}

/// The key that is to be changed, where one is given.
const char* pathOfPace(const Scene& scene, const Findings& findings) {
  return !scene.time.speed && findings.has("time.duration") ? "time.duration" : "time.speed";
}

}  // namespace

double automaticPace(const Scene& scene) {
  return std::max(paceOfSpin(scene.motion.omega_B.norm()), paceOfPrecession(scene));
}

std::optional<double> precessionPeriod_s(const Scene& scene) {
  const auto top = nearlyHeavyTopStart(scene);
  return top ? period_s(top->nutation()) : std::nullopt;
}

void doubtPrecession(const Scene& scene, Findings& findings) {
  const auto round_s = precessionPeriod_s(scene);
  const double speed = chosenSpeed(scene), film_s = scene.time.duration_s;
  const double played_s = FilmClock(0, speed, scene.timeline).played_s(film_s);
  if (!round_s || speed == 0 || !(played_s > 0)) return;  // a film of one instant is meant so
  const double turns = std::abs(speed) * played_s / *round_s;
  if (turns >= kLeastPrecession) return;
  findings.doubt(
      pathOfPace(scene, findings),
      fmt::format("the film shows {:.2g} of a turn of the top's precession, which goes round once in {:.3g} "
                  "s; time.speed = {:.2g} shows a whole turn in these {:g} s of film",
                  turns, *round_s, std::copysign(*round_s / played_s, speed), film_s));
}

}  // namespace poinsot::scene
