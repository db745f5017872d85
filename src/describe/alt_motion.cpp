// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "describe/alt_sections.h"
#include "describe/language.h"
#include "physics/heavy_top.h"
#include "physics/herpolhode.h"
#include "physics/polhode.h"
#include "physics/precession_cones.h"
#include "physics/stability.h"
#include "scene/motion/make_motion.h"

namespace poinsot::describe {
namespace {

using physics::PolhodeRegime;

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kLeastTilt_rad = 1e-9;  // with a smaller angle, the axis and L look like one line
constexpr int kLongestClosure = 100;     // most swings after which a herpolhode counts as closed
constexpr double kClosure_rad = 1e-9;    // tolerance for a closed herpolhode, as in `info`

std::string spinWords(const scene::Scene& scene) { return turningWords(scene.motion.omega_B.norm()); }

std::string whereLPoints(const scene::Scene& scene) {
  if (scene.motion.orientation_WB) return "";
  return scene::verticalOfL(scene) == physics::Vertical::kDown ? say(": in space it points straight down")
                                                               : say(": in space it points straight up");
}

std::string constancyOfL(const scene::Scene& scene) {
  const double L = scene::makeMotion(scene, 0, 0)->at(0).L_W.norm();
  const bool falls = scene.motion.flight && !scene.motion.flight->gravity_W.isZero(0);
  return say("{}, so its angular momentum L{}, of {} kg m²/s, never changes{}.",
             say(falls ? "Only its weight acts on the body, at the centre of mass" : "Nothing acts on the body"),
             falls ? say(" about that point") : "", numberWords(L), whereLPoints(scene));
}

/// Describes a steady spin. A spin about the middle axis is described as unstable, because no real start is exact.
std::string steadySentence(const scene::Scene& scene) {
  const std::string text = say("It spins steadily at {}: ω keeps its size and its direction.", spinWords(scene));
  const auto found = physics::spinStability(scene.body.axes.moments(), scene::startOmega_P(scene));
  if (found.kind != physics::Stability::kUnstable) return text;
  return text + say(" But this spin, about the middle axis {}, is unstable: the smallest disturbance grows "
                    "by a factor of e every {}, until the body flips.",
                    axisName(scene::spinAxis(scene::startOmega_P(scene))), timeWords(1 / found.rate));
}

Sentences symmetricSentences(const scene::Scene& scene, const physics::PrecessionCones& cones) {
  const std::string k = axisName(cones.axis);
  const double across_rad = std::numbers::pi / 2 - cones.tilt_rad;
  if (cones.steady() || std::min(cones.tilt_rad, across_rad) < kLeastTilt_rad) return {steadySentence(scene)};
  Sentences sentences{
      say("It turns at {}, with a wobble: the symmetry axis {} leans from L by {} and goes "
          "round L once in {}, and so does ω, which makes {} with the axis.",
          spinWords(scene), k, angleWords(cones.tilt_rad), timeWords(kTurn / cones.precessionRate),
          angleWords(cones.bodyCone_rad))};
  if (std::isfinite(cones.wobblePeriod()))
    sentences.push_back(
        say("Seen from the body, ω goes round the axis once in {}, in the {} the spin. The axis, ω and "
            "L lie in one "
            "plane at every instant.",
            timeWords(cones.wobblePeriod()), say(cones.bodyRate > 0 ? "sense of" : "sense opposite to")));
  return sentences;
}

int axisOfRank(const scene::Scene& scene, std::size_t rank) {
  return scene.body.axes.moments().ascendingAxes()[rank];
}

/// Returns the axis about which the polhode runs, such as "e3, the axis of largest moment".
std::string circledAxis(const scene::Scene& scene, PolhodeRegime regime) {
  const bool smallest = regime == PolhodeRegime::kAboutSmallest;
  return say("{}, the axis of {} moment", axisName(axisOfRank(scene, smallest ? 0 : 2)),
             say(smallest ? "smallest" : "largest"));
}

std::string separatrixSentence(const scene::Scene& scene) {
  return say(
      "It starts at {} exactly on the separatrix: ω approaches the middle axis {} and never gets "
      "there, and the body turns over once.",
      rateWords(scene.motion.omega_B.norm()), axisName(axisOfRank(scene, 1)));
}

std::string flipSentence(const scene::Scene& scene, const physics::FlipTimes& flips) {
  return say(
      "Every {} the body flips: its middle axis {}, which between flips comes within {} of the line of L, swings "
      "over to the opposite direction.",
      timeWords(flips.interval_s), axisName(axisOfRank(scene, 1)), angleWords(flips.nearestToMiddle_rad));
}

std::string polhodeSentence(const scene::Scene& scene, const physics::Polhode& polhode,
                            const physics::FlipTimes& flips) {
  std::string text = say(
      "It starts at {}, and ω is not constant: once in {} its tip runs along the polhode, a closed curve in the "
      "body, round {}",
      rateWords(scene.motion.omega_B.norm()), timeWords(polhode.period()), circledAxis(scene, polhode.regime()));
  if (!flips.turnsOver)
    text += say("; that axis leans from L by {} at most",
                angleWords(std::numbers::pi / 2 - flips.nearestToMiddle_rad));
  return text + ".";
}

std::string herpolhodeSentence(const physics::Herpolhode& curve) {
  std::string text =
      say("In space the tip of ω draws the herpolhode, on the invariable plane, between {} "
          "and {} from the line of L",
          rateWords(curve.smallestRadius()), rateWords(curve.largestRadius()));
  const auto closure = curve.closure(kLongestClosure, kClosure_rad);
  if (closure)
    text += say("; it closes after {} swings, in {} turns about L and {}", closure->radialPeriods, closure->turns,
                timeWords(closure->radialPeriods * curve.radialPeriod()));
  return text + ".";
}

Sentences asymmetricSentences(const scene::Scene& scene) {
  const auto& moments = scene.body.axes.moments();
  const physics::Polhode polhode(moments, scene::startOmega_P(scene));
  if (polhode.regime() == PolhodeRegime::kSteady) return {steadySentence(scene)};
  if (polhode.regime() == PolhodeRegime::kSeparatrix) return {separatrixSentence(scene)};
  const physics::FlipTimes flips = physics::flipTimes(moments, scene::startOmega_P(scene));
  Sentences sentences{polhodeSentence(scene, polhode, flips)};
  if (flips.turnsOver) sentences.push_back(flipSentence(scene, flips));
  sentences.push_back(herpolhodeSentence(physics::Herpolhode(moments, scene::startOmega_P(scene))));
  return sentences;
}

Sentences freeSentences(const scene::Scene& scene) {
  if (scene.motion.omega_B.isZero(0)) return {say("Nothing acts on it, and it does not turn.")};
  Sentences sentences{constancyOfL(scene)};
  const auto cones = physics::precessionCones(scene.body.axes.moments(), scene::startOmega_P(scene));
  const Sentences more = cones ? symmetricSentences(scene, *cones) : asymmetricSentences(scene);
  sentences.insert(sentences.end(), more.begin(), more.end());
  return sentences;
}

std::string nutationWords(const physics::Nutation& nutation) {
  const std::string least = angleWords(nutation.leastTilt_rad), most = angleWords(nutation.mostTilt_rad);
  if (least == most) return say("keeps an angle of {} with the vertical", least);
  if (std::isinf(nutation.period_s)) return say("rises from {} towards {}", most, least);
  return say(
      "nods between {} and {} from the vertical, once in {} (nutation), and goes round the vertical "
      "by {} each time (precession)",
      least, most, timeWords(nutation.period_s), angleWords(nutation.precession_rad));
}

Sentences gravitySentences(const scene::Scene& scene, bool alone) {
  const auto& axes = scene.body.axes;
  const Eigen::Vector3d up_P = axes.toP(scene::startOrientation(scene).conjugate() * Eigen::Vector3d::UnitZ());
  Sentences sentences{
      say("Gravity pulls at the centre of mass and turns L; the vertical component of L stays constant.")};
  const auto top = physics::heavyTop(axes.moments(), axes.toP(scene.motion.forcing.gravity_B));
  if (!top || !alone) return sentences;
  sentences.push_back(say("Its axis {}.", nutationWords(top->nutation(scene::startOmega_P(scene), up_P))));
  return sentences;
}

std::string axisOfLargest(const physics::PrincipalMoments& moments) {
  const auto axis = moments.ascendingAxes();
  if (moments[axis[1]] == moments[axis[2]]) return say("an axis across {}", axisName(axis[0]));
  return say("{}, the axis of largest moment", axisName(axis[2]));
}

/// Describes the loss of energy. If nothing else acts on the body, also describes the steady spin at the end.
std::string dissipationSentence(const scene::Scene& scene, bool alone) {
  const auto& moments = scene.body.axes.moments();
  std::string text = say("It loses energy inside, but not angular momentum");
  if (!alone) return text + ".";
  const double L = moments.angularMomentum(scene::startOmega_P(scene)).norm();
  return text + say(": L, of {} kg m²/s, never changes, and the motion tends to a steady spin about {}, at {}.",
                    numberWords(L), axisOfLargest(moments), turningWords(L / moments.values().maxCoeff()));
}

std::string dragSentence(const Eigen::Vector3d& rate_P) {
  if (rate_P.minCoeff() < rate_P.maxCoeff())
    return say("Drag slows it down, about some axes more than about others.");
  return say("Drag slows its spin to 1/e in {}.", timeWords(1 / rate_P[0]));
}

/// Reports whether the torque is not zero in any step of the history.
bool acts(const physics::TorqueHistory& history) {
  return std::ranges::any_of(history.torque, [](const Eigen::Vector3d& torque) { return !torque.isZero(0); });
}

void addTorque(Sentences& sentences, const Eigen::Vector3d& torque, bool changes, const std::string& where) {
  if (changes) sentences.push_back(say("A torque that changes with time acts on it, {}.", where));
  if (torque.isZero(0)) return;
  sentences.push_back(say("A constant torque of {} N m acts on it, {}.", numberWords(torque.norm()), where));
}

std::string forceSentence(const physics::PointForce& force) {
  const std::string size = numberWords((force.force_B + force.force_W).norm());
  const std::string where = force.force_B.isZero(0) ? say("fixed in space") : say("fixed in the body");
  std::string window;
  if (std::isfinite(force.from_s)) window += say(" from {}", timeWords(force.from_s));
  if (std::isfinite(force.to_s)) window += say(" until {}", timeWords(force.to_s));
  return say("A force of {} N, {}, acts at a point of the body{}.", size, where, window);
}

Sentences rollingSentences(const physics::RollingCone& cone) {
  return {
      say("It is a cone that rolls on a level table without slipping; its apex stays at one point."),
      say("Its axis goes round the vertical once in {}, and the cone turns about the line on which it touches the "
          "table, which is at rest, at {}.",
          timeWords(2 * std::numbers::pi / std::abs(cone.rate)), rateWords(std::abs(cone.alongContact())))};
}

Sentences drivenSentences(const scene::Scene& scene) {
  if (scene.motion.rolling) return rollingSentences(scene.motion.rolling->cone);
  const physics::Forcing& forcing = scene.motion.forcing;
  Sentences sentences;
  if (!scene.motion.omega_B.isZero(0)) sentences.push_back(say("At the start it turns at {}.", spinWords(scene)));
  physics::Forcing rest = forcing;
  rest.gravity_B.setZero();
  if (!forcing.gravity_B.isZero(0))
    for (const std::string& sentence : gravitySentences(scene, rest.none())) sentences.push_back(sentence);
  addTorque(sentences, forcing.torque_B, acts(forcing.torqueHistory_B), say("fixed in the body"));
  addTorque(sentences, forcing.torque_W, acts(forcing.torqueHistory_W), say("fixed in space"));
  for (const physics::PointForce& force : forcing.forces) sentences.push_back(forceSentence(force));
  if (!forcing.dragRate_P.isZero(0)) sentences.push_back(dragSentence(forcing.dragRate_P));
  rest = forcing;
  rest.dissipation = 0;
  if (forcing.dissipation > 0) sentences.push_back(dissipationSentence(scene, rest.none()));
  return sentences;
}

Sentences flightSentences(const scene::Flight& flight, bool pushed) {
  const std::string speed = say("{} m/s", numberWords(flight.velocity_W.norm()));
  if (pushed)
    return {flight.gravity_W.isZero(0)
                ? say("Its centre of mass moves at {} at the start, and the forces change this velocity.", speed)
                : say("Its centre of mass moves at {} at the start, and the forces and its weight change this "
                      "velocity.",
                      speed)};
  if (flight.gravity_W.isZero(0)) return {say("Its centre of mass flies straight on at {}.", speed)};
  const physics::FlightTop top = flight.top();
  const std::string rise =
      top.t_s > 0 ? say(", which rises {1} m in {0}", timeWords(top.t_s), numberWords(top.rise_m)) : "";
  return {
      say("It is thrown at {}: its centre of mass flies on a parabola{}, while the body turns about this "
          "point as if it did not fall.",
          speed, rise)};
}

}  // namespace

Sentences motionSentences(const scene::Scene& scene) {
  Sentences sentences = scene.motion.isFree() ? freeSentences(scene) : drivenSentences(scene);
  if (scene.motion.flight)
    for (const std::string& sentence : flightSentences(*scene.motion.flight, !scene.motion.forcing.forces.empty()))
      sentences.push_back(sentence);
  return sentences;
}

}  // namespace poinsot::describe
