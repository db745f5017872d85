// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/abi.h"
#include "core/vector2.h"

// Eigen types whose layout is the same in all files. Eigen aligns types of 16 and 32 bytes according to the vector
// unit for which a file is compiled. This would change the layout of all classes that contain such types. Vector3d
// (24 bytes) and Matrix3d (72 bytes) are never aligned.
namespace poinsot::physics {

/// Rotation without special alignment; converts from and to Eigen::Quaterniond.
using Quaternion = Eigen::Quaternion<double, Eigen::DontAlign>;

using core::Vector2;

static_assert(core::laidOut<Quaternion, 32>());
static_assert(core::laidOut<Eigen::Vector3d, 24>() && core::laidOut<Eigen::Matrix3d, 72>());

}  // namespace poinsot::physics
