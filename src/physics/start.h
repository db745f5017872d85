// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "physics/principal_axes.h"
#include "physics/unaligned_types.h"

namespace poinsot::physics {

// Ways to specify the rotation at the start; each function returns omega_B, rad/s. (For L given in B, use
// PrincipalAxes::angularVelocity.)

/// Returns omega_B for an angular velocity given in W. @pre q_WB is not 0; its length does not matter.
Eigen::Vector3d omegaFromSpace(const Quaternion& q_WB, const Eigen::Vector3d& omega_W);

/// Returns omega_B for an angular momentum given in W, kg·m²/s. @pre q_WB is not 0; its length does not matter.
Eigen::Vector3d omegaFromMomentum(const PrincipalAxes& axes, const Quaternion& q_WB, const Eigen::Vector3d& L_W);

/// Imperfect spin about a principal axis: L is off the axis by `tilt_rad`.
struct SpinStart {
  int axis = 2;
  double spin = 0;         ///< component of omega along that axis, rad/s; negative for the opposite sense
  double tilt_rad = 0;     ///< angle between L and the axis (the negative axis if spin < 0), in [0, pi/2)
  double towards_rad = 0;  ///< side to which L leans: 0 to the next axis of P (cyclic), pi/2 to the one after it
};

/// Returns omega_B of an imperfect spin. With the axis k, the sign s of the spin, the tilt theta and the side phi:
///   L = |L| [s cos theta e_k + sin theta (cos phi e_k+1 + sin phi e_k+2)],    |L| cos theta = I_k |spin|
/// Source: definition of theta in eq (20), for any principal axis.
/// @throws core::Error(kPhysics) for a tilt outside [0, pi/2) or a number that is not finite.
Eigen::Vector3d omegaFromSpin(const PrincipalAxes& axes, const SpinStart& start);

/// Kinetic energy T (J) and angular momentum |L| (kg·m²/s), which fix the polhode, and a place on the polhode.
struct EnergyStart {
  double kineticEnergy = 0;
  double angularMomentum = 0;
  /// Fraction of the polhode's period, in [0, 1). At phase 0, L has no component along the middle axis (the
  /// largest radius of the herpolhode) and a positive one along the extreme axis that the polhode does not circle.
  double phase = 0;
  /// Selects, of the two polhodes with this T and |L|, the one round the negative half of its axis. (On the
  /// separatrix, the axis is that of largest moment.)
  bool negative = false;
};

/// Returns omega_B from energy and angular momentum, by eq (38) and |m| = |L|. At phase 0, for I1 <= I2 <= I3:
///   m_1² = I1 (2 T I3 - L²)/(I3 - I1),  m_2 = 0,  m_3² = I3 (L² - 2 T I1)/(I3 - I1)
/// The result has the given T and |L| to a few roundings (measured 1.3e-15). L² = 2 T I2 is met to rounding too:
/// such a start leaves the middle axis again after some 36/lambda. A body of equal moments spins about its z axis
/// of P.
/// @throws core::Error(kPhysics) if |L| is outside sqrt(2 T I1) to sqrt(2 T I3), with that interval; for a phase
/// outside [0, 1), or other than 0 on the separatrix, which has no period; for a number that is not finite.
Eigen::Vector3d omegaFromEnergy(const PrincipalAxes& axes, const EnergyStart& start);

}  // namespace poinsot::physics
