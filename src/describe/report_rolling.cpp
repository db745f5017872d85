// SPDX-License-Identifier: Apache-2.0
#include "describe/report_sections.h"
#include "physics/rolling_cone.h"

namespace poinsot::describe {

Section rollingSection(const scene::Scene& scene) {
  Section section{"Cone on a table (a: from the apex to the base, z: up)", {}};
  if (!scene.motion.rolling) return section;
  const auto& [cone, g, centre_m] = *scene.motion.rolling;
  const double mass_kg = scene.body.mass->mass_kg();
  const physics::RollingForces forces = physics::rollingForces(cone, mass_kg, centre_m, g);
  section.add("cone_half_angle", "half-angle alpha", cone.halfAngle_rad(), "rad", "");
  section.add("cone_slant_height", "slant height, the length of the line of contact", cone.slant_m(), "m", "");
  section.add("rolling_rate", "Omega_v of the axis about z", cone.rate, "rad/s", "omega = Omega_v z + Omega_s a");
  section.add("rolling_spin", "Omega_s about a", cone.spin(), "rad/s", "-Omega_v/sin alpha");
  section.add("rolling_omega", "omega along the line of contact", cone.alongContact(), "rad/s",
              "-Omega_v cot alpha, outwards");
  section.add("rolling_L", "L about the apex: outwards, along the motion, up", cone.angularMomentum(), "kg m^2/s",
              "constant components");
  section.add("rolling_torque", "torque dL/dt, along the motion", cone.torque(), "N m", "Omega_v z x L");
  section.add("normal_force", "normal force of the table", forces.normal_N, "N", "M g");
  section.add("normal_force_place", "  its distance from the apex", forces.place_m, "m", "on the line of contact");
  section.add("inward_force", "horizontal force towards the apex", forces.inward_N, "N",
              "M Omega_v^2 d cos alpha");
  section.add("rolling_fastest", "tips over its rim above", forces.fastest, "rad/s", "largest |Omega_v|");
  return section;
}

}  // namespace poinsot::describe
