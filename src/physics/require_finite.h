// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <Eigen/Core>
#include <cmath>
#include <string_view>

#include "core/error.h"

namespace poinsot::physics {

/// Throws if a number is not finite.
/// @param unit text after the value in the message, with a leading blank, such as " rad/s"
/// @throws core::Error(kPhysics) "NAME must be finite, got VALUE" if the value is not finite.
inline void requireFinite(double value, std::string_view name, std::string_view unit = "") {
  if (!std::isfinite(value))
    throw core::physicsError(fmt::format("{} must be finite, got {}{}", name, value, unit));
}

inline void requireFinite(const Eigen::Vector3d& v, std::string_view name, std::string_view unit = "") {
  if (!v.allFinite())
    throw core::physicsError(fmt::format("{} must be finite, got ({}, {}, {}){}", name, v[0], v[1], v[2], unit));
}

}  // namespace poinsot::physics
