// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "core/abi.h"
#include "physics/principal_moments.h"

namespace poinsot::physics {

/// Poinsot's construction of a free rotation, in omega space. The energy ellipsoid is fixed in the body, with its
/// centre at rest, and rolls on the invariable plane. The point of contact is the tip of omega. Source: lecture,
/// appendix, eq (38) to (40).
class PoinsotConstruction {
 public:
  /// @param omega_P angular velocity at any one time of the motion, rad/s
  /// @throws core::Error(kPhysics) if the body is at rest (no plane, no ellipsoid) or omega_P is not finite.
  PoinsotConstruction(const PrincipalMoments& moments, const Eigen::Vector3d& omega_P);

  /// Returns the constant distance of the invariable plane from the centre, rad/s: h = omega·L/|L| = 2T/|L| (eq
  /// 40). The plane lies at h L/|L| and is normal to L.
  double planeHeight() const { return planeHeight_; }

  /// Returns the semi-axes of the energy ellipsoid along the principal axes, rad/s: sqrt(2T/I_i) (eq 38).
  const Eigen::Vector3d& semiAxes_P() const { return semiAxes_P_; }

 private:
  double planeHeight_ = 0;
  Eigen::Vector3d semiAxes_P_;
};

static_assert(core::laidOut<PoinsotConstruction, 32>());

}  // namespace poinsot::physics
