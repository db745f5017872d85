// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "physics/free_motion.h"
#include "physics/unaligned_types.h"

namespace poinsot::physics {

/// Rotation in closed form under drag with the same rate d about all axes. The solution of m' = m × omega - d m
/// follows from a free motion m_free, R_free at the time tau = (1 - e^(-d t))/d:
///
///   m(t) = e^(-d t) m_free(tau),      R(t) = R_free(tau)
///
/// The reason is that m' = e^(-dt) (e^(-dt) m_free × omega_free - d m_free). With d = 0 the motion is free.
class DecayingMotion final : public Motion {
 public:
  /// @throws core::Error(kPhysics) as FreeMotion does. @pre rate >= 0, in 1/s.
  DecayingMotion(const PrincipalAxes& axes, const Eigen::Vector3d& omega0_B, const Quaternion& q0_WB, double rate)
      : free_(axes, omega0_B, q0_WB), rate_(rate) {}

  RigidBodyState at(double t_s) const override;
  /// Returns the state at t_s, or nullopt if at() would throw.
  std::optional<RigidBodyState> find(double t_s) const;

  const PrincipalAxes& axes() const override { return free_.axes(); }
  double dissipation() const override { return 0; }

 private:
  FreeMotion free_;
  double rate_;
};

}  // namespace poinsot::physics
