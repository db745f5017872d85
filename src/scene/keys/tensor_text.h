// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <string_view>

#include "scene/document/document.h"

namespace poinsot::scene {

inline constexpr std::string_view kTensorLayout = "[[ixx, ixy, ixz], [ixy, iyy, iyz], [ixz, iyz, izz]]";

/// Returns "; write [[...]]" for a tensor in another layout: six or nine numbers in a row, a triangle, or the
/// diagonal alone. Empty for anything else.
std::string layoutAdvice(const Node& given);

/// Returns "; repeat ... write [[...]]" for three rows of which one triangle is zero; else empty.
/// @param values  numbers of the rows, one row after another
std::string triangleAdvice(const Node& rows, std::span<const double> values);

/// Returns "; the nearest possible moments in kg·m² are [...]" for three moments that no solid has; empty if there
/// are none.
std::string nearestMomentsAdvice(std::span<const double> moments);

/// Returns "; the nearest possible tensor in kg·m² is [[...]]" for a tensor that no solid has; empty if there is
/// none. Adds a remark if the opposite sign of the products of inertia makes the tensor possible. @pre symmetric
std::string nearestTensorAdvice(const Eigen::Matrix3d& inertia);

}  // namespace poinsot::scene
