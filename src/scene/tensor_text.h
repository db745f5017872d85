// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <string_view>

#include "scene/document.h"

/// What to write in a scene in place of moments and tensors that cannot be taken.
namespace poinsot::scene {

/// How the rows of a tensor are filled.
inline constexpr std::string_view kTensorLayout = "[[ixx, ixy, ixz], [ixy, iyy, iyz], [ixz, iyz, izz]]";

/// "; write [[...]]" with the numbers of a tensor in another layout: six or nine in a row, a triangle, the
/// diagonal alone. Empty for anything else.
std::string layoutAdvice(const Node& given);

/// "; repeat ... write [[...]]" for three rows of which one triangle is zero; empty for any other.
/// @param values those of the rows, one after another
std::string triangleAdvice(const Node& rows, std::span<const double> values);

/// "; the nearest possible moments are [...]" in kg·m², for three moments that no solid has; empty where there are
/// none.
std::string nearestMomentsAdvice(std::span<const double> moments);

/// The same of a tensor in kg·m², and whether its products of inertia have the other sign. @pre symmetric
std::string nearestTensorAdvice(const Eigen::Matrix3d& inertia);

}  // namespace poinsot::scene
