// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "describe/report_sections.h"
#include "physics/fixed_order.h"
#include "physics/torque.h"
#include "scene/motion/make_motion.h"

namespace poinsot::describe {
namespace {

using Eigen::Vector3d;

/// Adds the torque r x F of a force, in the axes in which the scene gives the force. In space it depends on the
/// attitude, which is that at the time when the force begins.
void addTorque(Section& section, const scene::Scene& scene, const physics::Motion& motion, const ReportSpan& span,
               std::size_t i) {
  const physics::PointForce& force = scene.motion.forcing.forces[i];
  const std::string key = fmt::format("force_{}_torque", i + 1);
  if (force.force_W.isZero(0)) {
    section.add(key + "_B", "  torque r x F, in B", physics::crossProduct(force.lever_B, force.force_B), "N m",
                "eq 9");
    return;
  }
  const double begin_s = std::isfinite(force.from_s) ? force.from_s : 0;
  if (begin_s < std::min({0.0, span.from_s, span.to_s}) || begin_s > std::max({0.0, span.from_s, span.to_s}))
    return;
  const Vector3d lever_W = motion.at(begin_s).q_WB * force.lever_B;
  section.add(key + "_W", fmt::format("  torque r x F at {:g} s, in W", begin_s),
              physics::crossProduct(lever_W, force.force_W), "N m", "eq 9");
}

void addForce(Section& section, const scene::Scene& scene, std::size_t i) {
  const physics::PointForce& force = scene.motion.forcing.forces[i];
  const std::string key = fmt::format("force_{}", i + 1);
  section.add(key + "_point_B", fmt::format("force {} acts at the point", i + 1),
              Vector3d(force.lever_B + scene.body.fixedPoint_B()), "m", "");
  if (force.force_B.isZero(0))
    section.add(key + "_W", "  fixed in space, in W", force.force_W, "N", "");
  else
    section.add(key + "_B", "  turns with the body, in B", force.force_B, "N", "");
  if (std::isfinite(force.from_s)) section.add(key + "_from", "  from", force.from_s, "s", "motion time");
  if (std::isfinite(force.to_s)) section.add(key + "_to", "  to", force.to_s, "s", "motion time");
}

/// Adds the sums of the forces that act at a time.
/// @param when  suffix of the keys, such as "_at_start"
/// @param words  time in words
void addSums(Section& section, const scene::Scene& scene, const physics::Motion& motion, double t_s,
             const std::string& when, const std::string& words) {
  const physics::Forcing& forcing = scene.motion.forcing;
  const physics::RigidBodyState state = motion.at(t_s);
  const Vector3d sum_W = totalForce_W(forcing, state), torque_W = torqueOfForces_W(forcing, state);
  section.add("forces" + when + "_W", fmt::format("sum of the forces at {}, in W", words), sum_W, "N", "eq 1");
  section.add("forces_torque" + when + "_W",
              scene.body.pivot_B ? "  torque about the pivot, in W" : "  torque about the centre of mass, in W",
              torque_W, "N m", scene.body.pivot_B ? "eq 8" : "eq 9");
  if (const auto path = scene::flightPath(scene, motion))
    section.add("forces_torque_about_origin" + when + "_W", "  torque about the origin O, in W",
                Vector3d(physics::crossProduct(path->positionAt(t_s), sum_W) + torque_W), "N m", "eq 8");
}

}  // namespace

Section forcesSection(const scene::Scene& scene, const physics::Motion& motion, const ReportSpan& span) {
  Section section{"Forces at points of the body (B: axes of the scene, W: inertial axes)", {}};
  const std::size_t count = scene.motion.forcing.forces.size();
  if (count == 0) return section;
  for (std::size_t i = 0; i < count; ++i) {
    addForce(section, scene, i);
    addTorque(section, scene, motion, span, i);
  }
  addSums(section, scene, motion, 0, "", "motion time 0");
  if (span.from_s != 0) addSums(section, scene, motion, span.from_s, "_at_start", "the film's start");
  return section;
}

}  // namespace poinsot::describe
