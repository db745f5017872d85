// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "describe/report_sections.h"
#include "physics/driven_motion.h"
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

}  // namespace

Section heavyTopSection(const scene::Scene& scene) {
  Section section{"Heavy top (k: from the pivot to the centre of mass)", {}};
  const auto start = scene::heavyTopStart(scene);
  if (!start) return section;
  section.add("weight_moment", "M g l", start->top.weight, "N m", "");
  if (start->uneven > 0)
    section.add("top_unevenness", "moments across k differ by", start->uneven, "",
                "relative difference; the motion uses the mean of the two moments");
  section.add("top_tilt", "angle between k and the vertical", start->tilt_rad(), "rad", "");
  section.add("top_spin", "spin omega_3", start->spin(), "rad/s", "eq 26");
  if (const std::string name = nameOf(*start); !name.empty())
    section.add("top_motion", "motion of the axis", name, "", "");
  section.add("sleeping_spin", "sleeps upright above 2 sqrt(I1 M g l)/I3", start->top.sleepingSpin(), "rad/s", "");
  addSteadyPrecession(section, start->top, start->tilt_rad(), start->spin());
  addNutation(section, start->nutation());
  if (const auto round_s = scene::precessionPeriod_s(scene))
    section.add("precession_period", "mean precession: once round in", *round_s, "s", "about the vertical");
  return section;
}

Section lossSection(const scene::Scene& scene) {
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
    addFinalState(section, scene.body.axes.moments(), omega_P);
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
  if (scene.motion.forcing.none()) {
    addCondition(section, scene, span);
    return section;
  }
  if (const auto* driven = dynamic_cast<const physics::DrivenMotion*>(&motion))
    addIntegration(section, driven->report());
  return section;
}

}  // namespace poinsot::describe
