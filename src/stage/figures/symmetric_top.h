// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/precession_cones.h"
#include "stage/picture_motion.h"

namespace poinsot::stage {

/// Returns whether two moments of the body are equal.
bool isSymmetric(const PictureMotion& motion);

/// Returns the steady precession of the picture's motion.
/// @param key  scene key to name in the error message
/// @throws core::Error(kScene) unless the motion is that of a free symmetric top.
physics::PrecessionCones precessionOf(const PictureMotion& motion, const char* key);

/// Returns the steady precession of the picture's motion, whose axes i, j, k exist.
/// @param key  scene key to name in the error message
/// @throws core::Error(kScene) unless the motion is that of a free symmetric top with L not along k.
physics::PrecessionCones triadOf(const PictureMotion& motion, const char* key);

/// Returns the lecture's axes i, j, k as columns, in V: k is the axis of symmetry, L and omega have no component
/// along j, and their component along i is positive.
/// @param cones  from triadOf()
Eigen::Matrix3d triad_V(const PictureState& state, const physics::PrecessionCones& cones);

/// Returns the axis k of the body, from which theta is measured, on the side of the spin. For a symmetric body, k
/// is the symmetry axis. For a cone on a table, k points from its apex to its base. Otherwise k is the principal
/// axis with the largest component of omega at the start.
Eigen::Vector3d mainAxis_P(const PictureMotion& motion);

}  // namespace poinsot::stage
