// SPDX-License-Identifier: Apache-2.0
#include "physics/reference_point.h"

#include <algorithm>

#include "physics/fixed_order.h"
#include "physics/inertia_tensor.h"

namespace poinsot::physics {

using Eigen::Vector3d;

bool ReferencePointTerms::mixedTermsVanish() const {
  constexpr double kRounding = 1e-13;
  const double mixed = std::max(turningCentre_W.norm(), displaced_W.norm());
  return mixed <= kRounding * std::max(translation_W.norm(), rotation_W.norm());
}

ReferencePointTerms referencePointTerms(const MassProperties& body, const Vector3d& K_B, const Flight& flight,
                                        const RigidBodyState& state) {
  const auto inW = [&](const Vector3d& v_B) { return turnedVector(state.q_WB, v_B); };
  const Vector3d c = inW(body.centre_B() - K_B), turning = crossProduct(state.omega_W, c);
  const Vector3d R = flight.position_W - c, V = flight.velocity_W - turning;
  const double M = body.mass_kg();
  return {R,
          V,
          c,
          M * crossProduct(R, V),
          M * crossProduct(R, turning),
          M * crossProduct(c, V),
          inW(body.inertiaAbout(K_B) * state.omega_B)};
}

}  // namespace poinsot::physics
