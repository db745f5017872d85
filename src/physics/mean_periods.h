// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/abi.h"
#include "physics/principal_axes.h"

namespace poinsot::physics {

/// Axis around which L circles in the body, in the words of astronomers: the short axis, which has the largest
/// moment (SAM), or the long axis, which has the smallest moment (LAM).
enum class AxisMode { kShort, kLong };

/// The two periods of a tumbling body. P_phi is the mean time in which its long axis goes once round L in space.
/// P_psi is the period of the rotation about the long axis: of a full turn if L circles the long axis, of a swing
/// if L circles the short axis. P_psi is the period of the polhode. Source: Samarasinha & A'Hearn, Icarus 93
/// (1991) 194; Kaasalainen, Astron. Astrophys. 376 (2001) 302.
struct MeanPeriods {
  double phi_s = 0;
  double psi_s = 0;
  AxisMode mode = AxisMode::kShort;
};

/// Returns the two periods of a free rotation; nullopt if it is steady, or on the separatrix, or if two moments
/// are equal, so that the body has no long axis.
/// @param omega0_P angular velocity in principal axes, rad/s
/// @throws core::Error(kPhysics) if omega0_P is not finite.
std::optional<MeanPeriods> meanPeriods(const PrincipalMoments& moments, const Eigen::Vector3d& omega0_P);

/// Start given by the two periods that astronomers publish, and by a position on the polhode as in EnergyStart.
struct PeriodStart {
  double phi_s = 0, psi_s = 0;
  std::optional<AxisMode> mode = {};  ///< needed only if both modes have these periods
  double phase = 0;
  bool negative = false;
};

/// Returns omega_B, rad/s, of the rotation with these two periods. Their ratio sets L²/2T, because P_psi/P_phi
/// rises from a least value at a steady spin to infinity at the separatrix. P_phi then sets |L|.
/// @throws core::Error(kPhysics) if two moments are equal; if the ratio is below the least value, with this value;
/// if both modes have the ratio and no mode is given; if a number is not finite or not positive
Eigen::Vector3d omegaFromPeriods(const PrincipalAxes& axes, const PeriodStart& start);

static_assert(core::laidOut<MeanPeriods, 24>());

}  // namespace poinsot::physics
