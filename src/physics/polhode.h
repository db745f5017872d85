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

/// A point of the polhode and the first time at or after the start that omega is there.
struct PolhodeSample {
  double t_s = 0;
  Eigen::Vector3d omega_P = Eigen::Vector3d::Zero();  ///< rad/s
};

/// The curve that omega draws in the body: where the energy ellipsoid meets the ellipsoid |I omega| = |L|.
/// Immutable.
class Polhode {
 public:
  /// omega0_P in rad/s, in principal axes, at t = 0. @throws core::Error(kPhysics) if it is not finite.
  Polhode(const PrincipalMoments& moments, const Eigen::Vector3d& omega0_P);

  PolhodeRegime regime() const;

  /// Time of one turn of omega in the body, s: 4K/lambda. 0 when steady, infinite on the separatrix.
  double period() const;

  /// Points spread evenly in the parameter a of m = (A_a cos a, A_2 sin a, A_c sqrt(1 - k^2 sin^2 a)), not in
  /// time: in time they would pile up near the middle axis. Closed curve: `count` points from omega0 in the sense
  /// of the motion, t ascending within one period; the last joins the first. Separatrix: `count` points from one
  /// end on the middle axis (t = -inf) to the other (t = +inf). Steady: the one point. @pre count >= 4.
  std::vector<PolhodeSample> samples(int count) const;

 private:
  std::shared_ptr<const FreeMotionConstants> constants_;
};

static_assert(core::laidOut<PolhodeSample, 32>());

}  // namespace poinsot::physics
