// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "describe/report_sections.h"
#include "physics/driven_motion.h"
#include "physics/energy_loss.h"
#include "physics/polhode.h"
#include "physics/run_condition.h"
#include "scene/motion/film_pace.h"
#include "scene/motion/heavy_top_start.h"
#include "scene/motion/make_motion.h"

namespace poinsot::describe {
namespace {

void addSteadyPrecession(Section& section, const physics::HeavyTop& top, double tilt_rad, double spin) {
  if (spin == 0) return;
  const auto steady = top.steadyPrecession(tilt_rad, spin);
  section.add("steady_precession_exists", "steady precession at this tilt and spin", steady.has_value(), "", "");
  if (!steady) return;
  section.add("slow_precession_rate", "  slow", steady->slow, "rad/s", "about the vertical");
  section.add("fast_precession_rate", "  fast", steady->fast, "rad/s",
              std::isinf(steady->fast) ? "none: the axis is level" : "");
}

/// Names the motion of a heavy top as textbooks do; empty if it has no name.
std::string nameOf(const scene::HeavyTopStart& start) {
  const auto kind = start.top.nutationKind(start.omega_P, start.up_P);
  if (!kind) return "";
  switch (*kind) {
    case physics::NutationKind::kCusps:
      return "nutation with cusps";
    case physics::NutationKind::kLoops:
      return "nutation with loops";
    case physics::NutationKind::kWaves:
      return "nutation in waves";
    case physics::NutationKind::kSteady:
      break;
  }
  const auto steady = start.top.steadyPrecession(start.tilt_rad(), start.spin());
  const double rate = start.nutation().precession_rad / start.nutation().period_s;
  const bool isSlow = steady && std::abs(rate - steady->slow) < std::abs(rate - steady->fast);
  return isSlow ? "slow steady precession" : "fast steady precession";
}

/// Adds the constants of a motion without losses: energy, and L along the vertical and along k.
/// @param meaning  of the three values, such as "constant"
void addConstants(Section& section, const scene::HeavyTopStart& start, const std::string& meaning) {
  const physics::HeavyTop& top = start.top;
  const double L_3 = top.along * start.spin(), across2 = start.omega_P.squaredNorm() - start.spin() * start.spin();
  const double rest = 0.5 * top.across * across2 + top.weight * std::cos(start.tilt_rad());
  const Eigen::Vector3d across_P = start.omega_P - start.spin() * top.k_P;
  section.add("top_energy", "energy T + M g l cos theta", rest + 0.5 * L_3 * start.spin(), "J", meaning);
  section.add("top_L_z", "L_z, about the vertical",
              top.across * across_P.dot(start.up_P) + L_3 * top.k_P.dot(start.up_P), "kg m^2/s", meaning);
  section.add("top_L_3", "L_3 = I3 omega_3, about k", L_3, "kg m^2/s", meaning);
  section.addDetail("top_reduced_energy", "energy without L_3^2/(2 I3)", rest, "J",
                    "the effective potential has this value at the least and at the largest tilt");
}

void addNutation(Section& section, const physics::Nutation& nutation) {
  section.add("nutation_least_tilt", "nutation: least tilt", nutation.leastTilt_rad, "rad", "from the vertical");
  section.add("nutation_largest_tilt", "  largest tilt", nutation.mostTilt_rad, "rad", "");
  section.add("nutation_period", "  period", nutation.period_s, "s", "");
  section.add("precession_per_nutation", "  precession in a period", nutation.precession_rad, "rad", "");
}

/// Adds the spin in which a loss of energy at constant L ends: a spin about the axis of largest moment. A steady
/// spin loses no energy.
void addFinalState(Section& section, const physics::PrincipalMoments& moments, const Eigen::Vector3d& omega_P) {
  const double largest = moments.values().maxCoeff(), L = moments.values().cwiseProduct(omega_P).norm();
  const double start = 0.5 * omega_P.dot(moments.values().cwiseProduct(omega_P)), end = 0.5 * L * (L / largest);
  section.add("final_omega", "final spin L/I_max, axis of largest moment", L / largest, "rad/s",
              "height of the plane");
  section.add("final_spin_rpm", "  that is", L / largest * 30 / std::numbers::pi, "rpm", "");
  section.add("final_T", "final kinetic energy L^2/(2 I_max)", end, "J", "eq 12");
  section.add("final_T_part", "  relative to the start", end / start, "", "");
}

/// Returns the axis of largest moment in the direction of its spin, or words if the film ends before this is
/// decided.
std::string finalDirection(const physics::Motion& motion, double end_s) {
  const physics::PrincipalMoments& moments = motion.axes().moments();
  const Eigen::Vector3d omega_P = motion.axes().toP(motion.at(end_s).omega_B);
  if (physics::Polhode(moments, omega_P).regime() != physics::PolhodeRegime::kAboutLargest)
    return "not decided before the film ends";
  const int axis = moments.ascendingAxes()[2];
  return fmt::format("{}e{}", omega_P[axis] < 0 ? "-" : "+", axis + 1);
}

/// Adds how a body without other torques comes to a spin about its axis of largest moment.
void addDamping(Section& section, const scene::Scene& scene, const physics::Motion& motion,
                const ReportSpan& span) {
  const auto& moments = scene.body.axes.moments();
  const Eigen::Vector3d omega_P = scene::startOmega_P(scene);
  const double alpha = scene.motion.forcing.dissipation, L = moments.angularMomentum(omega_P).norm();
  section.add("damping_time", "time in which a small wobble falls to 1/e", physics::dampingTime(moments, alpha, L),
              "s", "2/(alpha L^2 (1/I1 + 1/I2 - 2/I3))");
  if (const auto axis = moments.ascendingAxes();
      moments[axis[0]] < moments[axis[1]] && moments[axis[1]] < moments[axis[2]]) {
    section.add("separatrix_time", "reaches the separatrix after about",
                physics::timeToSeparatrix(moments, omega_P, alpha), "s", "mean over the wobble");
    section.add("final_direction", "comes to a spin about", finalDirection(motion, span.to_s), "",
                "axis of largest moment");
  }
  addFinalState(section, moments, omega_P);
}

void addIntegration(Section& section, const physics::DrivenMotionReport& report) {
  section.add("method", "method", report.method, "", "");
  section.addDetail("order", "order of the integration method", report.order, "",
                    report.order == 0 ? "closed form" : "");
  section.add("steps", "steps over the run", static_cast<int>(report.steps), "", "");
  section.addDetail("shortest_step", "shortest step", report.shortestStep_s, "s", "");
  section.addDetail("tolerance", "largest allowed attitude error", report.tolerance_rad, "rad",
                    "motion.tolerance");
  section.add("estimated_attitude_error", "estimated attitude error", report.estimatedAttitudeError_rad, "rad",
              report.limitedByRounding ? "the best that double allows" : "within the allowed error");
  section.addDetail("limited_by_rounding", "limited by rounding", report.limitedByRounding, "", "");
  if (report.energyDrift)
    section.add("energy_drift", "drift of the total energy", *report.energyDrift, "", "relative, over the run");
}

/// Adds the accuracy at one end of the film: the end farther from motion time 0, at which the initial state is
/// given.
void addCondition(Section& section, const scene::Scene& scene, const ReportSpan& span) {
  const bool first = std::abs(span.from_s) > std::abs(span.to_s);
  const std::string end = first ? "the first frame" : "the end";
  const auto condition =
      physics::runCondition(scene.body.axes, scene.motion.omega_B, std::abs(first ? span.from_s : span.to_s));
  section.add("turns", "turns from time 0 to " + end, condition.turns, "", "|omega| t/(2 pi), omega at time 0");
  section.addDetail("flips", "half periods of the polhode up to " + end, condition.flips, "", "");
  section.addDetail("end_uncertainty", "attitude uncertainty at " + end, condition.attitude_rad, "rad",
                    "if the input is rounded");
  section.add("meaningful_digits", "meaningful digits at " + end, condition.digits, "", "");
}

/// Returns what is true of a top at its start although drag or a loss of energy acts.
Section lossyTopSection(const scene::Scene& scene) {
  Section section{"Heavy top at the start (k: from the pivot to the centre of mass)", {}};
  const auto start = scene::nearlyHeavyTopStart(scene);
  if (!start) return section;
  section.add("weight_moment", "M g l", start->top.weight, "N m", "");
  section.add("top_tilt", "angle between k and the vertical", start->tilt_rad(), "rad", "");
  section.add("top_spin", "spin omega_3", start->spin(), "rad/s", "eq 26");
  section.add("sleeping_spin", "sleeps upright above 2 sqrt(I1 M g l)/I3", start->top.sleepingSpin(), "rad/s", "");
  addConstants(section, *start, "without losses constant");
  return section;
}

}  // namespace

Section heavyTopSection(const scene::Scene& scene) {
  Section section{"Heavy top (k: from the pivot to the centre of mass)", {}};
  const auto start = scene::heavyTopStart(scene);
  if (!start) return lossyTopSection(scene);
  section.add("weight_moment", "M g l", start->top.weight, "N m", "");
  if (start->uneven > 0)
    section.add("top_unevenness", "moments across k differ by", start->uneven, "",
                "relative difference; the motion uses the mean of the two moments");
  section.add("top_tilt", "angle between k and the vertical", start->tilt_rad(), "rad", "");
  section.add("top_spin", "spin omega_3", start->spin(), "rad/s", "eq 26");
  addConstants(section, *start, "constant");
  if (const std::string name = nameOf(*start); !name.empty())
    section.add("top_motion", "motion of the axis", name, "", "");
  section.add("sleeping_spin", "sleeps upright above 2 sqrt(I1 M g l)/I3", start->top.sleepingSpin(), "rad/s", "");
  addSteadyPrecession(section, start->top, start->tilt_rad(), start->spin());
  addNutation(section, start->nutation());
  if (const auto round_s = scene::precessionPeriod_s(scene))
    section.add("precession_period", "mean precession: once round in", *round_s, "s", "about the vertical");
  return section;
}

Section lossSection(const scene::Scene& scene, const physics::Motion& motion, const ReportSpan& span) {
  Section section{"Losses", {}};
  const physics::Forcing& forcing = scene.motion.forcing;
  const Eigen::Vector3d omega_P = scene::startOmega_P(scene);
  if (!forcing.dragRate_P.isZero(0))
    section.add("drag_times", "time in which drag leaves 1/e of L_i", forcing.dragRate_P.cwiseInverse().eval(),
                "s", "1/d_i, axes e1, e2, e3");
  physics::Forcing rest = forcing;
  rest.dissipation = 0;
  if (forcing.dissipation > 0 && rest.none() &&
      physics::Polhode(scene.body.axes.moments(), omega_P).regime() != physics::PolhodeRegime::kSteady)
    addDamping(section, scene, motion, span);
  return section;
}

Section accuracySection(const scene::Scene& scene, const physics::Motion& motion, const ReportSpan& span) {
  Section section{"Run", {}};
  section.add("motion_from", "motion time of the first frame", span.from_s, "s", "");
  section.add("motion_to", "motion time at the end of the film", span.to_s, "s", "");
  const auto round_s = scene::precessionPeriod_s(scene);
  section.add("pace", "seconds of motion per second of film", scene::chosenSpeed(scene), "",
              scene.time.speed ? "time.speed" : "chosen: time.speed is not given");
  if (round_s)
    section.add("precession_turns", "turns of the precession in the film",
                std::abs(span.to_s - span.from_s) / *round_s, "",
                scene::heavyTopStart(scene) ? "" : "estimate, without losses and asymmetry");
  if (scene.motion.isFree()) {
    addCondition(section, scene, span);
    return section;
  }
  if (const physics::DrivenMotion* driven = motion.driven()) addIntegration(section, driven->report());
  return section;
}

}  // namespace poinsot::describe
