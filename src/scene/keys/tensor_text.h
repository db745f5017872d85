// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <string_view>

#include "scene/document/document.h"

namespace poinsot::scene {

inline constexpr std::string_view kTensorLayout = "[[ixx, ixy, ixz], [ixy, iyy, iyz], [ixz, iyz, izz]]";

/// Returns advice for a tensor that is not written as three rows of three numbers, such as "; write [[...]]".
/// Recognises six or nine numbers in a row, a triangle, and the diagonal alone. Empty for any other value.
std::string layoutAdvice(const Node& given);

/// Returns advice for a matrix with a zero triangle, such as "; repeat ... write [[...]]"; otherwise empty.
/// @param rows  the matrix as three rows of three numbers
/// @param values  the nine numbers of the rows, row by row
std::string triangleAdvice(const Node& rows, std::span<const double> values);

/// Returns why no solid body can have these moments, such as "I3 must not exceed I1 + I2, got (0.1, 0.2, 0.9)
/// kg·m²; ...".
/// @pre they violate the triangle inequality
std::string triangleMessage(const Eigen::Vector3d& moments);

/// Returns the possible moments nearest to three moments that no solid body can have, as TOML in kg·m²; empty for
/// possible moments, and if there are none near them.
std::string nearestMomentsText(std::span<const double> moments);

/// Returns advice for three moments that no solid body can have: "; the nearest possible moments in kg·m² are
/// [...]". Empty if there are no possible moments near them.
std::string nearestMomentsAdvice(std::span<const double> moments);

/// Returns why no solid body can have a symmetric tensor, with the nearest possible tensor; empty for a possible
/// one.
std::string whyImpossible(const Eigen::Matrix3d& inertia);

/// Returns advice for a tensor that no solid body can have: "; the nearest possible tensor in kg·m² is [[...]]".
/// Empty if there is no possible tensor near it. Adds a remark if the tensor becomes possible when its products of
/// inertia change sign.
/// @pre symmetric
std::string nearestTensorAdvice(const Eigen::Matrix3d& inertia);

}  // namespace poinsot::scene
