// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>

#include "physics/double_double.h"

namespace poinsot::physics {

/// Eigenvalues and eigenvectors of a symmetric 3×3 matrix. Neither sorted nor signed: value i belongs to the
/// vector that the method turned out of axis i.
struct SymmetricEigen {
  std::array<DoubleDouble, 3> values;
  std::array<std::array<DoubleDouble, 3>, 3> vectors;  ///< vectors[i] is of unit length
};

/// Cyclic Jacobi in double-double: about 30 digits of every eigenvalue of a positive matrix, the small ones
/// included, so that the axes of nearly equal moments are those of the given doubles. Only + - * / sqrt, so the
/// same bits everywhere.
/// Source: Demmel & Veselić, SIAM J. Matrix Anal. Appl. 13 (1992) 1204 (relative accuracy of Jacobi's method).
/// @pre finite; only the lower triangle is read.
SymmetricEigen symmetricEigen(const Eigen::Matrix3d& matrix);

}  // namespace poinsot::physics
