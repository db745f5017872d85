// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "physics/principal_moments.h"

namespace poinsot::physics {

/// A start of a free motion after which the whole state, attitude included, comes back.
struct ClosedStart {
  Eigen::Vector3d omega0_P = Eigen::Vector3d::Zero();  ///< rad/s
  double period_s = 0;                                 ///< of attitude and omega together
  int polhodePeriods = 0;                              ///< in that time; 0: steady spin, omega never changes
  int turns = 0;                                       ///< about L in that time
  double change = 0;                                   ///< |omega0_P - the one asked for|, rad/s
  double turned_rad = 0;                               ///< angle between the two
  double mismatch_rad = 0;  ///< angle between the attitudes at 0 and at period_s: what rounding leaves
};

/// The start nearest to omega0_P, at the same |L|, whose motion repeats in about `wanted_s`.
///
/// In a period Tp = 4K/lambda of the polhode omega returns in the body, and the body has turned about L by 2 DPhi
/// (herpolhode.h). So the motion repeats after m periods where DPhi = pi n/m. At a given |L|, DPhi depends on the
/// energy alone: the energies that close are found, and on the polhode of each the point nearest to omega0_P, by
/// |omega0 - omega0_P|. Of the starts that repeat within a quarter of `wanted_s` the nearest is taken; where there
/// is none, the one that repeats soonest after or before it. A wobble too small to be drawn may be left out. A
/// steady spin closes as it is. Source: docs/physics.md; checked against the closed form by theta functions and a
/// Taylor integrator in tests/physics/closed_motion_test.cpp.
/// @throws core::Error(kPhysics) on the separatrix, where nothing repeats; for what is not finite.
/// @pre wanted_s > 0.
ClosedStart nearestClosedStart(const PrincipalMoments& moments, const Eigen::Vector3d& omega0_P, double wanted_s);

}  // namespace poinsot::physics
