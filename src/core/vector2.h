// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "core/abi.h"

namespace poinsot::core {

/// Two numbers in one layout under all flags; Eigen::Vector2d converts to it and from it. Containers do not
/// convert: a std::span<const Vector2> takes a std::vector<Vector2>, not a std::vector<Eigen::Vector2d>, which a
/// compiler may align.
using Vector2 = Eigen::Matrix<double, 2, 1, Eigen::DontAlign>;

static_assert(laidOut<Vector2, 16>());

}  // namespace poinsot::core
