// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "core/abi.h"
#include "scene/scene.h"

/// Matrices of a body: its inertia tensor about two points and along three sets of axes, and the matrices U that
/// turn components from one set of axes to another (eq 14 to 17).
namespace poinsot::scene {

/// Returns the words of the key note.matrix.
std::vector<std::string_view> bodyMatrixWords();

/// Returns the symbol of a matrix for a formula.
std::string_view bodyMatrixTex(const Body& body, BodyMatrix matrix);

/// Returns whether the elements of a matrix are moments of inertia, kg·m². The elements of U are numbers.
bool isTensor(BodyMatrix matrix);

/// Returns what the body lacks for a matrix, as the end of an error message; empty if the body has the matrix.
std::string lackFor(const Body& body, BodyMatrix matrix);

/// Returns a matrix of a body. The rows of U are the unit vectors of the other axes, along B.
/// @pre lackFor(body, matrix) is empty
Eigen::Matrix3d bodyMatrix(const Body& body, BodyMatrix matrix);

}  // namespace poinsot::scene
