// SPDX-License-Identifier: Apache-2.0
#include "describe/report_sections.h"
#include "scene/motion/make_motion.h"

namespace poinsot::describe {
namespace {

bool isPrincipal(const Eigen::Matrix3d& inertia_B) { return inertia_B.isDiagonal(1e-12); }

/// Returns the equations of the inertia tensor. If there are products of inertia, adds their sign, because
/// published tables use different signs.
std::string tensorSource(const Eigen::Matrix3d& inertia_B, const char* equations) {
  return std::string(equations) + (isPrincipal(inertia_B) ? "" : "; off the diagonal -(sum of m x y)");
}

}  // namespace

Section bodySection(const scene::Scene& scene) {
  const scene::Body& body = scene.body;
  Section section{"Body (components along the axes B of the scene)", {}};
  if (body.mass) {
    section.add("mass", "mass", body.mass->mass_kg(), "kg", "");
    section.add("centre_of_mass_B", "centre of mass", body.mass->centre_B(), "m", "");
  }
  if (body.pivot_B) section.add("pivot_B", "point held fixed", *body.pivot_B, "m", "");
  // If the axes B are principal axes, the principal moments say everything.
  const bool principal = isPrincipal(body.axes.inertia_B());
  section
      .add("inertia_tensor_B", body.pivot_B ? "inertia about the fixed point" : "inertia tensor",
           body.axes.inertia_B(), "kg m^2",
           tensorSource(body.axes.inertia_B(), body.pivot_B ? "eq 3, 14" : "eq 7, 13"))
      .detail = principal;
  section.add("principal_moments", "principal moments about e1, e2, e3", body.axes.moments().values(), "kg m^2",
              "eq 17");
  for (int axis = 0; axis < 3; ++axis)
    section
        .add("principal_axis_" + std::to_string(axis + 1) + "_B", "principal axis e" + std::to_string(axis + 1),
             body.axes.toB(Eigen::Vector3d::Unit(axis)), "", "eq 15 to 17")
        .detail = principal;
  return section;
}

Section startSection(const scene::Scene& scene) {
  const auto s = scene::makeMotion(scene, 0, 0)->at(0);
  Section section{"Start (motion time 0; W: inertial axes)", {}};
  section.addDetail("orientation", "orientation q, B to W (w, x, y, z)",
                    std::vector<double>{s.q_WB.w(), s.q_WB.x(), s.q_WB.y(), s.q_WB.z()}, "", "");
  section.add("omega_B", "angular velocity, in B", s.omega_B, "rad/s", "");
  section.addDetail("omega_W", "angular velocity, in W", s.omega_W, "rad/s", "");
  section.add("omega", "|omega|", s.omega_B.norm(), "rad/s", "");
  section.add("L_W", "angular momentum L, in W", s.L_W, "kg m^2/s", "eq 2, 6");
  section.add("L", "|L|", s.L_W.norm(), "kg m^2/s", "eq 18");
  section.add("T", "kinetic energy of rotation T", s.kineticEnergy, "J", "eq 12");
  return section;
}

}  // namespace poinsot::describe
