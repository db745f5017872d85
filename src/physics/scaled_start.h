// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>

#include "physics/principal_moments.h"

namespace poinsot::physics {

/// Moments and angular velocity of a start, in the units and the axis order of the closed form. The axes are
/// sorted by ascending moment. The moments are divided by a power of two, without rounding, so that the largest
/// lies in [1/2, 1); so are the components of omega. Squares therefore neither overflow nor underflow.
struct ScaledStart {
  std::array<double, 3> I{};      ///< moments I[0] <= I[1] <= I[2], in 2^momentExponent kg·m²
  std::array<double, 3> omega{};  ///< angular velocity along the sorted axes, in 2^rateExponent rad/s
  std::array<int, 3> axis{};      ///< index in P of each sorted axis
  /// -1 if `axis` is an odd permutation, otherwise 1. Sorted components are multiplied by this sign. The change of
  /// axes is then a proper rotation, and does not mirror the motion.
  double parity = 1;
  int momentExponent = 0;
  int rateExponent = 0;

  /// Converts components along the sorted axes to components along the principal axes, still in scaled units.
  Eigen::Vector3d toP(const std::array<double, 3>& sorted) const;
};

/// Sorts and scales a start. @throws core::Error(kPhysics) if omega0_P (rad/s) is not finite.
ScaledStart scaledStart(const PrincipalMoments& moments, const Eigen::Vector3d& omega0_P);

}  // namespace poinsot::physics
