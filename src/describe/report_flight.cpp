// SPDX-License-Identifier: Apache-2.0
#include <optional>
#include <variant>
#include <vector>

#include "describe/report_sections.h"
#include "physics/flight_path.h"
#include "physics/inertia_tensor.h"
#include "physics/particle_system.h"
#include "physics/reference_point.h"
#include "scene/motion/make_motion.h"

namespace poinsot::describe {
namespace {

/// @param brief  whether only the complete table has what eq (4) does not need
void addMomenta(Section& section, const physics::FlightQuantities& q, bool brief) {
  section.add("P_W", "momentum P, in W", q.P_W, "kg m/s", "eq 1").detail = brief;
  section.add("L_orbital_W", "orbital part of L_tot, in W", q.orbital_W, "kg m^2/s", "eq 5");
  section.add("L_total_W", "L_tot about the origin, in W", q.total_W, "kg m^2/s", "eq 5");
  section.addDetail("force_W", "force dP/dt, in W", q.force_W, "N", "eq 1");
  section.add("torque_about_origin_W", "torque dL_tot/dt, in W", q.torque_W, "N m", "eq 1, 8").detail = brief;
  section.add("T_translation", "kinetic energy of translation", q.translationalEnergy, "J", "eq 10").detail =
      brief;
  section.add("T_total", "total kinetic energy", q.kineticEnergy(), "J", "eq 10").detail = brief;
}

/// Returns L_tot as the sum over the particles of a body that consists of point masses only (eq 4).
std::optional<Eigen::Vector3d> sumOverParticles_W(const scene::Scene& scene, const physics::RigidBodyState& s,
                                                  const physics::ReferencePointTerms& terms) {
  std::vector<physics::Particle> particles;
  for (const scene::Part& part : scene.body.parts) {
    if (!std::holds_alternative<scene::PointMass>(part.figure)) return std::nullopt;
    const Eigen::Vector3d r_W = physics::turnedVector(s.q_WB, part.offset_B - *scene.motion.thrownBy_B);
    particles.push_back({part.mass_kg, terms.position_W + r_W, Eigen::Vector3d::Zero()});
  }
  return physics::rigidlyMoving(particles, terms.position_W, terms.velocity_W, s.omega_W)
      .angularMomentumAbout(Eigen::Vector3d::Zero());
}

}  // namespace

Section referencePointSection(const scene::Scene& scene) {
  Section section{"Reference point K (at motion time 0; W: inertial axes)", {}};
  if (!scene.motion.thrownBy_B) return section;
  const auto s = scene::makeMotion(scene, 0, 0)->at(0);
  const auto terms =
      physics::referencePointTerms(*scene.body.mass, *scene.motion.thrownBy_B, *scene.motion.flight, s);
  section.addDetail("K_B", "K, in B", *scene.motion.thrownBy_B, "m", "");
  section.addDetail("K_position_W", "its position R", terms.position_W, "m", "eq 4");
  section.addDetail("K_velocity_W", "its velocity V", terms.velocity_W, "m/s", "eq 4");
  section.addDetail("K_to_centre_W", "c, from K to the centre of mass", terms.centre_W, "m", "");
  section.add("L_K_translation_W", "R x M V", terms.translation_W, "kg m^2/s", "eq 4");
  section.add("L_K_mixed_1_W", "mixed term R x (omega x M c)", terms.turningCentre_W, "kg m^2/s", "eq 4");
  section.add("L_K_mixed_2_W", "mixed term M c x V", terms.displaced_W, "kg m^2/s", "eq 4");
  section.add("L_K_rotation_W", "rotation about K, I_K omega", terms.rotation_W, "kg m^2/s", "eq 4");
  section.add("L_K_sum_W", "L_tot, the sum of the four", terms.sum_W(), "kg m^2/s", "eq 4");
  if (const auto sum = sumOverParticles_W(scene, s, terms))
    section.add("L_particles_W", "L_tot, particle by particle", *sum, "kg m^2/s", "eq 4");
  section.add("mixed_terms_vanish", "mixed terms vanish", terms.mixedTermsVanish(), "", "eq 5");
  return section;
}

Section flightSection(const scene::Scene& scene) {
  Section section{"Flight (at motion time 0; W: inertial axes)", {}};
  if (!scene.motion.flight) return section;
  const scene::Flight& flight = *scene.motion.flight;
  const bool byPoint = scene.motion.thrownBy_B.has_value();  // the page has the terms of eq (4) instead
  section.add("position_W", "centre of mass R, in W", flight.position_W, "m", "").detail = byPoint;
  section.add("velocity_W", "its velocity V, in W", flight.velocity_W, "m/s", "").detail = byPoint;
  section.addDetail("speed", "|V|", flight.velocity_W.norm(), "m/s", "");
  const physics::Forcing& forcing = scene.motion.forcing;
  const physics::FlightTop top = flight.top();
  if (forcing.forces.empty() && top.t_s > 0) {
    section.add("rise_time", "time to the highest point", top.t_s, "s", "").detail = byPoint;
    section.add("rise_height", "rise to the highest point", top.rise_m, "m", "").detail = byPoint;
  }
  if (!scene.body.mass) return section;
  const auto motion = scene::makeMotion(scene, 0, 0);
  addMomenta(section,
             physics::flightQuantities(scene.body.mass->mass_kg(), *scene::flightPath(scene, *motion), forcing,
                                       scene.body.axes, motion->at(0)),
             byPoint);
  return section;
}

}  // namespace poinsot::describe
