// SPDX-License-Identifier: Apache-2.0
#include "describe/report_sections.h"
#include "physics/flight_path.h"
#include "scene/motion/make_motion.h"

namespace poinsot::describe {
namespace {

void addMomenta(Section& section, const physics::FlightQuantities& q) {
  section.add("P_W", "momentum P, in W", q.P_W, "kg m/s", "eq 1");
  section.add("L_orbital_W", "orbital part of L_tot, in W", q.orbital_W, "kg m^2/s", "eq 5");
  section.add("L_total_W", "L_tot about the origin, in W", q.total_W, "kg m^2/s", "eq 5");
  section.addDetail("force_W", "force dP/dt, in W", q.force_W, "N", "eq 1");
  section.add("torque_about_origin_W", "torque dL_tot/dt, in W", q.torque_W, "N m", "eq 1, 8");
  section.add("T_translation", "kinetic energy of translation", q.translationalEnergy, "J", "eq 10");
  section.add("T_total", "total kinetic energy", q.kineticEnergy(), "J", "eq 10");
}

}  // namespace

Section flightSection(const scene::Scene& scene) {
  Section section{"Flight (at motion time 0; W: inertial axes)", {}};
  if (!scene.motion.flight) return section;
  const scene::Flight& flight = *scene.motion.flight;
  section.add("position_W", "centre of mass R, in W", flight.position_W, "m", "");
  section.add("velocity_W", "its velocity V, in W", flight.velocity_W, "m/s", "");
  section.addDetail("speed", "|V|", flight.velocity_W.norm(), "m/s", "");
  const physics::Forcing& forcing = scene.motion.forcing;
  const physics::FlightTop top = flight.top();
  if (forcing.forces.empty() && top.t_s > 0) {
    section.add("rise_time", "time to the highest point", top.t_s, "s", "");
    section.add("rise_height", "rise to the highest point", top.rise_m, "m", "");
  }
  if (!scene.body.mass) return section;
  const auto motion = scene::makeMotion(scene, 0, 0);
  addMomenta(section, physics::flightQuantities(scene.body.mass->mass_kg(), *scene::flightPath(scene, *motion),
                                                forcing, scene.body.axes, motion->at(0)));
  return section;
}

}  // namespace poinsot::describe
