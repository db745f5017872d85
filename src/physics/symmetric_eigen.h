// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>

#include "physics/double_double.h"

namespace poinsot::physics {

/// Eigenvalues and unit eigenvectors of a symmetric 3×3 matrix, neither sorted nor with fixed signs. Value i
/// belongs to the vector that the method turned out of axis i.
struct SymmetricEigen {
  std::array<DoubleDouble, 3> values;
  std::array<std::array<DoubleDouble, 3>, 3> vectors;
};

/// Diagonalizes a matrix by cyclic Jacobi rotations in double-double. Every eigenvalue of a positive matrix has
/// about 30 right digits, small ones included, so that the axes of nearly equal moments are those of the given
/// doubles. Uses only + - * / sqrt, so every CPU gives the same bits.
/// Source: Demmel & Veselić, SIAM J. Matrix Anal. Appl. 13 (1992) 1204 (relative accuracy of Jacobi's method).
/// @pre finite; only the lower triangle is read.
SymmetricEigen symmetricEigen(const Eigen::Matrix3d& matrix);

}  // namespace poinsot::physics
