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

// Rates of rotation that the eye can follow. Faster than about one turn a second, the rolling is not recognisable.
// Slower than a twelfth of a turn a second, nothing seems to move.
constexpr double kCalmest = 0.5, kFastest = 6.5, kPleasant = 2.1;  // rad per film second
constexpr double kShortestNod_s = 0.25;               // film time; a shorter nutation has too few frames
constexpr double kMostTurns = 5000;                   // turns of the body in one film; each must be integrated
constexpr double kLeastPrecession = 0.1;              // turns of precession; a film with fewer seems to show none
constexpr double kSeen_rad = std::numbers::pi / 180;  // smallest visible opening of a cone or nutation

/// Returns the rate at which forces at points turn a body at rest, in rad/s: sqrt(N/I), where N is the largest
/// torque that one of the forces can have, and I the largest moment.
double rateOfForces(const Scene& scene) {
  double torque = 0;
  for (const physics::PointForce& force : scene.motion.forcing.forces)
    torque = std::max(torque, force.lever_B.norm() * (force.force_B.norm() + force.force_W.norm()));
  return std::sqrt(torque / scene.body.axes.moments().values().maxCoeff());
}

/// Returns the rate of the motion in rad/s: |omega| at the start or, if larger, the frequency of small swings of
/// the hanging body or the rate of forces. For the frequency, uses its lower bound sqrt(M g l/I), where I is the
/// largest moment.
double rateOfMotion(const Scene& scene) {
  const double swing =
      std::sqrt(scene.motion.forcing.gravity_B.norm() / scene.body.axes.moments().values().maxCoeff());
  return std::max({scene.motion.omega_B.norm(), swing, rateOfForces(scene)});
}

double paceOfMotion(double rate) {
  return rate == 0 || (rate >= kCalmest && rate <= kFastest) ? 1.0 : kPleasant / rate;
}

bool leans(const physics::Nutation& swing) {
  return swing.mostTilt_rad > kSeen_rad && swing.leastTilt_rad < std::numbers::pi - kSeen_rad;
}

/// Returns the time in which the axis rotates once about the vertical. Empty if this rotation is not visible.
std::optional<double> period_s(const physics::Nutation& swing) {
  const double turns = std::abs(swing.precession_rad) / kRevolution;
  if (!leans(swing) || !std::isfinite(swing.period_s) || !(turns > 0)) return std::nullopt;
  const double period_s = swing.period_s / turns;
  return std::isfinite(period_s) ? std::optional(period_s) : std::nullopt;
}

/// Returns the largest number of turns of precession that one film can show, in which the body makes kMostTurns.
/// @param round_s  period of the precession
double mostShown(const Scene& scene, double round_s) {
  return kMostTurns * kRevolution / (scene.motion.omega_B.norm() * round_s);
}

/// Returns the smallest pace at which the precession is visible. The pace is smaller if the nutation or the spin
/// would otherwise be too fast. Returns 0 without precession, or if the spin is too fast for any film to show it.
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
        "the body turns {:.2g} times in this period, but one film shows at most {:g} turns; give a smaller spin",
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
  if (!round_s || speed == 0 || !(played_s > 0)) return;  // the user intends a film that shows one instant
  const double turns = std::abs(speed) * played_s / *round_s;
  if (turns >= kLeastPrecession) return;
  findings.doubt(
      pathOfPace(scene, findings),
      fmt::format("the film shows {:.2g} of a turn of the top's precession, which goes round once in {:.3g} s; {}",
                  turns, *round_s, remedy(scene, *round_s, std::copysign(played_s, speed))));
}

void doubtForces(const Scene& scene, Findings& findings) {
  const double from_s = scene.time.start_s;
  const double to_s = FilmClock(from_s, chosenSpeed(scene), scene.timeline).motionTime_s(scene.time.duration_s);
  const double first_s = std::min({0.0, from_s, to_s}), last_s = std::max({0.0, from_s, to_s});
  const auto& forces = scene.motion.forcing.forces;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const bool early = forces[i].to_s <= first_s;
    if (!early && forces[i].from_s < last_s) continue;
    findings.doubt(
        fmt::format("motion.force[{}].{}", i, early ? "to" : "from"),
        fmt::format("the force {} at {:g} s, so it never acts: the film shows the motion from {:g} s to "
                    "{:g} s, and the start is given at 0 s",
                    early ? "ends" : "begins", early ? forces[i].to_s : forces[i].from_s, from_s, to_s));
  }
}

}  // namespace poinsot::scene
