// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <string_view>

#include "scene/document/document.h"

/// Advice for moments and tensors that are refused: what to write in the scene instead.
namespace poinsot::scene {

/// How the rows of a tensor are filled.
inline constexpr std::string_view kTensorLayout = "[[ixx, ixy, ixz], [ixy, iyy, iyz], [ixz, iyz, izz]]";

/// "; write [[...]]" with the numbers of a tensor in another layout: six or nine in a row, a triangle, the
/// diagonal alone. Empty for anything else.
std::string layoutAdvice(const Node& given);

/// "; repeat ... write [[...]]" for three rows of which one triangle is zero; empty for any other.
/// @param values those of the rows, one after another
std::string triangleAdvice(const Node& rows, std::span<const double> values);

/// "; the nearest possible moments in kg·m² are [...]" for three moments that no solid has; empty if there are
/// none.
std::string nearestMomentsAdvice(std::span<const double> moments);

/// "; the nearest possible tensor in kg·m² is [[...]]" for a tensor that no solid has, with a remark if the other
/// sign of its products of inertia makes it possible; empty if there is none. @pre symmetric
std::string nearestTensorAdvice(const Eigen::Matrix3d& inertia);

}  // namespace poinsot::scene
