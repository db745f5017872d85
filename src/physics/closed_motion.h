// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "physics/principal_moments.h"

namespace poinsot::physics {

/// Start of a periodic free motion: attitude and omega both repeat after `period_s`. omega0_P is in rad/s.
struct ClosedStart {
  Eigen::Vector3d omega0_P = Eigen::Vector3d::Zero();
  double period_s = 0;      ///< time until attitude and omega both repeat
  int polhodePeriods = 0;   ///< number of periods of the polhode in period_s; 0 for a steady spin
  int turns = 0;            ///< number of turns about L in period_s
  double change = 0;        ///< |omega0_P - requested omega0_P|, rad/s
  double turned_rad = 0;    ///< angle between omega0_P and the requested omega0_P
  double mismatch_rad = 0;  ///< angle between the attitudes at times 0 and period_s, due to rounding
};

/// Returns the start nearest to omega0_P, at the same |L|, whose motion repeats in about `wanted_s` seconds.
///
/// In a period Tp = 4K/lambda of the polhode, omega returns to the same direction in the body, and the body turns
/// about L by 2 DPhi (herpolhode.h). The motion therefore repeats after m periods if DPhi = pi n/m, with an
/// integer n. At a given |L|, DPhi depends only on the energy. The search finds the energies that satisfy this
/// condition and, on each polhode, the point nearest to omega0_P. It then takes the nearest of the starts whose
/// period is within a quarter of `wanted_s`. If there is no such start, it takes the start with the closest
/// period. A wobble too small to be drawn may be replaced by a steady spin. A steady spin is returned unchanged.
/// Source: docs/physics.md. Checked against the closed form by theta functions and a Taylor integrator in
/// tests/physics/closed_motion_test.cpp.
/// @throws core::Error(kPhysics) on the separatrix, where no motion repeats; for more than 1e9 periods in
/// `wanted_s`; if a value is not finite.
/// @pre wanted_s > 0.
ClosedStart nearestClosedStart(const PrincipalMoments& moments, const Eigen::Vector3d& omega0_P, double wanted_s);

}  // namespace poinsot::physics
