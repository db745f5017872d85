// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "physics/principal_axes.h"
#include "physics/unaligned_types.h"

namespace poinsot::physics {

// Functions that compute the angular velocity omega_B (rad/s) at the start from other quantities. (For L given in
// B, use PrincipalAxes::angularVelocity.)

/// Returns omega_B for an angular velocity given in W. @pre q_WB is not 0; its length does not matter.
Eigen::Vector3d omegaFromSpace(const Quaternion& q_WB, const Eigen::Vector3d& omega_W);

/// Returns omega_B for an angular momentum given in W, kg·m²/s. @pre q_WB is not 0; its length does not matter.
Eigen::Vector3d omegaFromMomentum(const PrincipalAxes& axes, const Quaternion& q_WB, const Eigen::Vector3d& L_W);

/// Imperfect spin about a principal axis: L is tilted away from the axis by `tilt_rad`.
struct SpinStart {
  int axis = 2;
  double spin = 0;         ///< component of omega along the axis, rad/s; negative for the opposite sense
  double tilt_rad = 0;     ///< angle between L and the axis (the negative axis if spin < 0), in [0, pi/2)
  double towards_rad = 0;  ///< direction of the tilt: 0 to the next axis of P (cyclic), pi/2 to the one after it
};

/// Returns omega_B of an imperfect spin. With the axis k, the sign s of the spin, the tilt theta and its direction
/// phi:
///   L = |L| [s cos theta e_k + sin theta (cos phi e_k+1 + sin phi e_k+2)],    |L| cos theta = I_k |spin|
/// Source: definition of theta in eq (20), for any principal axis.
/// @throws core::Error(kPhysics) for a tilt outside [0, pi/2) or a number that is not finite.
Eigen::Vector3d omegaFromSpin(const PrincipalAxes& axes, const SpinStart& start);

/// Start given by its kinetic energy T (J) and angular momentum |L| (kg·m²/s), which determine the polhode, and by
/// a position on the polhode.
struct EnergyStart {
  double kineticEnergy = 0;
  double angularMomentum = 0;
  /// Position on the polhode, as a fraction of its period, in [0, 1). At phase 0, the component of L along the
  /// middle axis is 0, and the radius of the herpolhode is largest. The polhode runs around one extreme axis; at
  /// phase 0, the component of L along the other extreme axis is positive.
  double phase = 0;
  /// Two polhodes have this T and |L|. If true, the polhode around the negative half of its axis is selected. (On
  /// the separatrix, the axis is the axis of largest moment.)
  bool negative = false;
};

/// Returns omega_B from energy and angular momentum, by eq (38) and |m| = |L|. At phase 0, for I1 <= I2 <= I3:
///   m_1² = I1 (2 T I3 - L²)/(I3 - I1),  m_2 = 0,  m_3² = I3 (L² - 2 T I1)/(I3 - I1)
/// The result has the given T and |L| up to rounding errors (measured: 1.3e-15). A start on the separatrix, L² = 2
/// T I2, is rounded, too. Its motion therefore leaves the middle axis again after some 36/lambda. A body of equal
/// moments spins about its z axis of P.
/// @throws core::Error(kPhysics) if |L| is outside sqrt(2 T I1) to sqrt(2 T I3), naming this interval; for a phase
/// outside [0, 1); for a phase other than 0 on the separatrix, which has no period; for a number that is not
/// finite.
Eigen::Vector3d omegaFromEnergy(const PrincipalAxes& axes, const EnergyStart& start);

}  // namespace poinsot::physics
