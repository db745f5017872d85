// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <string>

#include "physics/driven_motion.h"
#include "physics/free_motion.h"
#include "physics/mass_properties.h"
#include "physics/precession_cones.h"

namespace poinsot {

/// Text of numbers with all their bits.
class BitText {
 public:
  BitText& operator<<(double number) {
    char text[40];
    std::snprintf(text, sizeof text, "%a\n", number);
    text_ += text;
    return *this;
  }
  BitText& operator<<(const Eigen::Vector3d& v) { return *this << v[0] << v[1] << v[2]; }
  BitText& operator<<(const physics::RigidBodyState& s) {
    return *this << s.t_s << s.q_WB.w() << s.q_WB.x() << s.q_WB.y() << s.q_WB.z() << s.omega_B << s.omega_W
                 << s.L_W << s.kineticEnergy;
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// Returns results of the physics as a text. A consumer of the library and a test of this project compile this
/// same source. The library computes all numbers; this function only passes them on by value, by reference, in
/// structs, and as aligned and unaligned types of Eigen.
inline std::string stateBits() {
  using namespace physics;
  BitText bits;
  SolidPart head;
  head.solid = LPlate{Eigen::Vector2d(0.3, 0.2), 0.04};
  head.mass_kg = 0.5;
  head.q_BS = Eigen::Quaterniond(0.8, 0, 0.6, 0);
  head.offset_B = {0, 0.1, 0.15};
  const MassProperties hammer = massProperties(Cylinder{0.012, 0.3, 0}, 0.15) + massProperties(head);
  const PrincipalAxes axes(hammer.inertia_B());
  bits << hammer.mass_kg() << hammer.centre_B() << axes.moments().values() << axes.q_BP().x() << axes.q_BP().w();

  const Eigen::Vector3d omega_B(0.1, 0.7, 0.3);
  const PrincipalMoments moments(Eigen::Vector3d(1.1, 2.2, 2.5));
  bits << moments.kineticEnergy(omega_B) << moments.angularMomentum(omega_B);
  if (const auto cones = precessionCones(PrincipalMoments(Eigen::Vector3d(1.1, 1.1, 0.7)), omega_B))
    bits << cones->parts(omega_B, cones->k_P).precession << cones->precessionRate;

  const Eigen::Quaterniond q0_WB(0.5, -0.1, 0.7, 0.3);
  const FreeMotion free(axes, omega_B, q0_WB);
  Forcing drag;
  drag.dragRate_P = {0.1, 0.2, 0.3};
  drag.torque_W = {0, 0, 1e-3};
  const DrivenMotion driven(axes, omega_B, q0_WB, drag, TimeSpan{0, 2}, 1e-12, 1e6);
  for (const double t : {0.0, 0.25, 1.0, 1.9}) bits << free.at(t) << driven.at(t);
  bits << free.at(1e6) << potentialEnergy(drag, free.at(1).q_WB);
  return bits.text();
}

}  // namespace poinsot
