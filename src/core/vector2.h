// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "core/abi.h"

namespace poinsot::core {

/// Vector of two numbers whose layout does not depend on compiler flags. Converts to and from Eigen::Vector2d, but
/// containers do not convert: pass a std::vector<Vector2>, not a std::vector<Eigen::Vector2d>, for a
/// std::span<const Vector2>, because a compiler may align the elements of the latter.
using Vector2 = Eigen::Matrix<double, 2, 1, Eigen::DontAlign>;

static_assert(laidOut<Vector2, 16>());

}  // namespace poinsot::core
