// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/symmetric_top.h"

#include <fmt/format.h>

#include "core/error.h"

namespace poinsot::stage {

using Eigen::Vector3d;

bool isSymmetric(const PictureMotion& motion) {
  return physics::precessionCones(motion.moments(), Vector3d::UnitZ()).has_value();
}

physics::PrecessionCones precessionOf(const PictureMotion& motion, const char* key) {
  const auto refuse = [key](const char* why) {
    return core::Error(core::ErrorKind::kScene, fmt::format("{}: {}", key, why));
  };
  if (!motion.isFree()) throw refuse("a steady precession exists only if nothing acts on the body; leave it out");
  const auto cones = physics::precessionCones(motion.moments(), motion.liveliest().omega_P);
  if (!cones)
    throw refuse(
        "only a rotating symmetric top precesses steadily: give two equal principal moments, or leave it out");
  return *cones;
}

physics::PrecessionCones triadOf(const PictureMotion& motion, const char* key) {
  const physics::PrecessionCones cones = precessionOf(motion, key);
  if (cones.tilt_rad > 0) return cones;
  throw core::Error(core::ErrorKind::kScene,
                    fmt::format("{}: L lies along the axis k, and they have no common plane; leave it out", key));
}

// The moments across k are equal, so that L and omega have the same direction across k. That of omega is exact.
Eigen::Matrix3d triad_V(const PictureState& state, const physics::PrecessionCones& cones) {
  Vector3d i_P = state.omega_P;
  i_P[cones.axis] = 0;
  i_P.normalize();
  Eigen::Matrix3d axes_P;
  axes_P << i_P, cones.k_P.cross(i_P), cones.k_P;
  return state.R_VP * axes_P;
}

Vector3d mainAxis_P(const PictureMotion& motion) {
  if (motion.rolling()) return motion.axes().toP(motion.rolling()->cone.axis_B);
  const Vector3d omega_P = motion.outline().front().omega_P;
  if (const auto cones = physics::precessionCones(motion.moments(), omega_P)) return cones->k_P;
  int axis = 0;
  omega_P.cwiseAbs().maxCoeff(&axis);
  return (omega_P[axis] < 0 ? -1 : 1) * Vector3d::Unit(axis);
}

}  // namespace poinsot::stage
