// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "core/abi.h"
#include "physics/polhode_regime.h"
#include "physics/principal_moments.h"

namespace poinsot::physics {

struct FreeMotionConstants;

/// Point of the polhode (rad/s), with the time at which omega is there.
struct PolhodeSample {
  double t_s = 0;
  Eigen::Vector3d omega_P = Eigen::Vector3d::Zero();
};

/// Polhode: the curve that omega draws in the body, on the energy ellipsoid and on the ellipsoid |I omega| = |L|.
/// Immutable.
class Polhode {
 public:
  /// @param omega0_P angular velocity at t = 0, in principal axes, rad/s
  /// @throws core::Error(kPhysics) if omega0_P is not finite.
  Polhode(const PrincipalMoments& moments, const Eigen::Vector3d& omega0_P);

  PolhodeRegime regime() const;

  /// Returns the time in which omega goes around the polhode once, 4K/lambda, s. The time is 0 for a steady
  /// motion, and infinite on the separatrix.
  double period() const;

  /// Returns points of the polhode. They are spread evenly in the parameter a of m = (A_a cos a, A_2 sin a, A_c
  /// sqrt(1 - k^2 sin^2 a)). Points at equal times would accumulate near the middle axis. A closed curve has
  /// `count` points, from omega0 in the direction of the motion. Their times ascend within one period, and the
  /// curve closes from the last point to the first. The separatrix has `count` points, from one end on the middle
  /// axis (t = -inf) to the other (t = +inf). A steady motion has one point. @pre count >= 4.
  std::vector<PolhodeSample> samples(int count) const;

 private:
  std::shared_ptr<const FreeMotionConstants> constants_;
};

static_assert(core::laidOut<PolhodeSample, 32>());

}  // namespace poinsot::physics
