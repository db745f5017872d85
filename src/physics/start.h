// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "physics/principal_axes.h"
#include "physics/unaligned_types.h"

namespace poinsot::physics {

// Ways to say how a body turns at the start; each gives omega_B, rad/s. (L given in B: PrincipalAxes::
// angularVelocity.)

/// omega_B of an angular velocity given in W. @pre q_WB is not 0; its length does not matter.
Eigen::Vector3d omegaFromSpace(const Quaternion& q_WB, const Eigen::Vector3d& omega_W);

/// omega_B of an angular momentum given in W, kg·m²/s. @pre q_WB is not 0; its length does not matter.
Eigen::Vector3d omegaFromMomentum(const PrincipalAxes& axes, const Quaternion& q_WB, const Eigen::Vector3d& L_W);

/// A spin about a principal axis, thrown badly: L is off the axis by `tilt_rad`.
struct SpinStart {
  int axis = 2;            ///< of P: 0, 1, 2
  double spin = 0;         ///< component of omega along that axis, rad/s; negative spins the other way
  double tilt_rad = 0;     ///< angle between L and the axis (its negative where spin < 0), in [0, pi/2)
  double towards_rad = 0;  ///< the side that L leans to: 0 the next axis of P (cyclic), pi/2 the one after it
};

/// With k the axis, s the sign of the spin, theta the tilt, phi the side:
///   L = |L| [s cos theta e_k + sin theta (cos phi e_k+1 + sin phi e_k+2)],    |L| cos theta = I_k |spin|
/// Source: definition of theta in eq (20), for any principal axis.
/// @throws core::Error(kPhysics) for a tilt outside [0, pi/2) or a number that is not finite.
Eigen::Vector3d omegaFromSpin(const PrincipalAxes& axes, const SpinStart& start);

/// Energy and angular momentum, which fix the polhode, and a place on it.
struct EnergyStart {
  double kineticEnergy = 0;    ///< T, J
  double angularMomentum = 0;  ///< |L|, kg·m²/s
  /// Part of the polhode's period, in [0, 1). 0 is where L has no component along the axis of middle moment (the
  /// largest radius of the herpolhode) and a positive one along the extreme axis that the polhode does not
  /// circle.
  double phase = 0;
  /// Of the two polhodes with this T and |L|: round the negative half of the axis. (On the separatrix, that of
  /// largest moment.)
  bool negative = false;
};

/// At phase 0:  m_1² = I1 (2 T I3 - L²)/(I3 - I1),  m_2 = 0,  m_3² = I3 (L² - 2 T I1)/(I3 - I1),   I1 <= I2 <= I3;
/// the solution of eq (38) and |m| = |L|. T and |L| of the result are those given to a few roundings (measured
/// 1.3e-15). So L² = 2 T I2 is met to rounding too: such a start leaves the middle axis again after some
/// 36/lambda. A body of equal moments spins about its z axis P.
/// @throws core::Error(kPhysics) if |L| is outside sqrt(2 T I1) to sqrt(2 T I3), with that interval; for a phase
/// outside [0, 1); for a phase other than 0 on the separatrix, which has no period; for what is not finite.
Eigen::Vector3d omegaFromEnergy(const PrincipalAxes& axes, const EnergyStart& start);

}  // namespace poinsot::physics
