// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/abi.h"

// Eigen aligns types of 16 and 32 bytes by the vector unit that a file is compiled for, and so changes the layout
// of everything that holds them. Vector3d (24 bytes) and Matrix3d (72) are never aligned.
namespace poinsot::physics {

/// A rotation; Eigen::Quaterniond converts to it and from it.
using Quaternion = Eigen::Quaternion<double, Eigen::DontAlign>;

/// Two lengths; Eigen::Vector2d converts to it and from it.
using Vector2 = Eigen::Matrix<double, 2, 1, Eigen::DontAlign>;

static_assert(core::laidOut<Quaternion, 32>() && core::laidOut<Vector2, 16>());
static_assert(core::laidOut<Eigen::Vector3d, 24>() && core::laidOut<Eigen::Matrix3d, 72>());

}  // namespace poinsot::physics
