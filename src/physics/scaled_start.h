// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>

#include "physics/principal_moments.h"

namespace poinsot::physics {

/// A body and its start in the units and the axis order of the closed form.
///
/// Moments ascend; the largest lies in [1/2, 1), and so does the largest |omega|: both are divided by a power of
/// two, which rounds nothing, so squares neither overflow nor underflow whatever the units of the user.
struct ScaledStart {
  std::array<double, 3> I{};      ///< I[0] <= I[1] <= I[2], in 2^momentExponent kg·m²
  std::array<double, 3> omega{};  ///< in the sorted axes, in 2^rateExponent rad/s
  std::array<int, 3> axis{};      ///< body axis of each sorted axis
  /// -1 when `axis` is an odd permutation: sorted components are then the negatives of the body's, which keeps the
  /// change of axes a proper rotation (else the motion would be its mirror image).
  double parity = 1;
  int momentExponent = 0;
  int rateExponent = 0;

  /// Sorted components to those in the principal axes, still in scaled units.
  Eigen::Vector3d toP(const std::array<double, 3>& sorted) const;
};

/// @throws core::Error(kPhysics) if omega0_P (rad/s) is not finite.
ScaledStart scaledStart(const PrincipalMoments& moments, const Eigen::Vector3d& omega0_P);

}  // namespace poinsot::physics
