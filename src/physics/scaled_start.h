// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>

#include "physics/principal_moments.h"

namespace poinsot::physics {

/// Body and start in the units and the axis order of the closed form. The moments ascend. The largest moment and
/// the largest |omega| component lie in [1/2, 1), each divided by a power of two, which rounds nothing. Squares
/// therefore neither overflow nor underflow, in any units.
struct ScaledStart {
  std::array<double, 3> I{};      ///< I[0] <= I[1] <= I[2], in 2^momentExponent kg·m²
  std::array<double, 3> omega{};  ///< in the sorted axes, in 2^rateExponent rad/s
  std::array<int, 3> axis{};      ///< body axis of each sorted axis
  /// -1 if `axis` is an odd permutation, otherwise 1. For -1, sorted components are the negatives of the body's,
  /// which keeps the change of axes a proper rotation and the motion from being mirrored.
  double parity = 1;
  int momentExponent = 0;
  int rateExponent = 0;

  /// Converts sorted components to principal axes, still in scaled units.
  Eigen::Vector3d toP(const std::array<double, 3>& sorted) const;
};

/// Returns the scaled start. @throws core::Error(kPhysics) if omega0_P (rad/s) is not finite.
ScaledStart scaledStart(const PrincipalMoments& moments, const Eigen::Vector3d& omega0_P);

}  // namespace poinsot::physics
