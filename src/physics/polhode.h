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

/// Point of the polhode (rad/s), with the first time at or after the start at which omega is there.
struct PolhodeSample {
  double t_s = 0;
  Eigen::Vector3d omega_P = Eigen::Vector3d::Zero();
};

/// Polhode: the curve that omega draws in the body, where the energy ellipsoid meets the ellipsoid |I omega| =
/// |L|. Immutable.
class Polhode {
 public:
  /// @param omega0_P angular velocity at t = 0, in principal axes, rad/s
  /// @throws core::Error(kPhysics) if omega0_P is not finite.
  Polhode(const PrincipalMoments& moments, const Eigen::Vector3d& omega0_P);

  PolhodeRegime regime() const;

  /// Returns the time of one turn of omega in the body, s: 4K/lambda. 0 if steady, infinite on the separatrix.
  double period() const;

  /// Returns points spread evenly in the parameter a of m = (A_a cos a, A_2 sin a, A_c sqrt(1 - k^2 sin^2 a));
  /// spread evenly in time, they would pile up near the middle axis. A closed curve has `count` points from omega0
  /// in the sense of the motion, with t ascending within one period; the last point joins the first. The
  /// separatrix has `count` points from one end on the middle axis (t = -inf) to the other (t = +inf). A steady
  /// motion has one point. @pre count >= 4.
  std::vector<PolhodeSample> samples(int count) const;

 private:
  std::shared_ptr<const FreeMotionConstants> constants_;
};

static_assert(core::laidOut<PolhodeSample, 32>());

}  // namespace poinsot::physics
