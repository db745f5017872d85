// SPDX-License-Identifier: Apache-2.0
#include "describe/report_sections.h"
#include "physics/inertia_tensor.h"
#include "scene/body_matrix.h"
#include "scene/motion/make_motion.h"

namespace poinsot::describe {
namespace {

bool isPrincipal(const Eigen::Matrix3d& inertia_B) { return inertia_B.isDiagonal(1e-12); }

/// Returns the equations of the inertia tensor. If there are products of inertia, adds their sign, because
/// published tables use different signs.
std::string tensorSource(const Eigen::Matrix3d& inertia_B, const char* equations) {
  return std::string(equations) + (isPrincipal(inertia_B) ? "" : "; off the diagonal -(sum of m x y)");
}

using scene::BodyMatrix;

/// Adds the parts of the tensor about the pivot, whose sum it is (eq 14).
void addDisplacement(Section& section, const scene::Body& body) {
  section.addDetail("inertia_centre_B", "inertia about the centre of mass",
                    bodyMatrix(body, BodyMatrix::kInertiaCentre), "kg m^2", "eq 7, 14");
  section.addDetail("displacement_B", "a, from the centre of mass to the fixed point",
                    Eigen::Vector3d(*body.pivot_B - body.mass->centre_B()), "m", "eq 14");
  section.addDetail("inertia_displacement_B", "M(a^2 - a a), the difference of the two",
                    bodyMatrix(body, BodyMatrix::kInertiaDisplacement), "kg m^2", "eq 14");
}

/// Adds the two parts of T that a body on a pivot has with the centre of mass as reference point (eq 10, 11).
void addPartsOfT(Section& section, const scene::Body& body, const physics::RigidBodyState& s) {
  const double M = body.mass->mass_kg();
  const Eigen::Vector3d V = s.omega_B.cross(body.mass->centre_B() - *body.pivot_B);
  const Eigen::Vector3d L = body.mass->inertia_B() * s.omega_B;
  section.addDetail("T_translation", "part of T: M V^2/2 of the centre of mass", M * V.squaredNorm() / 2, "J",
                    "eq 10");
  section.addDetail("T_about_centre", "part of T: rotation about the centre of mass", s.omega_B.dot(L) / 2, "J",
                    "eq 10");
}

}  // namespace

Section ownAxesSection(const scene::Scene& scene) {
  Section section{"Axes of one's own (A, the rows of U)", {}};
  const scene::Body& body = scene.body;
  if (!body.q_BA) return section;
  const Eigen::Matrix3d inertia_A = bodyMatrix(body, BodyMatrix::kInertiaOwn);
  section.add("U_own", "U, takes components from B to A", bodyMatrix(body, BodyMatrix::kUOwn), "", "eq 15");
  section.add("inertia_own_A", "inertia tensor in A, U I U^T", inertia_A, "kg m^2", "eq 15, 16");
  section.addDetail("inertia_own_B", "the same back in B, U^T I' U", physics::turnedTensor(*body.q_BA, inertia_A),
                    "kg m^2", "eq 16");
  return section;
}

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
  if (body.mass && body.pivot_B) addDisplacement(section, body);
  section.add("principal_moments", "principal moments about e1, e2, e3", body.axes.moments().values(), "kg m^2",
              "eq 17");
  for (int axis = 0; axis < 3; ++axis)
    section
        .add("principal_axis_" + std::to_string(axis + 1) + "_B", "principal axis e" + std::to_string(axis + 1),
             body.axes.toB(Eigen::Vector3d::Unit(axis)), "", "eq 15 to 17")
        .detail = principal;
  section.addDetail("U_principal", "U of the principal axes, takes components from B to P",
                    bodyMatrix(body, BodyMatrix::kUPrincipal), "", "eq 15 to 17");
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
  section.add("T", "kinetic energy of rotation T", s.kineticEnergy, "J",
              scene.body.pivot_B ? "eq 11, 12" : "eq 12");
  if (scene.body.mass && scene.body.pivot_B) addPartsOfT(section, scene.body, s);
  return section;
}

}  // namespace poinsot::describe
