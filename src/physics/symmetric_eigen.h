// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>

#include "physics/double_double.h"

namespace poinsot::physics {

/// Eigenvalues and unit eigenvectors of a symmetric 3×3 matrix. They are not sorted, and the signs of the vectors
/// are arbitrary. Value i belongs to vector i, which the method obtains by turning axis i.
struct SymmetricEigen {
  std::array<DoubleDouble, 3> values;
  std::array<std::array<DoubleDouble, 3>, 3> vectors;
};

/// Diagonalizes a matrix by cyclic Jacobi rotations in double-double. Every eigenvalue of a positive matrix, even
/// a small one, has about 30 correct digits. The axes of nearly equal moments are therefore correct for the given
/// doubles. Uses only + - * / sqrt, so that every CPU gives the same bits.
/// Source: Demmel & Veselić, SIAM J. Matrix Anal. Appl. 13 (1992) 1204 (relative accuracy of Jacobi's method).
/// @pre finite; only the lower triangle is read.
SymmetricEigen symmetricEigen(const Eigen::Matrix3d& matrix);

}  // namespace poinsot::physics
