// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "core/abi.h"
#include "physics/principal_moments.h"

namespace poinsot::physics {

/// Poinsot's picture of a free rotation, in omega space: the energy ellipsoid, fixed in the body with its centre
/// at rest, rolls on the invariable plane; the point of contact is the tip of omega. Source: lecture, appendix, eq
/// (38) to (40).
class PoinsotConstruction {
 public:
  /// omega_P in rad/s at any one time of the motion.
  /// @throws core::Error(kPhysics) if the body is at rest (no plane, no ellipsoid) or omega_P is not finite.
  PoinsotConstruction(const PrincipalMoments& moments, const Eigen::Vector3d& omega_P);

  /// Distance of the invariable plane from the centre, rad/s, constant: h = omega·L/|L| = 2T/|L| (eq 40). The
  /// plane lies at h L/|L| and is normal to L.
  double planeHeight() const { return planeHeight_; }

  /// Semi-axes of the energy ellipsoid along the principal axes, rad/s: sqrt(2T/I_i) (eq 38).
  const Eigen::Vector3d& semiAxes_P() const { return semiAxes_P_; }

 private:
  double planeHeight_ = 0;
  Eigen::Vector3d semiAxes_P_;
};

static_assert(core::laidOut<PoinsotConstruction, 32>());

}  // namespace poinsot::physics
