// SPDX-License-Identifier: Apache-2.0
#include "physics/possible_inertia.h"

#include <algorithm>
#include <array>

#include "physics/symmetric_eigen.h"

namespace poinsot::physics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Returns the orthogonal projection of ascending numbers onto the cone a, b, c >= 0, c <= a + b.
///
/// The cone has three faces, with the inward normals (1, 1, -1), (1, -1, 1) and (-1, 1, 1), and three edges, such
/// as (0, 1, 1). Ascending numbers outside the cone violate c <= a + b, and their projection ascends, too. It lies
/// on this face, otherwise on the edge (0, 1, 1), otherwise at the apex. A test checks the conditions of Moreau
/// (1962): the change is normal to the result and at 90° or more to every edge.
Vector3d projected(const Vector3d& ascending) {
  const auto& [a, b, c] = std::array{ascending[0], ascending[1], ascending[2]};
  const double excess = (c - a - b) / 3;
  if (excess <= 0) return ascending;
  if (b + excess <= (a + excess) + (c - excess)) return {a + excess, b + excess, c - excess};
  const double edge = std::max(0., (b + c) / 2);
  return {0, edge, edge};
}

}  // namespace

std::optional<Vector3d> nearestPossibleMoments(const Vector3d& moments) {
  if (!moments.allFinite()) return std::nullopt;
  std::array<int, 3> order{0, 1, 2};
  std::ranges::stable_sort(order, {}, [&](int i) { return moments[i]; });
  Vector3d ascending = projected({moments[order[0]], moments[order[1]], moments[order[2]]});
  ascending[0] = std::max(ascending[0], kLeastOfNearest * ascending[2]);
  if (!(ascending[0] > 0)) return std::nullopt;
  Vector3d nearest;
  for (int i = 0; i < 3; ++i) nearest[order[static_cast<std::size_t>(i)]] = ascending[i];
  return nearest;
}

std::optional<Matrix3d> nearestPossibleTensor(const Matrix3d& inertia) {
  if (!inertia.allFinite()) return std::nullopt;
  const SymmetricEigen eigen = symmetricEigen(inertia);
  const auto moments =
      nearestPossibleMoments({toDouble(eigen.values[0]), toDouble(eigen.values[1]), toDouble(eigen.values[2])});
  if (!moments) return std::nullopt;
  Matrix3d nearest;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j <= i; ++j) {
      DoubleDouble sum;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& axis = eigen.vectors[k];
        sum += (*moments)[static_cast<int>(k)] * axis[static_cast<std::size_t>(i)] *
               axis[static_cast<std::size_t>(j)];
      }
      nearest(i, j) = nearest(j, i) = toDouble(sum);
    }
  return nearest;
}

}  // namespace poinsot::physics
