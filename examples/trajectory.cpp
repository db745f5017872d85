// SPDX-License-Identifier: Apache-2.0
// Throws a hammer that spins about its head, the axis of the middle moment, and therefore flips. The motion is
// known at any time; this program prints it at 13 of them.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "physics/free_motion.h"
#include "physics/mass_properties.h"

using namespace poinsot;

int main() {
  // Lengths in metres, masses in kilograms. In the axes B chosen here, the handle is along z, the head along y.
  const physics::SolidPart handle{physics::Cylinder{.radius_m = 0.012, .height_m = 0.30}, 0.15};
  physics::SolidPart head{physics::Box{{0.03, 0.12, 0.03}}, 0.50};
  head.offset_B = {0, 0, 0.15};
  const physics::MassProperties hammer = massProperties(handle) + massProperties(head);
  const physics::PrincipalAxes axes(hammer.inertia_B());

  const Eigen::Vector3d omega0_B(0.1, 8, 0.1);  // rad/s, nearly about the head's axis
  const physics::FreeMotion motion(axes, omega0_B, Eigen::Quaterniond::Identity());

  std::printf("moments %.6e %.6e %.6e kg m^2\n", axes.inertia_B()(0, 0), axes.inertia_B()(1, 1),
              axes.inertia_B()(2, 2));
  std::printf("   t (s)    omega in the body (rad/s)     head to L (deg)\n");
  for (int k = 0; k <= 12; ++k) {
    const physics::RigidBodyState state = motion.at(0.25 * k);
    const Eigen::Vector3d head_W = state.q_WB * Eigen::Vector3d::UnitY();
    const double angle_deg = std::acos(head_W.dot(motion.L_W().normalized())) * 180 / std::numbers::pi;
    std::printf("%8.2f %9.4f %9.4f %9.4f %15.2f\n", state.t_s, state.omega_B.x(), state.omega_B.y(),
                state.omega_B.z(), angle_deg);
  }
}
