// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "core/abi.h"
#include "physics/flight.h"
#include "physics/mass_properties.h"
#include "physics/rigid_body_state.h"

namespace poinsot::physics {

/// Angular momentum of a rigid body about the origin, split by a reference point K of the body (eq 4): the four
/// terms of sum m (R + r) × (V + omega × r), in W, kg·m²/s. R and V are position and velocity of K, r is measured
/// from K, and c points from K to the centre of mass.
struct ReferencePointTerms {
  Eigen::Vector3d position_W;       ///< R, m
  Eigen::Vector3d velocity_W;       ///< V, m/s
  Eigen::Vector3d centre_W;         ///< c, m
  Eigen::Vector3d translation_W;    ///< R × M V
  Eigen::Vector3d turningCentre_W;  ///< R × (omega × M c), a mixed term
  Eigen::Vector3d displaced_W;      ///< M c × V, a mixed term
  Eigen::Vector3d rotation_W;       ///< I_K · omega

  /// Returns L_tot.
  Eigen::Vector3d sum_W() const { return translation_W + turningCentre_W + displaced_W + rotation_W; }
  /// Returns whether both mixed terms are 0 to rounding. They are for the centre of mass (c = 0, eq 5), and for a
  /// point that is at rest at the origin (R = V = 0, eq 2).
  bool mixedTermsVanish() const;
};

/// Returns the terms at the time of `state`.
/// @param flight  position and velocity of the centre of mass at that time
ReferencePointTerms referencePointTerms(const MassProperties& body, const Eigen::Vector3d& K_B,
                                        const Flight& flight, const RigidBodyState& state);

static_assert(core::laidOut<ReferencePointTerms, 168>());

}  // namespace poinsot::physics
