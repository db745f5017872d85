// SPDX-License-Identifier: Apache-2.0
#include "physics/poinsot_construction.h"

#include <cmath>

#include "core/error.h"
#include "physics/free_motion_constants.h"

namespace poinsot::physics {

PoinsotConstruction::PoinsotConstruction(const PrincipalMoments& moments, const Eigen::Vector3d& omega_P) {
  const FreeMotionConstants k = freeMotionConstants(moments, omega_P);
  if (k.L == DoubleDouble(0))
    throw core::physicsError(
        "the body is at rest: the Poinsot construction needs an angular velocity other than 0");
  planeHeight_ = std::ldexp(toDouble(k.twoT / k.L), k.start.rateExponent);
  for (std::size_t i = 0; i < 3; ++i)
    semiAxes_P_[k.start.axis[i]] = std::ldexp(toDouble(sqrt(k.twoT / k.start.I[i])), k.start.rateExponent);
}

}  // namespace poinsot::physics
