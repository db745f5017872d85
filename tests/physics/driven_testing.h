// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/driven_motion.h"
#include "physics/driven_oracle.h"
#include "physics/random_bodies.h"
#include "physics/residual.h"

namespace poinsot::physics {

/// A driven body in its principal axes, its start and its time span.
struct DrivenCase {
  Eigen::Vector3d I{1, 1.5, 2};
  Eigen::Vector3d omega0{0.5, 1, 2};
  Eigen::Quaterniond q0 = Eigen::Quaterniond::Identity();
  Forcing forcing;
  TimeSpan span{0, 20};

  DrivenMotion motion(double tolerance_rad = DrivenMotion::kDefaultTolerance_rad) const {
    return {PrincipalMoments(I), omega0, q0, forcing, span, tolerance_rad};
  }
};

/// Returns a heavy symmetric top whose axis is tilted by 30 degrees, released with spin alone.
/// I1 = 1.40625, I3 = 0.65625 kg·m², M g l = 2.84375 N·m, spin 9.15625 rad/s.
inline DrivenCase heavyTop(double end_s) {
  DrivenCase top;
  top.I = {1.40625, 1.40625, 0.65625};
  top.omega0 = {0, 0, 9.15625};
  top.q0 = Eigen::Quaterniond(Eigen::AngleAxisd(EIGEN_PI / 6, Eigen::Vector3d::UnitX()));
  top.forcing.gravity_B = {0, 0, 2.84375};
  top.span = {0, end_s};
  return top;
}

struct DrivenResiduals {
  double attitude_rad = 0;
  double L = 0;  // kg·m²/s
};

/// Returns the largest differences from the oracle at `times` evenly spaced times on each side of t = 0.
template <typename Real = long double>
DrivenResiduals residualsOf(const DrivenCase& c, const DrivenMotion& motion, int times = 10) {
  using Oracle = DrivenOracle<Real>;
  const Oracle oracle(c.I, c.forcing);
  DrivenResiduals worst;
  for (const double end : {c.span.from_s, c.span.to_s}) {
    auto state = oracle.start(c.omega0, c.q0);
    for (int i = 1; i <= times && end != 0; ++i) {
      const double t = end * i / times;
      state = oracle.advanced(state, Real(t));
      const RigidBodyState tested = motion.at(t);
      worst.attitude_rad = std::max(worst.attitude_rad, TaylorOracle<Real>::angle(state.q, tested.q_WB));
      worst.L = std::max(worst.L, TaylorOracle<Real>::distance(Oracle::momentum_W(state), tested.L_W));
    }
  }
  return worst;
}

}  // namespace poinsot::physics
