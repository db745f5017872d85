// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "core/abi.h"

namespace poinsot::core {

/// Vector of two numbers with the same layout under all compiler flags. Converts to and from Eigen::Vector2d, but
/// containers do not convert: a std::span<const Vector2> takes a std::vector<Vector2>, not a
/// std::vector<Eigen::Vector2d>, whose elements a compiler may align.
using Vector2 = Eigen::Matrix<double, 2, 1, Eigen::DontAlign>;

static_assert(laidOut<Vector2, 16>());

}  // namespace poinsot::core
