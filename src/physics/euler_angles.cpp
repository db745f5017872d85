// SPDX-License-Identifier: Apache-2.0
#include "physics/euler_angles.h"

#include "physics/level_attitude.h"
#include "physics/require_finite.h"
#include "physics/transcendental.h"

namespace poinsot::physics {
namespace {

SineCosine checked(double angle_rad) {
  requireFinite(angle_rad, "an angle of the attitude");
  return sineCosine(angle_rad);
}

/// Returns the turn about an axis: 0, 1, 2 for x, y, z.
Quaternion turn(int axis, double angle_rad) {
  const auto [sine, cosine] = checked(angle_rad / 2);
  Eigen::Vector3d along = Eigen::Vector3d::Zero();
  along[axis] = sine;
  return {cosine, along[0], along[1], along[2]};
}

}  // namespace

Quaternion attitudeOf(const EulerAngles& angles) {
  return Quaternion(turn(2, angles.precession) * turn(0, angles.nutation) * turn(2, angles.spin));
}

Eigen::Vector3d omegaFromEulerRates(const EulerAngles& angles, const EulerAngles& rates) {
  const auto [sinTheta, cosTheta] = checked(angles.nutation);
  const auto [sinPsi, cosPsi] = checked(angles.spin);
  return rates.precession * Eigen::Vector3d(sinTheta * sinPsi, sinTheta * cosPsi, cosTheta) +
         rates.nutation * Eigen::Vector3d(cosPsi, -sinPsi, 0) + rates.spin * Eigen::Vector3d::UnitZ();
}

Quaternion attitudeOf(const RollPitchYaw& angles) {
  return Quaternion(turn(2, angles.yaw) * turn(1, angles.pitch) * turn(0, angles.roll));
}

Quaternion leaningAttitude(const Eigen::Vector3d& axis_B, double lean_rad) {
  return Quaternion(turn(0, lean_rad) * turnOntoVertical(axis_B, Vertical::kUp));
}

}  // namespace poinsot::physics
