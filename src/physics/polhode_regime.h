// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/abi.h"

namespace poinsot::physics {

/// Kind of a free rotation, by the curve that the angular velocity draws on the energy ellipsoid.
enum class PolhodeRegime {
  kSteady,         ///< a point: rest, spin about a principal axis, any spin of a sphere
  kAboutLargest,   ///< a closed curve about the axis of largest moment (L^2 > 2 T I_mid)
  kAboutSmallest,  ///< a closed curve about the axis of smallest moment (L^2 < 2 T I_mid)
  kSeparatrix,     ///< half a curve, from the middle axis to the opposite direction (L^2 = 2 T I_mid exactly)
};

}  // namespace poinsot::physics
