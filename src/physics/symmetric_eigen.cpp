// SPDX-License-Identifier: Apache-2.0
#include "physics/symmetric_eigen.h"

#include <algorithm>
#include <cmath>

namespace poinsot::physics {
namespace {

// Limit on the number of sweeps. Four or five are usual; only a matrix that is not positive may reach the limit.
constexpr int kMostSweeps = 40;
// An off-diagonal entry below this fraction of both its diagonal entries no longer changes them in double-double.
constexpr double kNegligibleEntry = 0x1p-110;
// An entry below this fraction of the largest entry changes no result.
constexpr double kVanishing = 0x1p-300;

using Row = std::array<DoubleDouble, 3>;

struct Iteration {
  std::array<Row, 3> a;
  std::array<Row, 3> vectors{Row{1, 0, 0}, Row{0, 1, 0}, Row{0, 0, 1}};

  /// Zeroes a[p][q] by a rotation of at most 45° in the plane (p, q). Returns false if a[p][q] is already
  /// negligible.
  bool annihilate(std::size_t p, std::size_t q) {
    const DoubleDouble off = a[p][q];
    const double least = std::min(std::fabs(a[p][p].hi), std::fabs(a[q][q].hi));
    if (std::fabs(off.hi) <= std::max(kNegligibleEntry * least, kVanishing)) return false;
    const DoubleDouble theta = (a[q][q] - a[p][p]) / (2 * off);
    const DoubleDouble root = abs(theta) + sqrt(theta * theta + 1);
    const DoubleDouble tangent = theta.hi < 0 ? -(1 / root) : 1 / root;
    const DoubleDouble cosine = 1 / sqrt(tangent * tangent + 1), sine = tangent * cosine;
    a[p][p] -= tangent * off;
    a[q][q] += tangent * off;
    a[p][q] = a[q][p] = 0;
    const std::size_t r = 3 - p - q;
    turn(a[p][r], a[q][r], cosine, sine);
    a[r][p] = a[p][r];
    a[r][q] = a[q][r];
    for (std::size_t i = 0; i < 3; ++i) turn(vectors[p][i], vectors[q][i], cosine, sine);
    return true;
  }

  static void turn(DoubleDouble& x, DoubleDouble& y, const DoubleDouble& cosine, const DoubleDouble& sine) {
    const DoubleDouble before = x;
    x = cosine * before - sine * y;
    y = sine * before + cosine * y;
  }
};

}  // namespace

SymmetricEigen symmetricEigen(const Eigen::Matrix3d& matrix) {
  // Brings the largest entry near 1, so that no square overflows.
  const int exponent = exponentOf(matrix.cwiseAbs().maxCoeff());
  Iteration iteration;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const double entry = matrix(static_cast<int>(std::max(i, j)), static_cast<int>(std::min(i, j)));
      iteration.a[i][j] = std::ldexp(entry, -exponent);
    }
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    const bool first = iteration.annihilate(0, 1), second = iteration.annihilate(0, 2),
               third = iteration.annihilate(1, 2);
    if (!first && !second && !third) break;
  }
  SymmetricEigen result{{}, iteration.vectors};
  for (std::size_t i = 0; i < 3; ++i) result.values[i] = scaled(iteration.a[i][i], exponent);
  return result;
}

}  // namespace poinsot::physics
