// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/abi.h"
#include "core/vector2.h"

// Eigen aligns types of 16 and 32 bytes by the vector unit that a file is compiled for, which changes the layout
// of all classes that hold them. Vector3d (24 bytes) and Matrix3d (72) are never aligned.
namespace poinsot::physics {

/// Unaligned rotation; Eigen::Quaterniond converts to it and from it.
using Quaternion = Eigen::Quaternion<double, Eigen::DontAlign>;

using core::Vector2;

static_assert(core::laidOut<Quaternion, 32>());
static_assert(core::laidOut<Eigen::Vector3d, 24>() && core::laidOut<Eigen::Matrix3d, 72>());

}  // namespace poinsot::physics
