// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "describe/report_sections.h"
#include "physics/binet.h"
#include "physics/earth.h"
#include "physics/geometric_phase.h"
#include "physics/herpolhode.h"
#include "physics/mean_periods.h"
#include "physics/poinsot_construction.h"
#include "physics/polhode.h"
#include "physics/precession_cones.h"
#include "physics/stability.h"
#include "scene/motion/make_motion.h"
#include "stage/body/body_figure.h"

namespace poinsot::describe {
namespace {

using physics::PrecessionCones;

constexpr int kMostRadialPeriods = 1000;
constexpr double kClosureTolerance = 1e-9;  // rad; 0.001 pixels on a circle with a radius of a million pixels

bool turnsFreely(const scene::Scene& scene) { return scene.motion.isFree() && !scene.motion.omega_B.isZero(0); }

std::string regimeWord(physics::PolhodeRegime regime) {
  switch (regime) {
    case physics::PolhodeRegime::kSteady:
      return "steady";
    case physics::PolhodeRegime::kAboutLargest:
      return "about_largest";
    case physics::PolhodeRegime::kAboutSmallest:
      return "about_smallest";
    case physics::PolhodeRegime::kSeparatrix:
      return "separatrix";
  }
  return "";
}

std::string steadyWords(physics::Stability kind) {
  return kind == physics::Stability::kUnstable ? "steady, but unstable: the middle axis" : "steady: omega stays";
}

std::string inWords(physics::PolhodeRegime regime, const scene::Scene& scene) {
  switch (regime) {
    case physics::PolhodeRegime::kSteady:
      return steadyWords(physics::spinStability(scene.body.axes.moments(), scene::startOmega_P(scene)).kind);
    case physics::PolhodeRegime::kAboutLargest:
      return "round the axis of largest moment";
    case physics::PolhodeRegime::kAboutSmallest:
      return "round the axis of smallest moment";
    case physics::PolhodeRegime::kSeparatrix:
      return "on the separatrix, to the middle axis";
  }
  return "";
}

std::optional<PrecessionCones> conesOf(const scene::Scene& scene) {
  return physics::precessionCones(scene.body.axes.moments(), scene::startOmega_P(scene));
}

void addEllipsoids(Section& section, const scene::Scene& scene) {
  const auto& moments = scene.body.axes.moments();
  const physics::PoinsotConstruction poinsot(moments, scene::startOmega_P(scene));
  const physics::BinetConstruction binet(moments, scene::startOmega_P(scene));
  section.add("plane_height", "height of the invariable plane 2T/|L|", poinsot.planeHeight(), "rad/s", "eq 40");
  section.add("ellipsoid_semi_axes", "semi-axes sqrt(2T/I_i) of the ellipsoid", poinsot.semiAxes_P(), "rad/s",
              "eq 38");
  section.addDetail("momentum_ellipsoid_semi_axes", "semi-axes sqrt(2T I_i) in L space", binet.semiAxes_P(),
                    "kg m^2/s", "Binet");
}

/// Adds the periods that astronomers publish of a tumbling body.
void addMeanPeriods(Section& section, const scene::Scene& scene) {
  const auto periods = physics::meanPeriods(scene.body.axes.moments(), scene::startOmega_P(scene));
  if (!periods) return;
  const bool isShort = periods->mode == physics::AxisMode::kShort;
  section.add(
      "tumbling_mode", "mode of the tumbling", std::string(isShort ? "SAM" : "LAM"), "",
      isShort ? "L circles the short axis, of largest moment" : "L circles the long axis, of smallest moment");
  section.add("P_phi", "  P_phi: the long axis goes round L in", periods->phi_s, "s", "mean");
  section.add("P_psi", isShort ? "  P_psi: a swing about the long axis" : "  P_psi: a turn about the long axis",
              periods->psi_s, "s", "period of the polhode");
}

/// Adds how far the motion is from the steady spins, which have the least and the most energy of this |L|.
void addBounds(Section& section, const scene::Scene& scene) {
  const auto& moments = scene.body.axes.moments();
  const Eigen::Vector3d omega_P = scene::startOmega_P(scene), m_P = moments.angularMomentum(omega_P);
  const double square = m_P.squaredNorm(), least = square / (2 * moments.values().maxCoeff()),
               most = square / (2 * moments.values().minCoeff());
  section.addDetail("T_bounds", "T at this |L| is from L^2/(2 I_max) to L^2/(2 I_min)",
                    std::vector<double>{least, most}, "J", "spins about the two outer axes");
  const physics::Herpolhode curve(moments, omega_P);
  const double height = physics::PoinsotConstruction(moments, omega_P).planeHeight();
  const std::vector<double> radii{curve.smallestRadius(), curve.largestRadius()};
  section.addDetail("omega_range", "range of |omega|",
                    std::vector<double>{std::hypot(height, radii[0]), std::hypot(height, radii[1])}, "rad/s", "");
  section.addDetail("omega_L_range", "range of the angle between omega and L",
                    std::vector<double>{std::atan2(radii[0], height), std::atan2(radii[1], height)}, "rad", "");
}

void addMiddleAxis(Section& section, const physics::FlipTimes& flips) {
  section.add("flip_interval", flips.turnsOver ? "time from flip to flip, 2K/lambda" : "half a period, 2K/lambda",
              flips.interval_s, "s", "omega_mid changes sign");
  section.add("least_angle_to_middle", "least angle between L and the middle axis", flips.nearestToMiddle_rad,
              "rad", "");
  section.add("largest_tilt", "largest angle between L and the axis that it circles",
              std::numbers::pi / 2 - flips.nearestToMiddle_rad, "rad", "");
}

void addPolhode(Section& section, const scene::Scene& scene) {
  const physics::Polhode polhode(scene.body.axes.moments(), scene::startOmega_P(scene));
  section.add("regime", "polhode", regimeWord(polhode.regime()), "", "sign of L^2 - 2 T I_mid").inWords =
      inWords(polhode.regime(), scene);
  if (polhode.regime() == physics::PolhodeRegime::kSteady) return;
  section.add("polhode_period", "period of the polhode 4K/lambda", polhode.period(), "s", "eq 24 to 26");
  if (polhode.period() > physics::kSolarDay_s && std::isfinite(polhode.period()))
    section.add("polhode_period_days", "  in days", polhode.period() / physics::kSolarDay_s, "d", "86 400 s each");
  const physics::FlipTimes flips = physics::flipTimes(scene.body.axes.moments(), scene::startOmega_P(scene));
  section.add("lambda", "lambda", flips.growthRate, "1/s", "elliptic functions of lambda t");
  section.addDetail("complementary_parameter", "mc = 1 - k^2", flips.complementary, "", "0 on the separatrix");
  const bool symmetric = conesOf(scene).has_value();
  section.add("body_flips", "the body flips", flips.turnsOver, "",
              symmetric ? "two moments are equal" : "yes if L comes within 20 deg of the middle axis");
  if (symmetric) return;
  addMiddleAxis(section, flips);
  addMeanPeriods(section, scene);
  addBounds(section, scene);
}

/// Adds a symmetric top's herpolhode, a circle that closes after one turn of omega about L.
void addCircle(Section& section, const PrecessionCones& cones) {
  section.addDetail("herpolhode_closes", "the herpolhode closes", true, "", "a circle");
  section.addDetail("closure_turns", "  in turns about L", 1, "", "");
  section.addDetail("closure_time", "  that is", 2 * std::numbers::pi / cones.precessionRate, "s", "2 pi I1/L");
}

void addHerpolhode(Section& section, const scene::Scene& scene) {
  const physics::Herpolhode curve(scene.body.axes.moments(), scene::startOmega_P(scene));
  if (curve.regime() == physics::PolhodeRegime::kSteady) return;
  section.add("herpolhode_smallest_radius", "least radius of the herpolhode", curve.smallestRadius(), "rad/s", "");
  section.add("herpolhode_largest_radius", "largest radius of the herpolhode", curve.largestRadius(), "rad/s", "");
  if (const auto cones = conesOf(scene)) return addCircle(section, *cones);
  section.add("radial_period", "from a largest radius to the next", curve.radialPeriod(), "s",
              "half of the polhode's period");
  section.add("angle_per_radial_period", "angle about L in that time", curve.anglePerRadialPeriod(), "rad", "");
  const auto closure = curve.closure(kMostRadialPeriods, kClosureTolerance);
  section.add("herpolhode_closes", "the herpolhode closes", closure.has_value(), "", "to 1e-9 rad");
  if (!closure) return;
  section.add("closure_radial_periods", "  after radial periods", closure->radialPeriods, "", "");
  section.add("closure_turns", "  in turns about L", closure->turns, "", "");
  section.add("closure_time", "  that is", closure->radialPeriods * curve.radialPeriod(), "s", "");
}

/// Adds the distances between the places where k, omega and L leave the surface, if the size of the body is known.
void addPoleDistance(Section& section, const scene::Scene& scene, const PrecessionCones& cones) {
  constexpr double kSmall_rad = 0.1;  // a larger angle is easier to imagine than a distance
  if (cones.bodyCone_rad == 0 || cones.bodyCone_rad > kSmall_rad) return;
  if (scene.body.parts.empty() || !scene.show.body.parts.empty()) return;
  const double reach_m = stage::BodyFigure(scene).halfExtents()[cones.axis];
  section.add("pole_distance", "  at the end of k, omega is off by", reach_m * std::tan(cones.bodyCone_rad), "m",
              "half the length along k, times tan beta");
  section.add("pole_distance_of_L", "  and L is off omega by", reach_m * std::tan(cones.spaceCone_rad), "m",
              "half the length along k, times tan |theta - beta|");
}

/// Adds Montgomery's phase. The facts are details, unless the scene draws the solid angle.
void addGeometricPhase(Section& section, const scene::Scene& scene) {
  const auto phase = physics::geometricPhase(scene.body.axes.moments(), scene::startOmega_P(scene));
  if (!phase) return;
  const bool isDrawn = std::ranges::any_of(scene.views, [](const scene::View& view) {
    return view.show.figures.binet.visible && view.show.figures.binet.area;
  });
  const auto add = [&](const char* key, const char* label, double value, const char* unit, const char* from) {
    section.add(key, label, value, unit, from).detail = !isDrawn;
  };
  add("period_turn", "turn of the body about L in a period of the polhode", phase->turn_rad, "rad",
      "Montgomery; shows modulo 2 pi");
  add("dynamic_phase", "  dynamic part", phase->dynamic_rad, "rad", "2 T Tp/L");
  add("geometric_phase", "  geometric part", phase->geometric_rad, "rad",
      phase->sense > 0 ? "minus the solid angle" : "the solid angle");
  add("polhode_solid_angle", "solid angle of the polhode, from the centre", phase->solidAngle_sr, "sr",
      "on the momentum sphere");
}

/// Adds a period of the Earth's wobble in solar days, and in sidereal days, which books use for computed periods.
void addEarthPeriod(Section& section, const std::string& key, const std::string& label, double period_s,
                    const std::string& from) {
  const double sidereal = period_s / physics::kSiderealDay_s;
  section.add(key + "_solar_days", label, period_s / physics::kSolarDay_s, "d",
              fmt::format("{}; {:.2f} sidereal d", from, sidereal));
  section.addDetail(key + "_sidereal_days", "    in sidereal days", sidereal, "sidereal d",
                    "86 164.09 s each, the time of one turn of the Earth");
}

void addDeformableEarth(Section& section, const physics::EarthWobble& wobble) {
  addEarthPeriod(section, "chandler_elastic", "  if elastic", wobble.elastic_s, "computed: rigid/(1 - k/k_s)");
  section.addDetail("love_number", "    Love number k", physics::earth::kLoveNumber, "",
                    "quoted: Wahr (1981, 1985)");
  section.addDetail("secular_love_number", "    secular Love number k_s", wobble.secularLoveNumber, "",
                    "computed: 3 G (C - A)/(Omega^2 a^5)");
  addEarthPeriod(section, "chandler_fluid_core", "  if elastic, with a fluid core", wobble.fluidCore_s,
                 "computed: elastic A_m/A");
  section.addDetail("mantle_share", "    share of the mantle A_m/A", physics::earth::kMantleShare, "",
                    "quoted: Mathews et al. (1991)");
}

void addChandler(Section& section, const physics::PrincipalMoments& moments, const PrecessionCones& cones) {
  addEarthPeriod(section, "chandler_period", "Chandler period, if rigid", cones.wobblePeriod(), "computed: eq 29");
  if (const auto wobble = physics::earthWobble(moments, cones)) addDeformableEarth(section, *wobble);
  addEarthPeriod(section, "chandler_observed", "  observed", physics::earth::kObserved_days * physics::kSolarDay_s,
                 "quoted, +- 1.1 d: Wilson & Vicente (1990)");
}

/// Returns how the body cone rolls, "outside" or "inside"; "none" for a steady spin, in which no cone rolls.
std::string senseWord(const PrecessionCones& cones) {
  const physics::RollingSense sense = cones.steady() ? physics::RollingSense::kNone : cones.sense;
  if (sense == physics::RollingSense::kOutside) return "outside";
  return sense == physics::RollingSense::kInside ? "inside" : "none";
}

std::string stabilityWord(physics::Stability kind) {
  if (kind == physics::Stability::kStable) return "stable";
  return kind == physics::Stability::kUnstable ? "unstable" : "neutral";
}

std::string rateMeaning(physics::Stability kind) {
  if (kind == physics::Stability::kUnstable) return "a disturbance grows at this rate";
  return kind == physics::Stability::kStable ? "a disturbance circles at this rate" : "another moment is equal";
}

}  // namespace

Section constructionSection(const scene::Scene& scene) {
  Section section{"Poinsot's construction (axes e1, e2, e3)", {}};
  if (!turnsFreely(scene)) return section;
  addEllipsoids(section, scene);
  addPolhode(section, scene);
  addHerpolhode(section, scene);
  addGeometricPhase(section, scene);
  return section;
}

Section symmetricSection(const scene::Scene& scene) {
  Section section{"Symmetric top (k: its axis)", {}};
  if (!turnsFreely(scene)) return section;
  const auto cones = conesOf(scene);
  if (!cones) return section;
  section.add("symmetry_axis_B", "symmetry axis k, in B", scene.body.axes.toB(cones->k_P), "",
              "the end with omega_3 >= 0");
  section.add("tilt", "angle theta between k and L", cones->tilt_rad, "rad", "eq 20");
  section.add("body_cone_half_angle", "body cone, half-angle (omega, k)", cones->bodyCone_rad, "rad", "eq 30");
  addPoleDistance(section, scene, *cones);
  section.add("space_cone_half_angle", "space cone, half-angle (omega, L)", cones->spaceCone_rad, "rad", "eq 35");
  section.add("rolling", "the body cone rolls on the space cone's", senseWord(*cones), "",
              "outside if prolate, inside if oblate");
  section.add("precession_rate", "precession L/I1 about L", cones->precessionRate, "rad/s", "eq 20, 34");
  section
      .add("precession_period", "  once round in", 2 * std::numbers::pi / cones->precessionRate, "s", "2 pi I1/L")
      .detail = cones->steady();
  section.add("omega_1", "omega_1 = L sin theta/I1", cones->precessionRate * std::sin(cones->tilt_rad), "rad/s",
              "eq 19; along i, in the plane of L and k");
  section.add("spin_rate", "omega_3", cones->spinRate, "rad/s", "eq 26; k is chosen so that omega_3 >= 0");
  if (!cones->steady() && cones->spinRate > 0)
    section.add("wobbles_per_turn", "turns about L for each turn omega_3/(2 pi)",
                cones->precessionRate / cones->spinRate, "", "I3/(I1 cos theta)");
  section.add("body_precession_rate", "Omega_p of omega about k", cones->bodyRate, "rad/s", "eq 29, 37");
  section.add("hand_finch_spin", "Hand & Finch's spin Omega", cones->handFinchSpin(), "rad/s", "eq 21").detail =
      cones->steady();
  section.add("wobble_period", "wobble seen from the body 2 pi/|Omega_p|", cones->wobblePeriod(), "s", "eq 29")
      .detail = cones->steady();
  if (physics::resemblesEarth(*cones)) addChandler(section, scene.body.axes.moments(), *cones);
  return section;
}

Section stabilitySection(const scene::Scene& scene) {
  const bool free = scene.motion.isFree();
  Section section{free ? "Spin about each principal axis, at the present |omega|"
                       : "Spin about each principal axis, at the present |omega|, if nothing acted on the body",
                  {}};
  const double spin = scene.motion.omega_B.norm();
  if (spin == 0) return section;
  for (int axis = 0; axis < 3; ++axis) {
    const auto found = physics::spinStability(scene.body.axes.moments(), axis, spin);
    const std::string name = "axis_" + std::to_string(axis + 1), label = "e" + std::to_string(axis + 1);
    const bool neutral = found.kind == physics::Stability::kNeutral;  // the rate is then 0
    section.add(name + "_stability", "spin about " + label, stabilityWord(found.kind), "", "eq 24 to 26").detail =
        neutral;
    section.add(name + "_rate", "  rate", found.rate, "1/s", rateMeaning(found.kind)).detail = neutral;
  }
  return section;
}

}  // namespace poinsot::describe
